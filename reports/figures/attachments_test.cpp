#include "reports/figures/attachments.hpp"

#include "reports/figures/figures.hpp"
#include "reports/testing.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace touchstone::reports {
namespace {

namespace fs = std::filesystem;

TEST(Attachments, AreAllFiguresOfASiteAsPngEachNamedInALine) {
  const ScratchFolder site, attached;
  fs::create_directory(site / "poiseuille");
  const vnv::Record curves = sample_record();
  draw(plots_of_all({"poiseuille", {curves}}), site / "poiseuille");
  const fs::path image = attached / "all" / "poiseuille.profile.png";
  EXPECT_EQ(
      attach_figures(site.path(), attached / "all"),
      fmt::format("<CTestMeasurementFile name=\"poiseuille, profile\" type=\"image/png\">{}</CTestMeasurementFile>\n",
                  image.string()));
  EXPECT_TRUE(read_whole(image).starts_with("\x89PNG"));
  EXPECT_FALSE(fs::exists(site / "poiseuille" / "profile.png")) << "the site stays as it is";
}

}  // namespace
}  // namespace touchstone::reports
