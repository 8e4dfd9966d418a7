#include "vnv/files/tables.hpp"

#include "solvers/fields.hpp"
#include "vnv/files/data_folder.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <utility>

namespace touchstone::vnv {
namespace {

using Headings = std::vector<std::string>;

const std::string provenance =
    "# title: A front\n"
    "# citation: Somebody 1952\n"
    "# source: somebody else, by hand\n"
    "# scaling: T = t sqrt(g h0) / l0\n"
    "# geometry: column_height = 0.6 m; gravity = 9.81 m/s²; column_aspect = 1\n"
    "# uncertainty: L = 0.005; T.origin = 0.3\n";  // six lines: the headings stand on line 7
const std::string table = provenance + "T [-],L [-],series\n0.5,1.25,film\n1,1.5,gauge\n1.5,2,film\n";

std::filesystem::path folder() {
  const auto folder = std::filesystem::path(testing::TempDir()) / "tables";
  std::filesystem::create_directories(folder);
  return folder;
}

DataTable read_text(const std::string& text, const Headings& may_be_nan = {}) {
  const auto file = folder() / (testing::UnitTest::GetInstance()->current_test_info()->name() + std::string(".csv"));
  std::ofstream(file, std::ios::binary) << text;
  return read_table(file, may_be_nan);
}

/// What a refusal says after the name of the file; empty if there is none.
template <class Read>
std::string said_by(const Read& read) {
  try {
    read();
  } catch (const BadData& refusal) {
    const std::string words = refusal.what();
    return words.substr(words.find(".csv:") + 5);
  }
  return {};
}
std::string refusal(const std::string& text, const Headings& may_be_nan = {}) {
  return said_by([&] { read_text(text, may_be_nan); });
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  return text.replace(text.find(from), from.size(), to);
}

TEST(Tables, HoldWhatTheFileSays) {
  const auto read = read_text(table);
  EXPECT_EQ(read.rows(), 3);
  EXPECT_EQ(read.numbers("L [-]"), (std::vector{1.25, 1.5, 2.0}));
  EXPECT_EQ(read.words("series"), (Headings{"film", "gauge", "film"}));
  EXPECT_EQ(read.provenance().citation, "Somebody 1952");
  EXPECT_EQ(read.provenance().geometry.at("gravity").value, 9.81);
  EXPECT_EQ(read.provenance().geometry.at("gravity").unit, "m/s²");
  EXPECT_EQ(read.provenance().geometry.at("column_aspect").unit, "-");
  EXPECT_EQ(read.provenance().uncertainty.at("T.origin").value, 0.3);
}

TEST(ARefusal, GivesTheTerminalNoOrders) {
  EXPECT_EQ(refusal(replaced(table, "1.25", "1\x1b[2J.25")).find('\x1b'), std::string::npos);
  EXPECT_EQ(printable("two\nlines, \x1b[31m, \x7f and \u009b31m, of µ"), "two?lines, ?[31m, ? and ?31m, of µ");
  EXPECT_EQ(printable("cut short: \xc2"), "cut short: \xc2");
}

TEST(Tables, KeepNotesInTheirOrder) {
  EXPECT_EQ(read_text("# note: b\n# note: a: c\n" + table).provenance().notes, (Headings{"b", "a: c"}));
}

TEST(Tables, AcceptNoneForNoNumbers) {
  EXPECT_TRUE(read_text(replaced(table, "L = 0.005; T.origin = 0.3", "none")).provenance().uncertainty.empty());
}

TEST(Tables, GiveTheRowsOfOneSeries) {
  const auto film = read_text(table).only("series", "film");
  EXPECT_EQ(film.rows(), 2);
  EXPECT_EQ(film.numbers("T [-]"), (std::vector{0.5, 1.5}));
  EXPECT_EQ(film.words("series"), (Headings{"film", "film"}));
}

TEST(Tables, AcceptByteOrderMarkWindowsLinesBlankLinesAndNoLastNewline) {
  std::string windows = "\xEF\xBB\xBF";
  for (const char letter : table) windows += letter == '\n' ? "\r\n" : std::string(1, letter);
  EXPECT_EQ(read_text(windows).words("series"), read_text(table).words("series"));
  EXPECT_EQ(read_text(table + "\n \n").rows(), 3);
  EXPECT_EQ(read_text(table.substr(0, table.size() - 1)).words("series").back(), "film");
}

TEST(Tables, AcceptALineOfAnyLength) {
  const std::string note(17 << 20, 'n');
  EXPECT_EQ(read_text("# note: " + note + "\n" + table).provenance().notes, Headings{note});
}

TEST(Tables, AcceptQuotedCommasAndPaddedCells) {
  EXPECT_EQ(read_text(table + " 2 ,\t2.5, \"film, \"\"slow\"\"\"\n").words("series").back(), "film, \"slow\"");
}

TEST(Tables, ReadNumbersToTheLastDigit) {
  EXPECT_EQ(read_text(replaced(table, "1.25", "0.1000000000000000056")).numbers("L [-]")[0], 0.1);
  EXPECT_EQ(read_text(replaced(table, "1.25", "-1e-300")).numbers("L [-]")[0], -1e-300);
}

TEST(Tables, AcceptNanOnlyWhereItIsAllowed) {
  const auto text = replaced(table, "1.25", "nan");
  EXPECT_TRUE(std::isnan(read_text(text, {"L [-]"}).numbers("L [-]")[0]));
  EXPECT_EQ(refusal(text, {"T [-]"}), "8: not a number in 'L [-]'; found 'nan', expected a decimal number");
}

TEST(Tables, RefuseAMissingFile) {
  const auto read = [] { read_table(folder() / "absent.csv"); };
  EXPECT_EQ(said_by(read), " No such file or directory; expected a CSV file");
}

TEST(Tables, RefuseAFolder) {
  std::filesystem::create_directories(folder() / "folder.csv");
  const auto read = [] { read_table(folder() / "folder.csv"); };
  EXPECT_EQ(said_by(read), " found a folder, expected a CSV file");
}

TEST(Tables, RefuseAnEmptyFile) {
  EXPECT_EQ(refusal(""), " the file is empty; expected '# key: value' lines, headings and rows");
}

TEST(Tables, RefuseAFileThatIsNotText) {
  EXPECT_EQ(refusal(table + std::string("1\0,2,film\n", 10)), " found a zero byte, expected text in UTF-8");
}

TEST(Tables, RefuseProvenanceWithoutColumns) {
  EXPECT_EQ(refusal(provenance), " no columns; expected a line of headings below the '#' lines");
}

TEST(Tables, RefuseColumnsWithoutRows) {
  EXPECT_EQ(refusal(provenance + "T [-],L [-],series\n"), "7: no rows; found headings alone, expected rows below");
}

TEST(Tables, RefuseEachMissingKeyByName) {
  const Headings keys{"title", "citation", "source", "scaling", "geometry", "uncertainty"};
  for (const auto& key : keys) {
    const auto text = replaced(table, "# " + key, "# note: " + key);
    EXPECT_EQ(refusal(text).find("7: no line '# " + key + ": ...' above the columns; found"), 0) << refusal(text);
  }
}

TEST(Tables, RefuseUnknownAndRepeatedKeys) {
  EXPECT_EQ(refusal("# titel: x\n" + table),
            "1: unknown key; found 'titel', expected 'title', 'citation', 'source', 'scaling', 'geometry', "
            "'uncertainty'");
  EXPECT_EQ(refusal("# title: x\n" + table), "2: duplicate key; found 'title' on line 1 too, expected it once");
}

TEST(Tables, RefuseProvenanceThatIsNotKeyAndValue) {
  EXPECT_EQ(refusal("# a front\n" + table), "1: not a line of provenance; found '# a front', expected '# key: value'");
  EXPECT_EQ(refusal("#\n" + table), "1: not a line of provenance; found '#', expected '# key: value'");
  EXPECT_EQ(refusal("# title:\n" + table), "1: not a line of provenance; found '# title:', expected '# key: value'");
}

TEST(Tables, RefuseGeometryThatIsNotAQuantityInSi) {
  EXPECT_EQ(refusal(replaced(table, "0.6 m", "six m")),
            "5: geometry; found 'column_height = six m', expected 'name = number unit'");
  EXPECT_EQ(refusal(replaced(table, "; gravity = 9.81 m/s²", "; gravity")),
            "5: geometry; found 'gravity', expected 'name = number unit'");
  EXPECT_EQ(refusal(replaced(table, "gravity", "column_height")),
            "5: geometry; found 'column_height' twice, expected it once");
  EXPECT_EQ(
      refusal(replaced(table, "0.6 m", "60 cm")),
      "5: unit of column_height; found 'cm', expected '-', 'm', 's', 'm/s', 'm/s²', 'm²/s', 'kg/m³', 'Pa', 'Pa s'");
}

TEST(Tables, RefuseAMissingColumnAndListWhatIsThere) {
  const auto read = read_text(table);
  EXPECT_EQ(said_by([&] { read.numbers("x [m]"); }), " no column of numbers 'x [m]'; found 'L [-]', 'T [-]'");
}

TEST(Tables, RefuseAnotherUnitAndShowIt) {
  const auto read = read_text(replaced(table, "L [-]", "L [mm]"));
  EXPECT_EQ(said_by([&] { read.numbers("L [-]"); }), " no column of numbers 'L [-]'; found 'L [mm]'");
}

TEST(Sheets, RefuseHeadingsThatAreNotThoseExpected) {
  const auto refused = [](const Headings& expected) {
    return said_by([&] { require_headings(parse_sheet(folder() / "table.csv", table), expected); });
  };
  EXPECT_EQ(refused({"T [-]", "x [m]", "series"}), "7: no column 'x [m]'; found 'T [-]', 'L [-]', 'series'");
  EXPECT_EQ(refused({"T [-]", "L [-]"}), "7: unknown column; found 'series', expected 'T [-]', 'L [-]'");
  EXPECT_EQ(refused({"L [-]", "T [-]", "series"}),
            "7: columns out of order; found 'T [-]', 'L [-]', 'series', expected 'L [-]', 'T [-]', 'series'");
}

TEST(Tables, NameTheirExperimentAndWhichReadOutOfItIsTaken) {
  EXPECT_EQ(read_text(table).provenance().experiment, "");
  const auto read = read_text("# experiment: A & B 1990\n# read-out: film\n" + table);
  EXPECT_EQ(read.provenance().experiment, "A & B 1990");
  EXPECT_EQ(read.provenance().read_out, "film");
  EXPECT_EQ(refusal("# experiment: A\n# experiment: B\n" + table),
            "2: duplicate key; found 'experiment' on line 1 too, expected it once");
}

TEST(Experiments, AreTheTablesThatNameOne) {
  std::vector<std::string> found;
  for (const DataTable& one : read_experiments(data_folder() / "experiments"))
    found.push_back(one.file().stem().string() + ", " + one.provenance().experiment);
  EXPECT_EQ(found[0], "koshizuka_oka_1996_front, Koshizuka & Oka 1995");
  EXPECT_EQ(found.size(), 7u);
}

TEST(Tables, RefuseColumnsThatCannotBeToldApart) {
  EXPECT_EQ(refusal(replaced(table, "L [-]", "T [-]")),
            "7: no name of one column: 'T [-]'; found 'T [-]', 'T [-]', 'series', expected a name for each and none "
            "twice");
  EXPECT_EQ(refusal(replaced(table, "series", "")),
            "7: no name of one column: ''; found 'T [-]', 'L [-]', '', expected a name for each and none twice");
}

TEST(Tables, RefuseARowOfAnotherLength) {
  EXPECT_EQ(refusal(replaced(table, "1,1.5,gauge", "1,1.5")), "9: row too short; found 2, expected 3 cells");
  EXPECT_EQ(refusal(replaced(table, "1,1.5,gauge", "1,1.5,gauge,")), "9: row too long; found 4, expected 3 cells");
}

TEST(Tables, RefuseAFileThatEndsWithinARow) {
  const auto cut = table.substr(0, table.rfind(",film"));
  EXPECT_EQ(refusal(cut), "10: the file ends within this row; found 2, expected 3 cells");
}

TEST(Tables, RefuseTextWhereANumberIsWanted) {
  for (const std::string text : {"1.25m", "1..25", "", "-", "+1.25", "0x1p3", "1e999", "inf", "NaN", "1 25"})
    EXPECT_EQ(refusal(replaced(table, "1.25", text)),
              "8: not a number in 'L [-]'; found '" + text + "', expected a decimal number");
}

TEST(Tables, RefuseAnEmptyWord) {
  EXPECT_EQ(refusal(replaced(table, "gauge", "")), "9: empty cell in 'series'; expected a word");
}

TEST(Tables, RefuseAQuoteThatDoesNotClose) {
  EXPECT_EQ(refusal(replaced(table, "gauge", "\"gauge")),
            "9: a quote that does not close; found '\"gauge', expected a second '\"'");
}

TEST(Tables, RefuseColumnsAndSeriesThatAreNotThere) {
  const auto read = read_text(table);
  EXPECT_EQ(said_by([&] { read.numbers("series"); }), " no column of numbers 'series'; found 'L [-]', 'T [-]'");
  EXPECT_EQ(said_by([&] { read.words("L [-]"); }), " no column of words 'L [-]'; found 'series'");
  EXPECT_EQ(said_by([&] { read.only("series", "sonar"); }), " no row with series 'sonar'; found 'film', 'gauge'");
}

TEST(Tables, RefuseAnotherGeometry) {
  const auto read = read_text(table);
  EXPECT_NO_THROW(require_geometry(read, "column_height", 0.6, 1e-9));
  EXPECT_NO_THROW(require_geometry(read, "gravity", 9.8, 0.02));
  EXPECT_EQ(said_by([&] { require_geometry(read, "column_height", 0.3, 0.001); }),
            "5: another geometry, column_height; found 0.6 m, expected 0.3 ± 0.001 m");
  EXPECT_EQ(said_by([&] { require_geometry(read, "column_height", std::nan(""), 0.001); }),
            "5: another geometry, column_height; found 0.6 m, expected nan ± 0.001 m");
  EXPECT_EQ(said_by([&] { require_geometry(read, "tank_length", 1.61, 0.001); }),
            "5: no tank_length in the geometry; found 'column_aspect', 'column_height', 'gravity'");
}

// What follows asks the files of the project itself.

const std::filesystem::path data = data_folder();

DataTable read_any(const std::filesystem::path& file) {
  const auto sheet = read_sheet(file);
  return DataTable(sheet, sheet.headings.cells);
}

template <class Look>
void each_file(const Look& look) {
  for (const auto* shelf : {"experiments", "papers", "peers", "computed"})
    for (const auto& entry : std::filesystem::directory_iterator(data / shelf)) {
      SCOPED_TRACE(entry.path().string());
      if (entry.path().extension() == ".csv") look(read_any(entry.path()));
    }
}

bool has(const DataTable& read, const std::string& heading) {
  const auto headings = read_sheet(read.file()).headings.cells;
  return std::find(headings.begin(), headings.end(), heading) != headings.end();
}

std::vector<DataTable> series_of(const DataTable& read) {
  if (!has(read, "series")) return {read};
  std::vector<DataTable> parts;
  std::string last;
  for (const auto& name : read.words("series"))
    if (std::exchange(last, name) != name) parts.push_back(read.only("series", name));
  return parts;
}

/// Of L, for the rows of one series.
double uncertainty_of(const DataTable& part) {
  const auto& uncertainty = part.provenance().uncertainty;
  const auto own = has(part, "series") ? uncertainty.find("L." + part.words("series")[0]) : uncertainty.end();
  return own == uncertainty.end() ? uncertainty.at("L").value : own->second.value;
}

template <class Look>
void each_front(const Look& look) {
  each_file([&](const DataTable& read) {
    if (!has(read, "L [-]")) return;
    for (const auto& part : series_of(read)) look(part.numbers("T [-]"), part.numbers("L [-]"), uncertainty_of(part));
  });
}

/// Slope of the straight line through the points with T in [low, high].
double slope(const DataTable& read, double low, double high) {
  const Eigen::Map<const Scalars> T(read.numbers("T [-]").data(), static_cast<Eigen::Index>(read.rows()));
  const Eigen::Map<const Scalars> L(read.numbers("L [-]").data(), static_cast<Eigen::Index>(read.rows()));
  const Scalars chosen = (T >= low && T <= high).cast<double>();
  const Scalars from_mean = chosen * (T - (chosen * T).sum() / chosen.sum());
  return (from_mean * L).sum() / (from_mean * T).sum();
}

TEST(Data, NamesItsUncertaintiesByItsColumns) {
  each_file([](const DataTable& read) {
    for (const auto& [name, quantity] : read.provenance().uncertainty) {
      const auto column = name.substr(0, name.find('.'));
      EXPECT_TRUE(has(read, column + " [" + quantity.unit + "]")) << name;
      EXPECT_GT(quantity.value, 0) << name;
    }
  });
}

TEST(Data, HasTheAspectOfItsColumn) {
  each_file([](const DataTable& read) {
    const auto& geometry = read.provenance().geometry;
    if (!geometry.contains("column_height")) return;
    EXPECT_NEAR(geometry.at("column_height").value / geometry.at("column_length").value,
                geometry.at("column_aspect").value, 1e-12);
  });
}

TEST(Data, FrontsAdvance) {
  each_front([](const auto& T, const auto& L, double uncertainty) {
    EXPECT_NEAR(L.front(), 1, 0.25 + uncertainty);
    for (std::size_t i = 1; i < L.size(); ++i) {
      EXPECT_GT(T[i], T[i - 1]);
      EXPECT_GT(L[i] - L[i - 1], -2 * uncertainty) << "at T = " << T[i];
    }
  });
}

TEST(Data, FrontsStayBehindTheDryBedBoundOfRitter) {
  constexpr double ritter = 2;      // dL/dT
  constexpr double stretch = 0.25;  // T; a step of the tables is too short for their two decimals
  each_front([=](const auto& T, const auto& L, double uncertainty) {
    for (std::size_t i = 0; i < L.size(); ++i) {
      const auto j = static_cast<std::size_t>(std::upper_bound(T.begin(), T.end(), T[i] + stretch) - T.begin());
      if (j == L.size()) return;
      EXPECT_LT((L[j] - L[i] - 2 * uncertainty) / (T[j] - T[i]), ritter) << "from T = " << T[i];
    }
  });
}

TEST(Data, HeightsFall) {
  for (const auto* name : {"square", "tall"}) {
    const auto read = read_any(data / "experiments" / (std::string("martin_moyce_1952_height_") + name + ".csv"));
    const auto& eta = read.numbers("eta [-]");
    EXPECT_TRUE(std::is_sorted(eta.rbegin(), eta.rend())) << name;
    EXPECT_LE(eta.front(), 1) << name;
    EXPECT_GT(eta.back(), 0) << name;
    for (std::size_t i = 0; i < read.rows(); ++i)  // fast time for a tall column: n² = height / length
      EXPECT_NEAR(std::pow(read.numbers("T [-]")[i], 2),
                  read.provenance().geometry.at("column_aspect").value * std::pow(read.numbers("tau [-]")[i], 2), 1e-4);
  }
}

TEST(Data, LobovskysFrontsRunAtTheSpeedsTheirAuthorsGive) {
  const auto full = read_any(data / "experiments/lobovsky_2014_front_600.csv");
  EXPECT_NEAR(slope(full, 1, 1.58), 1.34, 0.01);
  const auto half = read_any(data / "experiments/lobovsky_2014_front_300.csv");
  EXPECT_NEAR(slope(half, 0.5, 0.79), 1.38, 0.01);   // T_H in [1, 1.58]: X_H / T_H = (2 L) / (2 T)
  EXPECT_NEAR(slope(half, 0.79, 1.21), 1.64, 0.01);  // T_H in [1.58, 2.42]
}

TEST(Data, LobovskysTimesAreFramesOfHisCamera) {
  constexpr double rate = 300;  // 1/s
  for (const auto* name : {"lobovsky_2014_front_600.csv", "lobovsky_2014_front_300.csv"}) {
    const auto t = read_any(data / "experiments" / name).numbers("t [s]");
    for (const double later : t) {
      const double frames = rate * (later - t[0]);
      EXPECT_NEAR(frames, std::round(frames), 0.025) << name;
    }
  }
}

TEST(Data, LobovskysPlacesAndTimesAreThoseOfSun) {
  for (const auto* name : {"lobovsky_2014_front_600.csv", "lobovsky_2014_front_300.csv"}) {
    const auto read = read_any(data / "experiments" / name);
    const auto& geometry = read.provenance().geometry;
    const double l0 = geometry.at("column_length").value;
    const double shallow_speed = std::sqrt(geometry.at("gravity").value * geometry.at("column_height").value);
    for (std::size_t i = 0; i < read.rows(); ++i) {
      EXPECT_NEAR(l0 * read.numbers("T [-]")[i], shallow_speed * read.numbers("t [s]")[i], 1e-9) << name;
      EXPECT_NEAR(l0 * read.numbers("L [-]")[i], l0 + read.numbers("x_gate [m]")[i], 1e-9) << name;
    }
  }
}

TEST(Data, LobovskysFrontIsAtTheWallWhereItSaysSo) {
  const auto read = read_any(data / "experiments/lobovsky_2014_front_600.csv");
  const auto& geometry = read.provenance().geometry;
  const double wall = geometry.at("tank_length").value / geometry.at("column_length").value;
  for (std::size_t i = 0; i < read.rows(); ++i)
    EXPECT_EQ(read.numbers("at_wall [-]")[i], read.numbers("L [-]")[i] > wall - 0.01) << "row " << i;
  EXPECT_EQ(read.numbers("at_wall [-]").back(), 1);
}

TEST(Data, LobovskysLevelsAndPressuresAreSampledAtTheirRates) {
  for (const auto& [name, rate] : {std::pair{"levels", 300.0}, {"pressure_event", 20e3}, {"pressure_band", 20e3}}) {
    const auto read = read_any(data / "experiments" / fmt::format("lobovsky_2014_{}_300.csv", name));
    const auto& geometry = read.provenance().geometry;
    const double per_sample = std::sqrt(geometry.at("gravity").value / geometry.at("column_height").value) / rate;
    const auto& T = read.numbers("T_H [-]");
    for (std::size_t i = 1; i < T.size(); ++i) {
      const double samples = (T[i] - T[i - 1]) / per_sample;
      EXPECT_NEAR(samples, std::round(samples), 0.05) << name << " at T_H = " << T[i];
      EXPECT_GE(samples, 0.95) << name << " at T_H = " << T[i];
    }
  }
}

TEST(Data, LobovskysPercentilesAreInOrderAndHoldTheEvent) {
  const auto band = read_any(data / "experiments/lobovsky_2014_pressure_band_300.csv");
  for (std::size_t i = 0; i < band.rows(); ++i) {
    EXPECT_LE(band.numbers("p2_5 [-]")[i], band.numbers("median [-]")[i]) << "row " << i;
    EXPECT_LE(band.numbers("median [-]")[i], band.numbers("p97_5 [-]")[i]) << "row " << i;
  }
  const auto peaks = read_any(data / "experiments/lobovsky_2014_peaks_300.csv");
  const auto event = read_any(data / "experiments/lobovsky_2014_pressure_event_300.csv");
  const auto& geometry = peaks.provenance().geometry;
  const double rho_g_h =  // mbar
      geometry.at("density").value * geometry.at("gravity").value * geometry.at("column_height").value / 100;
  for (std::size_t i = 0; i < peaks.rows(); ++i) {
    const auto& p = event.numbers(peaks.words("sensor")[i] + " [-]");
    const double peak = rho_g_h * *std::max_element(p.begin(), p.end());
    EXPECT_GT(peak, peaks.numbers("p2_5 [mbar]")[i]) << peaks.words("sensor")[i];
    EXPECT_LT(peak, peaks.numbers("p97_5 [mbar]")[i]) << peaks.words("sensor")[i];
  }
}

TEST(Data, LobovskysGaugesAreWetWhenTheFrontHasPassed) {
  const auto levels = read_any(data / "experiments/lobovsky_2014_levels_300.csv");
  const auto tip = read_any(data / "experiments/lobovsky_2014_front_300.csv");
  const auto& X = tip.numbers("X_H [-]");
  for (const std::string gauge : {"H2", "H3", "H4"}) {
    const double place = (levels.provenance().geometry.at(gauge + "_place").value - 0.6) / 0.3;
    const auto passed = static_cast<std::size_t>(std::upper_bound(X.begin(), X.end(), place) - X.begin());
    for (const auto* run : {"_run_1 [-]", "_run_2 [-]"}) {
      const auto& h = levels.numbers(gauge + run);
      const auto wet = std::find_if(h.begin(), h.end(), [](double level) { return level > 0; }) - h.begin();
      const double late = levels.numbers("T_H [-]")[static_cast<std::size_t>(wet)] - tip.numbers("T_H [-]")[passed];
      EXPECT_GT(late, -0.03) << gauge << run;  // a frame is 0.019
      EXPECT_LT(late, 0.06) << gauge << run;
    }
  }
}

TEST(Data, ZhousAreScaledAsTheySay) {
  const auto levels = read_any(data / "experiments/zhou_1999_levels.csv");
  const auto pressure = read_any(data / "experiments/zhou_1999_pressure.csv");
  for (const DataTable* read : {&levels, &pressure})
    for (std::size_t i = 0; i < read->rows(); ++i)
      EXPECT_NEAR(read->numbers("T_H [-]")[i], (read->numbers("t [s]")[i] - 3.337) * std::sqrt(9.8 / 0.6), 1e-3);
  for (std::size_t i = 0; i < pressure.rows(); ++i)
    EXPECT_NEAR(pressure.numbers("P2 [-]")[i], pressure.numbers("p [Pa]")[i] / (1000 * 9.8 * 0.6), 1e-5);
}

TEST(Data, EachInputOfLobovskyIsKnownToAHalfWidthWithAReason) {
  for (const char* file : {"lobovsky_2014_inputs_300.csv", "lobovsky_2014_inputs_600.csv"}) {
    const auto inputs = read_any(data / "experiments" / file);
    for (std::size_t i = 0; i < inputs.rows(); ++i) {
      EXPECT_GT(inputs.numbers("half_width [SI]")[i], 0) << inputs.words("input")[i];
      EXPECT_TRUE(inputs.words("distribution")[i] == "rectangular" || inputs.words("distribution")[i] == "normal");
      EXPECT_GT(inputs.words("basis")[i].size(), 20) << inputs.words("input")[i];
    }
  }
}

TEST(Data, SunsParticlesFillTheChannel) {
  const auto read = read_any(data / "papers/sun_tables_3_4.csv");
  const auto& geometry = read.provenance().geometry;
  const double area = geometry.at("gap").value * geometry.at("channel_length").value;
  for (std::size_t i = 0; i < read.rows(); ++i)
    EXPECT_NEAR(read.numbers("particles [-]")[i] * std::pow(read.numbers("spacing [mm]")[i] * mm, 2), area,
                1e-3 * area);
}

TEST(Data, SunsErrorsShrinkAndCostsGrowWithMoreParticles) {
  const auto read = read_any(data / "papers/sun_tables_3_4.csv");
  for (const auto* flow : {"poiseuille", "couette"})
    for (const auto* method : {"MPM", "SPH"}) {
      const auto ladder = read.only("flow", flow).only("method", method);
      ASSERT_EQ(ladder.rows(), 4);
      for (const auto* error : {"L2 [%]", "Linf [%]"})
        EXPECT_TRUE(std::is_sorted(ladder.numbers(error).rbegin(), ladder.numbers(error).rend())) << flow << method;
      for (const auto* cost : {"T_p [ms]", "memory [MB]", "particles [-]"})
        EXPECT_TRUE(std::is_sorted(ladder.numbers(cost).begin(), ladder.numbers(cost).end())) << flow << method;
    }
}

TEST(Data, IsComplete) {
  const std::map<std::string, std::size_t> rows{{"experiments/lobovsky_2014_front_600.csv", 111},
                                                {"experiments/lobovsky_2014_front_300.csv", 117},
                                                {"experiments/lobovsky_2014_levels_300.csv", 590},
                                                {"experiments/lobovsky_2014_pressure_event_300.csv", 2344},
                                                {"experiments/lobovsky_2014_pressure_band_300.csv", 2344},
                                                {"experiments/lobovsky_2014_peaks_300.csv", 4},
                                                {"experiments/lobovsky_2014_statistics.csv", 9},
                                                {"experiments/lobovsky_2014_inputs_300.csv", 9},
                                                {"experiments/lobovsky_2014_inputs_600.csv", 6},
                                                {"experiments/zhou_1999_levels.csv", 232},
                                                {"experiments/zhou_1999_pressure.csv", 261},
                                                {"experiments/buchner_2002_pressure.csv", 279},
                                                {"experiments/botia_vera_2010_lateral_peaks.csv", 4},
                                                {"experiments/martin_moyce_1952_front_square.csv", 30},
                                                {"experiments/martin_moyce_1952_front_tall.csv", 44},
                                                {"experiments/martin_moyce_1952_front_tall_small.csv", 16},
                                                {"experiments/martin_moyce_1952_height_square.csv", 9},
                                                {"experiments/martin_moyce_1952_height_tall.csv", 16},
                                                {"experiments/koshizuka_oka_1996_front.csv", 18},
                                                {"papers/koshizuka_oka_1996_computations.csv", 35},
                                                {"papers/sun_tables_3_4.csv", 16},
                                                {"papers/ghia_1982_vertical_centreline.csv", 119},
                                                {"papers/ghia_1982_horizontal_centreline.csv", 119},
                                                {"papers/marchi_2009_cavity_profiles.csv", 15},
                                                {"papers/cavity_extrema.csv", 18},
                                                {"computed/cavity_profiles.csv", 324},
                                                {"computed/cavity_extrema.csv", 12},
                                                {"computed/cavity_finite_differences.csv", 261},
                                                {"peers/poiseuille_run_time.csv", 3}};
  for (const auto& [name, count] : rows) EXPECT_EQ(read_any(data / name).rows(), count) << name;
}

}  // namespace
}  // namespace touchstone::vnv
