#include "reports/figures/figures.hpp"

#include "reports/testing.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace touchstone::reports {
namespace {

namespace fs = std::filesystem;

long count(const std::string& text, const std::string& part) {
  long found = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

Plot profile_of(const std::vector<vnv::Record>& records) {
  return plot_curves(records.front().figures.front(), {"poiseuille", records});
}

vnv::Record cloud_record() {
  vnv::Record record = sample_record();
  record.figures[0].colour.label = "p [Pa]";
  record.figures[0].equal_axes = true;
  record.curves.clear();
  for (const char* row : {"t = 0 s", "t = 1 s"})
    record.clouds.push_back({"profile", "MPM", row, {0, 1, 2}, {0, 1, 0}, {1, 2, 3}});
  return record;
}

/// The only figure of records, which it leaves in a folder.
Plot drawn(const CaseRecords& records, const fs::path& folder) {
  const Plots plots = plots_of_all(records);
  draw(plots, folder);
  return plots.front().second;
}

TEST(Curves, OfEqualLabelAreDrawnOnce) {
  const Plot plot = profile_of({sample_record("mpm"), sample_record("sph")});
  EXPECT_EQ(count(plot.script, "title 'exact'"), 1);
  EXPECT_EQ(count(plot.data, "\nexact,"), 3);
  EXPECT_EQ(count(plot.script, "title 'sph'"), 1);
}

std::string colour_before(const std::string& title, const std::string& script) {
  return script.substr(script.rfind("rgb '", script.find(title)), 13);
}

TEST(Curves, OfTwoMethodsDifferInColour) {
  const std::string script = profile_of({sample_record("mpm"), sample_record("sph")}).script;
  EXPECT_NE(colour_before("title 'mpm'", script), colour_before("title 'sph'", script));
  EXPECT_EQ(colour_before("title 'exact'", script), "rgb '#000000'");
}

TEST(Curves, ThatArePublishedAreGreyWhereMethodsHaveAllColours) {
  std::vector<vnv::Record> records;
  for (const char* method : {"a", "b", "c", "d", "e"}) records.push_back(sample_record(method));
  vnv::Curve published = records.front().curves.front();
  published.label = "Ghia";
  published.role = vnv::Role::published;
  records.front().curves.push_back(published);
  EXPECT_EQ(colour_before("title 'Ghia'", profile_of(records).script), "rgb '#E69F00'");
  records.push_back(sample_record("f"));
  EXPECT_EQ(colour_before("title 'Ghia'", profile_of(records).script), "rgb '#5A5A5A'");
}

TEST(Curves, OfPointsThatCoincideAreSeenInTurnAndThatStandApartAlways) {
  std::vector<vnv::Record> records{sample_record("mpm"), sample_record("sph")};
  for (vnv::Record& record : records) record.curves[0].points = true;
  records[1].curves[0].y[2] = 0.0005;
  const Plot plot = profile_of(records);
  EXPECT_TRUE(contains(plot.script, "2:('101'[int($0)+1:int($0)+1] eq '1' ? $3 : NaN)")) << plot.script;
  EXPECT_TRUE(contains(plot.script, "2:('011'[int($0)+1:int($0)+1] eq '1' ? $3 : NaN)")) << plot.script;
  EXPECT_EQ(plot.covered, 2);
  EXPECT_TRUE(contains(plot.data, "\nsph,0,0\n")) << "what is not drawn is still there";
  const ScratchFolder folder;
  EXPECT_EQ(drawn({"poiseuille", records}, folder.path()).covered, 2);
}

TEST(Curves, OfPointsOfOneMethodAreAllDrawn) {
  vnv::Record record = sample_record();
  record.curves[0].points = true;
  record.curves[0].x = {0, 0, 0};
  EXPECT_TRUE(contains(profile_of({record}).script, "every ::0::2 using 2:3 with points"));
}

TEST(Curves, AreWrittenInTheUnitOfTheAxis) {
  const Plot plot = profile_of({sample_record()});
  EXPECT_TRUE(plot.data.starts_with("curve,y [mm],v_x [mm/s]\n")) << plot.data;
  EXPECT_TRUE(contains(plot.data, "\nmpm,0.5,1\n")) << plot.data;
}

TEST(Curves, SayHowManyPointsNoAxisCanShow) {
  vnv::Record record = sample_record();
  record.curves[0].y[1] = vnv::not_a_number;
  EXPECT_EQ(profile_of({record}).undrawn, 1);
  record.figures[0].y.logarithmic = true;
  EXPECT_EQ(profile_of({record}).undrawn, 5);  // and the four zeros of both curves
}

TEST(Curves, ReachTheDataOfTheirOwn) {
  const std::string script = profile_of({sample_record()}).script;
  EXPECT_TRUE(contains(script, "every ::0::2 using 2:3")) << script;
  EXPECT_TRUE(contains(script, "every ::3::5 using 2:3")) << script;
}

TEST(Labels, BecomeNoCommands) {
  EXPECT_EQ(gnuplot_string("it's\n`rm`"), "'it''s `rm`'");
  vnv::Record record = sample_record();
  record.curves[0].label = "mpm' with lines; system 'touch owned";
  const ScratchFolder folder;
  drawn({"poiseuille", {record}}, folder.path());
  EXPECT_FALSE(fs::exists(folder / "owned"));
}

TEST(Labels, OfAxesThatAreLongerThanTheseGoOnInASecondLine) {
  vnv::Record record = sample_record();
  record.figures[0].y.label = "RMS error of L for T in [1, 1.5], without time shift, front as 99.5th percentile [-]";
  const ScratchFolder folder;
  EXPECT_TRUE(contains(profile_of({record}).script,
                       "set ylabel 'RMS error of L for T in [1, 1.5],' . \"\\n\" . 'without time shift, front as"));
  EXPECT_TRUE(fs::exists(folder / drawn({"poiseuille", {record}}, folder.path()).image));
}

TEST(Labels, OfAxesShowSymbolsAndKeepOtherUnderscores) {
  EXPECT_EQ(gnuplot_label("v_x [mm/s]"), "{/:Italic v}_{x} [mm/s]");
  EXPECT_EQ(gnuplot_label("10^-3 of mpm_reset"), "10^{−3} of mpm\\_reset");
}

TEST(Key, HasNoMoreColumnsThanFitBesideEachOther) {  // gnuplot makes one of twenty letters 205 px wide, of 800
  vnv::Record record = sample_record();
  record.curves.clear();
  for (int i = 0; i < 12; ++i) record.curves.push_back(sample_curve(fmt::format("{:020}", i)));
  EXPECT_TRUE(contains(profile_of({record}).script, "maxrows 4"));
}

TEST(Figure, SameRecordsGiveTheSameBytes) {
  const ScratchFolder first, second;
  const vnv::Record record = sample_record(), cloud = cloud_record();
  for (const auto* folder : {&first, &second}) {
    drawn({"poiseuille", {record}}, folder->path());
    drawn({"poiseuille", {cloud}}, folder->path());
  }
  for (const char* name : {"profile.svg", "profile.png", "profile.gp", "profile.csv"}) {
    EXPECT_FALSE(read_whole(first / name).empty()) << name;
    EXPECT_EQ(read_whole(first / name), read_whole(second / name)) << name;
  }
}

TEST(Figure, IsRedrawnByItsScript) {
  const ScratchFolder folder;
  const vnv::Record record = sample_record();
  drawn({"poiseuille", {record}}, folder.path());
  const std::string drawn = read_whole(folder / "profile.svg");
  fs::remove(folder / "profile.svg");
  ASSERT_EQ(std::system(("cd " + folder.path().string() + " && gnuplot profile.gp").c_str()), 0);
  EXPECT_EQ(read_whole(folder / "profile.svg"), drawn);
}

TEST(Figure, OfNothingFiniteIsStillDrawnAndSaysSo) {
  const ScratchFolder folder;
  vnv::Record record = sample_record();
  record.curves.resize(1);
  std::fill(record.curves[0].y.begin(), record.curves[0].y.end(), vnv::not_a_number);
  EXPECT_EQ(drawn({"poiseuille", {record}}, folder.path()).undrawn, 3);
  EXPECT_TRUE(contains(read_whole(folder / "profile.svg"), "no finite value"));
}

TEST(Figure, OfOnePointIsDrawn) {
  const ScratchFolder folder;
  vnv::Record record = sample_record();
  for (const bool logarithmic : {false, true}) {
    record.curves = {sample_curve("mpm")};
    record.curves[0].x = record.curves[0].y = {1e-3};
    record.figures[0].y.logarithmic = logarithmic;
    EXPECT_NO_THROW(drawn({"poiseuille", {record}}, folder.path()));
  }
}

TEST(Clouds, StandInRowsUnderOneBar) {
  const vnv::Record record = cloud_record();
  const Plot plot = plot_clouds(record.figures[0], {"poiseuille", {record}});
  EXPECT_EQ(plot.image, "profile.png");
  EXPECT_EQ(count(plot.script, "\nplot "), 2);
  EXPECT_EQ(count(plot.script, "\nset colorbox"), 1);
  EXPECT_EQ(count(plot.script, "unset colorbox"), 1);
}

TEST(Clouds, AreWrittenInTheUnitsOfTheirAxes) {
  vnv::Record record = cloud_record();
  record.figures[0].y.scale = 10;
  record.figures[0].colour.scale = 0.5;
  const Plot plot = plot_clouds(record.figures[0], {"poiseuille", {record}});
  EXPECT_TRUE(contains(plot.data, "\n\"MPM, t = 0 s\",1000,10,1\n")) << plot.data;
}

TEST(Clouds, OfEqualPlaceAreDrawnOnce) {
  const vnv::Record record = cloud_record();
  const Plot plot = plot_clouds(record.figures[0], {"poiseuille", {record, record}});
  EXPECT_EQ(count(plot.script, "\nplot "), 2);
  EXPECT_EQ(count(plot.data, "\n"), 7);
}

TEST(Clouds, HaveIsolinesBehindTheirParticlesInTheData) {
  const ScratchFolder folder;
  vnv::Record record = cloud_record();
  record.figures[0].isolines = 4;
  for (vnv::Cloud& cloud : record.clouds) {
    cloud.x.clear(), cloud.y.clear(), cloud.colour.clear();
    for (int p = 0; p < 400; ++p)
      cloud.x.push_back(p % 20), cloud.y.push_back(p / 20), cloud.colour.push_back(0.5 * (p % 20));
  }
  const Plot plot = plot_clouds(record.figures[0], {"poiseuille", {record}});
  EXPECT_EQ(count(plot.script, "with vectors nohead"), 2);
  EXPECT_TRUE(contains(plot.script, "every ::800::")) << "after 400 particles of each panel";
  EXPECT_TRUE(contains(plot.data, ",8,16")) << plot.data.substr(plot.data.size() - 200);
  EXPECT_EQ(drawn({"poiseuille", {record}}, folder.path()).undrawn, 0);
}

TEST(Clouds, WithParticlesThatAreNotANumberAreDrawn) {
  const ScratchFolder folder;
  vnv::Record record = cloud_record();
  record.clouds[1].x = record.clouds[1].y = record.clouds[1].colour = std::vector(3, vnv::not_a_number);
  EXPECT_EQ(drawn({"poiseuille", {record}}, folder.path()).undrawn, 3);
}

}  // namespace
}  // namespace touchstone::reports
