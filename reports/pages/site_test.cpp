#include "reports/pages/site.hpp"

#include "reports/figures/gnuplot.hpp"
#include "reports/pages/pages.hpp"
#include "reports/testing.hpp"
#include "reports/text/html.hpp"
#include "vnv/programs/interruption.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <set>
#include <stdexcept>

namespace touchstone::reports {
namespace {

namespace fs = std::filesystem;

class Site : public testing::Test {
 protected:
  Site() {
    fs::create_directory(records);
    put(sample_record());
  }
  void put(const vnv::Record& record) const { vnv::write(record, records / (record.method + ".json")); }
  std::string page(const std::string& name) const { return read_whole(site / name); }
  /// That of the only case, with this record.
  std::string page_with(const vnv::Record& record) const {
    put(record);
    make_site(records, site);
    return page("poiseuille/index.html");
  }
  long entries() const { return std::distance(fs::directory_iterator(folder.path()), fs::directory_iterator()); }

  ScratchFolder folder;
  const fs::path records = folder / "records", site = folder / "site";
};

TEST_F(Site, HasAnIndexAPagePerCaseAndTheTables) {
  make_site(records, site);
  for (const char* name : {"index.html", "verdicts.html", "a_verdict_fails.html", "style.css", "site.js",
                           "verdicts.csv", "orders.csv", "cost.csv", "poiseuille/index.html", "poiseuille/profile.svg",
                           "poiseuille/profile.gp", "poiseuille/profile.csv"})
    EXPECT_FALSE(page(name).empty()) << name;
  EXPECT_TRUE(contains(page("index.html"), "href=\"poiseuille/index.html\""));
  EXPECT_EQ(entries(), 2) << "something is left beside the site";
}

TEST_F(Site, StaysAsItWasWhereItsMakerIsToldToEnd) {
  make_site(records, site);
  const std::string before = page("index.html");
  put(sample_record("sph"));
  const programs::HeldSignals held;
  raise(SIGTERM);
  EXPECT_THROW(make_site(records, site), programs::Interrupted);
  EXPECT_EQ(page("index.html"), before);
  EXPECT_EQ(entries(), 2) << "something is left beside the site";
}

TEST_F(Site, SaysFirstWhatFails) {
  vnv::Record record = sample_record();
  record.verdicts.push_back(sample_verdict(vnv::Outcome::fails, -0.3));
  put(record);
  make_site(records, site);
  for (const char* name : {"index.html", "poiseuille/index.html"}) {
    EXPECT_TRUE(contains(page(name), "1 of 2 claims holds, 1 fails.")) << name;
    EXPECT_TRUE(contains(page(name), "<p class=\"sum fails\">")) << name;
    EXPECT_LT(page(name).find("the sentence of this verdict"), page(name).find("<table>")) << name;
  }
}

TEST_F(Site, TellsAMethodThatTheoryOrLiteratureCallsRightFromOneThatIsAsWrongAsAccepted) {
  vnv::Record agrees = sample_record("mpm"), accepted = sample_record("sph");
  agrees.verdicts[0].kind = vnv::Kind::norm;
  accepted.verdicts[0].method = "sph";
  accepted.verdicts[0].author = "baseline: as measured";
  accepted.values = {{"S1", 1e-3, 0.5, {"L2 v_x", "%", vnv::Kind::norm}, 51.42}};
  put(agrees);
  put(accepted);
  make_site(records, site);
  const std::string html = page("index.html");
  EXPECT_TRUE(contains(
      html,
      "2 of 2 claims hold. Literature set the limits of 1; 1 says no more than that values are as last accepted."));
  EXPECT_TRUE(contains(html, "<td class=\"holds words\">agrees <small>literature</small></td>")) << html;
  EXPECT_TRUE(contains(html, "<td class=\"accepted words\">as last accepted, <b>wrong by 51\u202f%</b></td>")) << html;
  EXPECT_TRUE(contains(html, "<li class=\"holds\"><b>1 converge or agree</b>"));
  EXPECT_TRUE(contains(html, "<li class=\"accepted\"><b>1 as last accepted</b>"));
  EXPECT_TRUE(contains(html, "<img src=\"poiseuille/profile.svg\"")) << "of the case";
  EXPECT_TRUE(contains(page("verdicts.html"), "<td class=\"accepted\">as accepted</td>"));
}

TEST_F(Site, FoldsAllButTenFailures) {
  vnv::Record record = sample_record();
  record.verdicts.assign(10, sample_verdict(vnv::Outcome::fails, -0.3));
  put(record);
  make_site(records, site);
  EXPECT_FALSE(contains(page("index.html"), "<details>"));
  record.verdicts.assign(12, sample_verdict(vnv::Outcome::fails, -0.3));
  put(record);
  make_site(records, site);
  EXPECT_TRUE(contains(page("index.html"), "</ul>\n<details>\n<summary>2 more</summary>\n<ul class=\"fails\">\n<li>"));
}

TEST_F(Site, CallsEachVerdictWhatItIs) {
  vnv::Record record = sample_record();
  record.verdicts.push_back(sample_verdict(vnv::Outcome::fails, -0.3));
  record.verdicts.push_back(sample_verdict(vnv::Outcome::inconclusive, 0));
  const std::string html = page_with(record);
  EXPECT_TRUE(contains(html, "<td class=\"holds\">holds</td>"));
  for (const char* word : {"fails", "inconclusive"}) {
    const auto cell = [&](const char* root) {
      return fmt::format("<td class=\"{0}\"><a href=\"{1}a_verdict_fails.html\">{0}</a></td>", word, root);
    };
    EXPECT_TRUE(contains(html, cell("../"))) << word;
    EXPECT_TRUE(contains(page("verdicts.html"), cell(""))) << word;
  }
  EXPECT_TRUE(contains(page("a_verdict_fails.html"), "vnv explain"));
}

TEST_F(Site, DoesNotCallACaseWithoutClaimsGood) {
  vnv::Record record = sample_record();
  record.verdicts.clear();
  put(record);
  make_site(records, site);
  EXPECT_TRUE(contains(page("index.html"), "Nothing is claimed."));
  EXPECT_FALSE(contains(page("index.html"), "class=\"sum holds\""));
}

TEST_F(Site, SaysThatARunDidNotFinish) {
  vnv::Record record = sample_record();
  vnv::RunSummary run;
  run.level = "S4";
  run.outcome = "diverged at step 7";
  record.runs = {run};
  EXPECT_TRUE(contains(page_with(record), "S4 did not finish: diverged at step 7"));
}

TEST_F(Site, FoldsManyRunsThatWereMadeToSeeWhetherTheyDiverge) {
  vnv::Record record = sample_record();
  for (int k = 0; k < 11; ++k) record.runs.push_back({.level = fmt::format("W{}", k), .outcome = "diverged"});
  EXPECT_TRUE(contains(page_with(record), "<summary>11 runs that were made to see whether they diverge"));
  record.runs.resize(10);
  EXPECT_FALSE(contains(page_with(record), "<summary>"));
}

TEST_F(Site, ColoursARunThatDivergedOnlyWhereAClaimOnItFails) {
  vnv::Record record = sample_record();
  record.runs = {{.level = "M2", .outcome = "diverged at step 7"}};
  record.curves[0].y[1] = vnv::not_a_number;
  std::string html = page_with(record);
  EXPECT_FALSE(contains(html, "<ul class=\"fails\">"));
  EXPECT_TRUE(contains(html, "<span class=\"quiet\">1 point not drawn"));
  record.verdicts = {sample_verdict(vnv::Outcome::fails, -1)};
  html = page_with(record);
  EXPECT_TRUE(contains(html, "<ul class=\"fails\">\n<li>mpm M2 did not finish"));
  EXPECT_TRUE(contains(html, "<span class=\"nan\">1 point not drawn"));
}

TEST_F(Site, CallsAFigureWithoutDataAFaultOnlyWhereSomethingFails) {
  vnv::Record record = sample_record();
  record.curves.clear();
  EXPECT_TRUE(contains(page_with(record), "<p class=\"quiet\">Nothing was run that the figure “Profiles” shows.</p>"));
  record.verdicts = {sample_verdict(vnv::Outcome::fails, -1)};
  EXPECT_TRUE(contains(page_with(record), "<p class=\"nan\">Nothing was run that the figure “Profiles” shows.</p>"));
}

TEST_F(Site, ListsTheClaimsOfAllCases) {
  vnv::Record other = sample_record("sph");
  other.case_name = "couette";
  put(other);
  make_site(records, site);
  for (const char* name : {"couette", "poiseuille"})
    EXPECT_TRUE(contains(page("verdicts.html"), fmt::format("<b><a href=\"{0}/index.html\">{0}</a>.</b>", name)))
        << name;
}

TEST_F(Site, SaysWhereEachLadderLeads) {
  vnv::Record record = sample_record();
  vnv::ObservedOrder order;
  order.ladder = "grid";
  order.quantity = "L2 v_x [%]";
  order.order = 0.41;
  order.half_width = 0.2;
  order.trend = vnv::Trend::stalled;
  order.floor = 0.023;
  order.floor_half_width = 0.001;
  order.order_to_floor = 1.97;
  order.order_to_floor_half_width = 0.1;
  record.orders = {order};
  const std::string html = page_with(record);
  for (const char* words : {"stalled", "not asymptotic", "0.023", "1.97"}) EXPECT_TRUE(contains(html, words)) << words;
}

TEST_F(Site, HasAMatrixOfOrdersLinkedToAndFro) {
  vnv::Record record = sample_record();
  record.orders = {sample_order()};
  put(record);
  make_site(records, site);
  const std::string figure = "order_L2_v_x_at_1_s";
  EXPECT_TRUE(contains(page("poiseuille/index.html"), "href=\"../orders.html\""));
  EXPECT_TRUE(contains(page("orders.html"), "href=\"index.html\""));
  EXPECT_TRUE(contains(page("orders.html"), "href=\"poiseuille/index.html#" + figure + "\""));
  EXPECT_TRUE(contains(page("poiseuille/index.html"), "id=\"" + figure + "\""));
  for (const char* kind : {".svg", ".gp", ".csv"}) EXPECT_FALSE(page("poiseuille/" + figure + kind).empty()) << kind;
}

TEST_F(Site, WithoutOrdersHasNoMatrixOfThem) {
  make_site(records, site);
  EXPECT_FALSE(contains(page("poiseuille/index.html"), "orders.html"));
}

/// With an error and its cost.
vnv::Record priced(const std::string& method) {
  vnv::Record record = sample_record(method);
  record.diagrams = {{"work", "Work", "", {"L2 v_x", "%"}, {1, 0.1, 0.01, 0.001}, 1}};
  record.work = {{.diagram = "work", .series = method, .run = "M1", .error = 1, .cpu = 2}};
  return record;
}

TEST_F(Site, SaysWhichMethodIsCheapestToEachErrorAndByHowMuch) {
  vnv::Record mpm = priced("mpm"), sph = priced("sph");
  mpm.as_printed = true;
  sph.work[0].cpu = 6;
  sph.work.push_back({.diagram = "work", .series = "sph", .run = "M2", .error = 0.1, .cpu = 50});
  put(mpm);
  put(sph);
  make_site(records, site);
  const std::string html = page("work.html");
  for (const char* words : {"<b>mpm</b>", "sph ×\u202f3", "<b>sph</b>", "mpm not reached", "none; sph 0.1",
                            "2 CPU s to 1\u202f%, the next, sph, 3 times as much"})
    EXPECT_TRUE(contains(html, words)) << words << html;
  EXPECT_TRUE(contains(page("index.html"), "<a href=\"poiseuille/index.html#work\"><img src=\"poiseuille/work.svg\""));
  EXPECT_FALSE(page("poiseuille/work.svg").empty());
  EXPECT_TRUE(contains(page("work.csv"), "\npoiseuille,L2 v_x [%],0.1,1,sph,no,50,0.1\n")) << page("work.csv");
}

TEST_F(Site, ShowsEqualRowsOfATableOnce) {
  const vnv::Table table{"norms", "Norms", "", {"level", "L2 [%]"}, {{std::string("paper M1"), 3.34}}};
  for (const char* method : {"mpm", "sph"}) {
    vnv::Record record = sample_record(method);
    record.tables = {table};
    put(record);
  }
  make_site(records, site);
  const std::string html = page("poiseuille/index.html");
  EXPECT_NE(html.find("paper M1"), std::string::npos);
  EXPECT_EQ(html.find("paper M1"), html.rfind("paper M1"));
}

TEST_F(Site, IsRedWhereARecordContradictsItself) {
  EXPECT_TRUE(make_site(records, site).passes());
  vnv::Record record = sample_record();
  record.verdicts[0].value = 1.6;  // beyond its limit, and said to hold
  put(record);
  EXPECT_FALSE(make_site(records, site).passes());
  EXPECT_TRUE(contains(page("index.html"), "<p class=\"sum fails\">0 of 1 claim hold, 1 fails."));
  EXPECT_TRUE(contains(page("index.html"), "poiseuille.mpm M2: inconsistent record: "));
}

TEST_F(Site, IsRedWithFewerClaimsThanAcceptedAndNotGreenWithoutAny) {
  fs::create_directory(folder / "claims");
  const auto accept = [&](int literature) {
    vnv::write_accepted_claims(folder / "claims" / "poiseuille.csv",
                               {{"t", "r", "d", "why"}, {{"poiseuille", "mpm", "", 0, literature, 0}}});
  };
  accept(1);
  EXPECT_TRUE(make_site(records, site, {.claims = folder / "claims"}).passes());
  accept(2);
  const NightStatus status = make_site(records, site, {.claims = folder / "claims"});
  EXPECT_FALSE(status.passes());
  EXPECT_TRUE(contains(status.sentence(), "1 red: ")) << status.sentence();
  EXPECT_TRUE(contains(page("index.html"), "<p class=\"sum fails\">"));
  EXPECT_TRUE(contains(page("index.html"), "1 claim fewer than accepted: poiseuille.mpm (1 of 2 literature)"));
  vnv::Record record = sample_record();
  record.verdicts = {};
  put(record);
  EXPECT_FALSE(make_site(records, site).passes());
  record.verdicts = {sample_verdict(vnv::Outcome::inconclusive, 0)};
  put(record);
  EXPECT_FALSE(make_site(records, site).passes());
}

TEST_F(Site, EscapesWhatARecordSays) {
  vnv::Record record = sample_record();
  record.title = record.description = record.method_description = "<script>alert(1)</script>";
  record.curves[0].label = "<script>";
  put(record);
  make_site(records, site);
  for (const char* name : {"index.html", "poiseuille/index.html", "poiseuille/profile.svg"})
    EXPECT_FALSE(contains(page(name), "<script>")) << name;
}

TEST_F(Site, IsReplacedWhole) {
  make_site(records, site);
  std::ofstream(site / "of_an_earlier_case.html") << "old";
  make_site(records, site);
  EXPECT_FALSE(fs::exists(site / "of_an_earlier_case.html"));
  EXPECT_TRUE(fs::exists(site / "index.html"));
  EXPECT_EQ(entries(), 2);
}

TEST_F(Site, RemovesWhatOthersLeftThatWereKilled) {
  const fs::path of_none = folder / ".site.999999999.part", of_one_that_runs = folder / ".site.1.part";
  fs::create_directories(of_none / "poiseuille");
  fs::create_directory(of_one_that_runs);
  make_site(records, site);
  EXPECT_FALSE(fs::exists(of_none));
  EXPECT_TRUE(fs::exists(of_one_that_runs));
}

TEST_F(Site, StaysAsItWasIfAFigureCannotBeDrawn) {
  make_site(records, site);
  const std::string former = page("index.html");
  vnv::Record record = sample_record();
  record.title = "Another";
  put(record);
  std::ofstream(folder / "gnuplot") << "#!/bin/sh\necho 'no terminal' >&2\nexit 1\n";
  fs::permissions(folder / "gnuplot", fs::perms::owner_all);
  const Environment path("PATH", folder.path().c_str());
  EXPECT_THROW(make_site(records, site), std::runtime_error);
  EXPECT_EQ(page("index.html"), former);
  EXPECT_EQ(entries(), 3);
}

TEST_F(Site, WithoutGnuplotIsTheTables) {
  const Environment path("PATH", "");
  EXPECT_THROW(make_site(records, site), GnuplotMissing);
  for (const char* table : {"verdicts.csv", "orders.csv", "cost.csv"}) EXPECT_FALSE(page(table).empty()) << table;
  EXPECT_FALSE(fs::exists(site / "index.html"));
}

TEST_F(Site, DoesNotReplaceAFolderThatIsNone) {
  fs::create_directory(site);
  std::ofstream(site / "thesis.tex") << "years of work";
  EXPECT_THROW(make_site(records, site), std::runtime_error);
  EXPECT_EQ(page("thesis.tex"), "years of work");
}

TEST_F(Site, DoesNotReplaceTheFolderOfItsRecords) {
  make_site(records, site);
  fs::rename(records, site / "records");
  EXPECT_THROW(make_site(site / "records", site), std::runtime_error);
  EXPECT_TRUE(fs::exists(site / "records" / "mpm.json"));
}

TEST_F(Site, WithAHistoryHasATrendOverItsNights) {
  vnv::Record record = sample_record();
  record.suite = "nightly";
  for (const char* day : {"21", "22"}) {
    record.finished_at = fmt::format("2026-11-{}T04:00:00Z", day);
    record.revision = fmt::format("revision{}", day);
    record.verdicts[0].value *= 1.05;
    put(record);
    make_site(records, site, {.history = folder / "nights"});
  }
  std::ofstream(folder / "nights" / "torn.jsonl") << "{\"night\":1,";
  make_site(records, site, {.history = folder / "nights"});
  for (const char* words : {"2 nights, 2026-11-21 to 2026-11-22: the last one changed 1 value.", "revision22",
                            "torn.jsonl:1: not a complete JSON line", "data-values=\"1.575,1.654\""})
    EXPECT_TRUE(contains(page("trend.html"), words)) << words;
  EXPECT_TRUE(contains(page("trend_steps.csv"), "2026-11-22T04:00:00Z,revision22,poiseuille,mpm,M2"));
}

TEST_F(Site, TellsWhatChangedWithTheMachineAlone) {
  vnv::Record record = sample_record();
  record.suite = "nightly";
  record.revision = "same";
  record.runs = {sample_run("M2", 3)};
  for (const char* machine : {"a", "b"}) {
    record.machine = machine;
    record.finished_at = fmt::format("2026-11-21T04:00:0{}Z", machine[0] - 'a');
    record.verdicts[0].value *= 1.05;
    put(record);
    make_site(records, site, {.history = folder / "nights"});
  }
  EXPECT_TRUE(contains(page("trend.html"), "this value depends on the machine: a before, now b"));
}

TEST_F(Site, DoesNotReplaceTheFolderOfItsNights) {
  EXPECT_THROW(make_site(records, site, {.history = site / "nights"}), std::runtime_error);
}

TEST_F(Site, WithTrialsOfFaultsHasAPageOfThem) {
  std::ofstream(folder / "trials.csv") << sample_fault_keys() + fault_table(sample_fault_rows());
  make_site(records, site, {.faults = folder / "trials.csv"});
  EXPECT_TRUE(contains(page("index.html"), "<a href=\"faults.html\">Detection rate</a>. 4 of 6 seeded faults"));
  EXPECT_TRUE(contains(page("faults.html"), "href=\"index.html\""));
  EXPECT_TRUE(contains(page("faults.html"), "href=\"faults.csv\""));
  EXPECT_EQ(page("faults.csv"), read_whole(folder / "trials.csv"));
}

TEST_F(Site, HasEachPageThatHasSomethingToShowTitledAndLinkedFromTheIndex) {
  const auto written = [this](const SiteInputs& inputs) {
    make_site(records, site, inputs);
    std::set<std::string> names;
    for (const auto& [name, shown] : all_pages()) {
      const std::string file = name + ".html";
      const std::string link =
          fmt::format("<p>{}: <a href=\"{}\">{}</a>.", escape(shown.sentence), file, escape(shown.title));
      EXPECT_EQ(contains(page("index.html"), link), fs::exists(site / file)) << link;
      if (!fs::exists(site / file)) continue;
      for (const char* tag : {"title", "h1"})
        EXPECT_TRUE(contains(page(file), fmt::format("<{0}>{1}</{0}>", tag, escape(shown.title)))) << name;
      EXPECT_FALSE(shown.title.empty() || shown.sentence.empty()) << name;
      names.insert(name);
    }
    return names;
  };
  const auto few = written({});
  vnv::Record record = priced("mpm");
  record.orders = {sample_order()};
  record.suite = "nightly";
  record.finished_at = "2026-11-21T04:00:00Z";
  put(record);
  std::ofstream(folder / "trials.csv") << sample_fault_keys() + fault_table(sample_fault_rows());
  const auto all = written({.history = folder / "nights", .faults = folder / "trials.csv"});
  for (const char* name : {"faults", "orders", "trend", "work"})
    EXPECT_TRUE(all.contains(name) && !few.contains(name)) << name;
}

TEST_F(Site, WhereNothingCanBeWrittenIsRefused) {
  std::ofstream(folder / "file") << "";
  EXPECT_THROW(make_site(records, folder / "file" / "site"), std::runtime_error);
}

}  // namespace
}  // namespace touchstone::reports
