#include "vnv/flows/lid_driven.hpp"

#include "reference/lid_driven_cavity.hpp"
#include "vnv/files/data_folder.hpp"
#include "vnv/files/tables.hpp"

#include <gtest/gtest.h>

namespace touchstone::vnv::lid_driven {
namespace lid_driven_test {

constexpr std::array both{Centreline::vertical, Centreline::horizontal};

std::string column(Centreline::Direction direction) { return direction == Centreline::vertical ? "u" : "v"; }

/// How far apart numbers of a table are from the converged profiles, at most.
double distance(const DataTable& table, Centreline::Direction direction, int Re) {
  const DataTable rows = table.only("Re", std::to_string(Re));
  const ConvergedProfile profile(data_folder(), direction, Re);
  double largest = 0;
  for (std::size_t k = 0; k < rows.rows(); ++k)
    largest =
        std::max(largest, std::abs(rows.numbers(column(direction) + " [-]")[k] - profile(rows.numbers("s [-]")[k])));
  return largest;
}
double uncertainty_of(const DataTable& table, const std::string& name) {
  return table.provenance().uncertainty.at(name).value;
}

TEST(ConvergedCavity, IsWhatIsComputedHere) {
  constexpr double of_degree_40 = 1e-5;
  const reference::LidDrivenCavity flow(100, 40);
  const ConvergedProfile u(data_folder(), Centreline::vertical, 100), v(data_folder(), Centreline::horizontal, 100);
  for (double at = 0.01; at < 1; at += 0.02) {
    EXPECT_NEAR(u(at), flow.u(0.5, at), of_degree_40) << at;
    EXPECT_NEAR(v(at), flow.v(at, 0.5), of_degree_40) << at;
  }
}

TEST(ConvergedCavity, IsKnownWellBelowAnyLimit) {
  for (const int Re : {100, 400, 1000, 3200})
    for (const auto direction : both)
      EXPECT_LT(ConvergedProfile(data_folder(), direction, Re).half_width(), Re == 3200 ? 1e-4 : 1e-5) << Re;
}

TEST(ConvergedCavity, KeepsToItsWalls) {
  for (const int Re : {100, 400, 1000, 3200})
    for (const auto direction : both) {
      const ConvergedProfile profile(data_folder(), direction, Re);
      EXPECT_NEAR(profile(0), 0, profile.half_width());
      EXPECT_NEAR(profile(1), direction == Centreline::vertical ? 1 : 0, profile.half_width());
    }
}

/// As much as flows one way flows back: the trapezia of many places.
TEST(ConvergedCavity, LetsNothingThroughACentrelineInAll) {
  for (const int Re : {100, 400, 1000, 3200})
    for (const auto direction : both) {
      const ConvergedProfile profile(data_folder(), direction, Re);
      constexpr int parts = 10000;
      double net = (profile(0) + profile(1)) / 2;
      for (int k = 1; k < parts; ++k) net += profile(1.0 * k / parts);
      EXPECT_NEAR(net / parts, 0, 1e-6 + profile.half_width()) << Re << column(direction);
    }
}

/// Two computations that share neither discretisation nor program.
TEST(ConvergedCavity, AgreesWithExtrapolatedFiniteDifferences) {
  const DataTable other = read_table(data_folder() / "computed/cavity_finite_differences.csv");
  for (const int Re : {100, 400, 1000})
    for (const auto direction : both) {
      const double known = ConvergedProfile(data_folder(), direction, Re).half_width() +
                           uncertainty_of(other, fmt::format("{}.{}", column(direction), Re));
      EXPECT_LT(distance(other, direction, Re), known) << Re << column(direction);
      EXPECT_LT(distance(other, direction, Re), 1e-4) << Re << column(direction);
    }
}

TEST(ConvergedCavity, AgreesWithMarchiSueroAndAraki) {
  const DataTable published = read_table(data_folder() / "papers/marchi_2009_cavity_profiles.csv");
  for (const auto direction : both)
    EXPECT_LT(distance(published, direction, 100), ConvergedProfile(data_folder(), direction, 100).half_width() +
                                                       uncertainty_of(published, column(direction)))
        << column(direction);
}

TEST(ConvergedCavity, HasTheExtremaThatWerePublished) {
  const DataTable published = read_table(data_folder() / "papers/cavity_extrema.csv");
  for (const Extremum& which : extrema())
    for (const int Re : {100, 1000}) {
      const Peak ours = converged_peak(data_folder(), which, Re);
      const auto of = [&](const char* series) {
        const DataTable row =
            published.only("Re", std::to_string(Re)).only("quantity", which.name).only("series", series);
        return Peak{row.numbers("value [-]").front(), row.numbers("at [-]").front()};
      };
      const Peak spectral = of("Botella & Peyret 1998"), volumes = of("Marchi, Suero & Araki 2009");
      EXPECT_NEAR(ours.velocity, spectral.velocity, 3e-7) << which.name << Re;
      EXPECT_NEAR(ours.at, spectral.at, 1e-4) << which.name << Re;
      EXPECT_NEAR(ours.velocity, volumes.velocity, 2.2e-5) << which.name << Re;
      EXPECT_NEAR(ours.at, volumes.at, 5e-4) << which.name << Re;
    }
}

/// The tables of profiles and of extrema are of one flow, which the measure reads.
TEST(ConvergedCavity, HasItsExtremaOnItsProfiles) {
  for (const int Re : {100, 400, 1000, 3200})
    for (const Extremum& which : extrema()) {
      const Peak exact = converged_peak(data_folder(), which, Re),
                 read = peak_of(ConvergedProfile(data_folder(), which.direction, Re), which);
      EXPECT_NEAR(read.velocity, exact.velocity, Re == 3200 ? 2e-4 : 2e-5) << which.name << Re;
      EXPECT_NEAR(read.at, exact.at, 2e-4) << which.name << Re;
    }
}

/// Ghia, Ghia & Shin are quoted by everybody, and are no exact solution: an error of half a per cent may be theirs.
TEST(TablesOfGhia, AreOffTheConvergedFlowByWhatTheirDataFileSays) {
  const auto off = [](Centreline::Direction direction, int Re) {
    const ConvergedProfile profile(data_folder(), direction, Re);
    const Centreline line = ghia_centreline(data_folder(), direction, Re);
    double sum = 0;
    for (std::size_t k = 0; k < line.at.size(); ++k) sum += std::pow(line.velocity[k] - profile(line.at[k]), 2);
    return 100 * std::sqrt(sum / static_cast<double>(line.at.size()));
  };
  EXPECT_NEAR(off(Centreline::vertical, 100), 0.254, 0.002);
  EXPECT_NEAR(off(Centreline::horizontal, 100), 0.509, 0.002);
  EXPECT_NEAR(off(Centreline::vertical, 400), 0.141, 0.002);
  EXPECT_NEAR(off(Centreline::horizontal, 400), 0.326, 0.002) << "without the misprint";
  EXPECT_NEAR(off(Centreline::vertical, 1000), 0.371, 0.002);
  EXPECT_NEAR(off(Centreline::horizontal, 1000), 0.998, 0.002);
  EXPECT_NEAR(off(Centreline::vertical, 3200), 1.530, 0.005) << "without the misprint";
  EXPECT_NEAR(off(Centreline::horizontal, 3200), 2.132, 0.005);
}

}  // namespace lid_driven_test
}  // namespace touchstone::vnv::lid_driven
