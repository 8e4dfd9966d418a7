#include "vnv/command/catalogue.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>

namespace touchstone::vnv::command {
namespace {

using testing::HasSubstr;

/// One case is built, with a method, and one is not.
Catalogue half_built() {
  Catalogue catalogue{.cases = {{}}, .not_built = {"dam_break"}};
  catalogue.cases.front().name = "couette";
  catalogue.cases.front().methods.resize(1);
  catalogue.cases.front().methods.front().name = "mpm_affine";
  return catalogue;
}

std::string complaint_of(const std::string& pattern) {
  const Catalogue catalogue = half_built();
  try {
    choose_all(catalogue, {pattern}, "");
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(CatalogueWithoutAllPrograms, NamesACaseThatIsNotBuilt) {
  for (const char* pattern : {"dam_break", "dam_break.mpm", "dam_*", "break", "affine", "*.mpm_affine"})
    EXPECT_THAT(complaint_of(pattern), HasSubstr("not built: dam_break")) << pattern;
}

TEST(CatalogueWithoutAllPrograms, SaysThatNoCaseHasAMisspeltName) {
  for (const char* pattern : {"dam_brek", "dam_brek.mpm", "cuette*"})
    EXPECT_THAT(complaint_of(pattern), HasSubstr("no case fits '" + std::string(pattern) + "'")) << pattern;
}

}  // namespace
}  // namespace touchstone::vnv::command
