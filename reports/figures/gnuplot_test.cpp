#include "reports/figures/gnuplot.hpp"

#include "reports/testing.hpp"

#include <gtest/gtest.h>

namespace touchstone::reports {
namespace {

namespace fs = std::filesystem;

class GnuplotScript : public testing::Test {
 protected:
  void put(const std::string& commands) const {
    std::ofstream(folder / "a.gp") << "set terminal svg\nset output image\n" << commands;
  }
  std::string refusal(int longest = 60) const {
    try {
      run_gnuplot(folder / "a.svg", longest);
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "drawn";
  }
  bool nothing_but_the_script_is_left() const {
    return std::distance(fs::directory_iterator(folder.path()), fs::directory_iterator()) == 1;
  }
  ScratchFolder folder;
};

TEST_F(GnuplotScript, DrawsAndLeavesNothingElse) {
  put("plot x\n");
  ASSERT_EQ(refusal(), "drawn");
  EXPECT_TRUE(contains(read_whole(folder / "a.svg"), "</svg>"));
  EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), fs::directory_iterator()), 2);
}

TEST_F(GnuplotScript, WithABadCommandIsRefusedInGnuplotsWords) {
  put("plot x\nplot undefined_name\n");
  EXPECT_TRUE(contains(refusal(), "line 4: undefined variable: undefined_name")) << refusal();
  EXPECT_EQ(refusal().find('\n'), std::string::npos);
  EXPECT_TRUE(nothing_but_the_script_is_left());
}

TEST_F(GnuplotScript, ThatDrawsNothingIsRefused) {
  put("");
  EXPECT_TRUE(contains(refusal(), "not whole")) << refusal();
  EXPECT_TRUE(nothing_but_the_script_is_left());
}

TEST_F(GnuplotScript, ThatEndsEarlyIsRefused) {
  put("plot x\nexit gnuplot\n");
  EXPECT_NE(refusal(), "drawn");
  EXPECT_TRUE(nothing_but_the_script_is_left());
}

TEST_F(GnuplotScript, ThatFailsLeavesTheFormerImage) {
  std::ofstream(folder / "a.svg") << "former";
  put("plot undefined_name\n");
  EXPECT_NE(refusal(), "drawn");
  EXPECT_EQ(read_whole(folder / "a.svg"), "former");
}

TEST_F(GnuplotScript, DrawsInAFolderWithAnUnusualName) {
  const fs::path unusual = folder / "it's $(here) & there";
  fs::create_directory(unusual);
  std::ofstream(unusual / "a.gp") << "set terminal svg\nset output image\nplot x\n";
  run_gnuplot(unusual / "a.svg");
  EXPECT_TRUE(fs::exists(unusual / "a.svg"));
}

TEST_F(GnuplotScript, ThatHangsIsEnded) {
  put("plot x\npause 30\n");
  EXPECT_TRUE(contains(refusal(1), "longer than 1 s")) << refusal(1);
  EXPECT_TRUE(nothing_but_the_script_is_left());
}

TEST_F(GnuplotScript, WithoutGnuplotSaysWhatToInstall) {
  put("plot x\n");
  const Environment no_path("PATH", "");
  EXPECT_THROW(run_gnuplot(folder / "a.svg"), GnuplotMissing);
  EXPECT_TRUE(contains(refusal(), "gnuplot: not found") && contains(refusal(), "apt install gnuplot")) << refusal();
}

TEST_F(GnuplotScript, ThatIsNoGnuplotIsRefused) {
  put("plot x\n");
  std::ofstream(folder / "gnuplot") << "#!/bin/sh\nexit 0\n";
  fs::permissions(folder / "gnuplot", fs::perms::owner_all);
  const Environment path("PATH", (folder.path().string() + ":" + std::getenv("PATH")).c_str());
  EXPECT_TRUE(contains(refusal(), "ended early")) << refusal();
}

}  // namespace
}  // namespace touchstone::reports
