#include "reference/dam_front.hpp"

#include "reference/calculus.hpp"

#include <gtest/gtest.h>

namespace touchstone::reference {
namespace {

constexpr RitterFront dam{.g = 9.8, .h0 = 0.6, .l0 = 0.6};  // Sun et al., section 3.3

TEST(RitterFront, StartsAtTheGate) { EXPECT_EQ(dam(0), dam.l0); }

TEST(RitterFront, RunsTwoLengthsPerUnitOfTime) {  // in L = x / l0 and T = t sqrt(g h0) / l0, whatever the column
  for (const RitterFront& any : {dam, RitterFront{9.81, 0.3, 0.6}, RitterFront{1.6, 2, 0.1}}) {
    const double unit = any.l0 / std::sqrt(any.g * any.h0);
    EXPECT_NEAR(slope([=](double T) { return any(T * unit) / any.l0; }, 1, 0.1), 2, 1e-9);
  }
}

TEST(RitterFront, RefusesWhatIsNotADamAndTimesOutsideIt) {
  EXPECT_THROW((RitterFront{0, 1, 1})(0), std::domain_error);
  EXPECT_THROW((RitterFront{9.8, -1, 1})(0), std::domain_error);
  EXPECT_THROW((RitterFront{9.8, 1, std::nan("")})(0), std::domain_error);
  for (const double t : {-1.0, std::nan("")}) EXPECT_THROW(dam(t), std::domain_error) << t;
  EXPECT_NO_THROW(dam(100));
}

}  // namespace
}  // namespace touchstone::reference
