#include <gtest/gtest.h>

#include "vnv/doors/read/parts/gzip.hpp"
#include "vnv/doors/read/testing.hpp"

namespace touchstone::vnv::doors {
namespace lammps_test {

std::vector<Dataset> read(const std::string& name) { return read_datasets(samples() / "lammps" / name); }

TEST(LammpsDumps, GiveEachFrameToTheLastDigit) {
  for (const char* name : {"custom.lammpstrj", "custom.lammpstrj.gz", "times.lammpstrj", "unwrapped.lammpstrj"}) {
    const std::vector<Dataset> frames = read(name);
    ASSERT_EQ(frames.size(), 2u);
    for (const char column : {'x', 'y'}) EXPECT_EQ(frames[0].array({column})->values, five(column)) << name;
    EXPECT_EQ(frames[0].array("vx")->values, five('u')) << name;
    EXPECT_EQ(frames[1].array("vy")->values, five('v')) << name;
    EXPECT_EQ(frames[1].index, 2);
  }
  const std::vector<Dataset> scaled = read("scaled.lammpstrj");
  for (std::size_t k = 0; k < 5; ++k) {
    EXPECT_NEAR(scaled[0].array("x")->values[k], five('x')[k], 1e-15);
    EXPECT_NEAR(scaled[0].array("y")->values[k], five('y')[k], 1e-15);
    EXPECT_NEAR(scaled[0].array("z")->values[k], 0, 1e-15);
  }
}

using Point = std::pair<double, double>;

TEST(LammpsDumps, GivePlacesScaledOrUnwrappedByTheBoxOfTheirFrame) {
  const auto places = [](const std::string& columns, const std::string& row) {
    const std::vector<Dataset> frames = read_as(
        "lammps", "a",
        "ITEM: TIMESTEP\n1\nITEM: NUMBER OF ATOMS\n1\nITEM: BOX BOUNDS pp pp ff\n-1 3\n10 20\n-2 2\nITEM: ATOMS id " +
            columns + "\n1 " + row + "\n",
        {});
    return Point(frames[0].array("x")->values[0], frames[0].array("y")->values[0]);
  };
  EXPECT_EQ(places("x y z", "0.25 0.5 0"), Point(0.25, 0.5));
  EXPECT_EQ(places("xs ys zs", "0.25 0.5 0"), Point(0, 15));
  EXPECT_EQ(places("xu yu zu", "7 -3 0"), Point(7, -3));
  EXPECT_EQ(places("xsu ysu zsu", "1.25 -0.5 0"), Point(4, 5)) << "beyond a period";
  EXPECT_EQ(places("xs ys xu yu", "0.25 0.5 7 -3"), Point(7, -3)) << "as they are, where both are there";
  EXPECT_EQ(places("xsu ysu xs ys x y", "0 0 0 0 1 2"), Point(1, 2));
}

TEST(LammpsDumps, GiveTimesUnitsAndElementsWhereTheyAreThere) {
  EXPECT_EQ(read("custom.lammpstrj")[1].time, std::nullopt);
  const Dataset frame = read("times.lammpstrj").at(1);
  EXPECT_EQ(frame.time, 0.25);
  EXPECT_EQ(frame.format, "LAMMPS dump, units lj");
  EXPECT_EQ(frame.array("element")->labels, (std::vector<std::string>{"Ar", "Ne"}));
  EXPECT_EQ(frame.array("element")->values, (std::vector<double>{0, 0, 0, 0, 1}));
}

TEST(LammpsDumps, AreRefusedInOneLine) {
  const std::string good = files::read_whole(samples() / "lammps/times.lammpstrj");
  const auto refusal_of = [](const std::string& bytes, const Limits& limits = {}) {
    return refusal([&] { read_as("lammps", "a", bytes, limits); });
  };
  EXPECT_EQ(refusal_of(good), "");
  EXPECT_EQ(refusal_of(files::read_whole(samples() / "lammps/triclinic.lammpstrj")),
            "a:5: a box that is tilted, expected one along the axes");
  for (const auto& [from, to, message] : std::vector<std::tuple<std::string, std::string, std::string>>{
           {"ATOMS\n5", "ATOMS\n6", "a:19: id: number 1 'ITEM:', expected a number"},
           {"ATOMS\n5", "ATOMS\n4",
            "a:18: '5 2 Ne 0.40000000000000002 0.20000000000', expected 'ITEM: ' and what follows"},
           {"ATOMS\n5", "ATOMS\n-5", "a:8: NUMBER OF ATOMS: '-5', expected a whole number from 0"},
           {"ATOMS\n5", "ATOMS\n99999999", "a:13: ends within its atoms, expected 99999999"},
           {"ATOMS\n5", "ATOMS\n9999999999999999999",
            "a:13: ATOMS: '9999999999999999999' rows of 7 numbers, expected no more than 17179869184 bytes of numbers "
            "in a file"},
           {"0.5 0.3", "0.5 none", "a:15: vx: number 1 'none3333333333333331', expected a number"},
           {"Ar 0 1 0 0", "Ar 0 1 0 0 7", "a:14: more cells than columns, expected 7"},
           {"TIME\n0", "TIME\ninf", "a:4: 'inf', expected a time"},
           {"pp ff pp\n-1.0", "pp ff pp\n-x.0",
            "a:10: a bound of the box: number 1 '-x.0000000000000000e+00', expected a number"},
           {"ITEM: BOX", "ITEM: FOX", "a:9: item 'FOX BOUNDS pp ff pp', expected those of a dump of atoms"},
           {"id type", "x type", "a: array 'x' twice, expected each name once"}})
    EXPECT_EQ(refusal_of(with(good, from, to)), message) << to;
  EXPECT_EQ(refusal_of(good.substr(0, good.size() - 60)), "a:34: y: number 1 '', expected a number");
}

TEST(Gzip, IsRefusedInOneLineWhereItIsBrokenOrTooLarge) {
  const std::string good = files::read_whole(samples() / "lammps/custom.lammpstrj.gz"),
                    text = files::read_whole(samples() / "lammps/custom.lammpstrj");
  EXPECT_EQ(gunzipped("a", good, {}), text);
  EXPECT_EQ(gunzipped("a", good + good, {}), text + text);
  EXPECT_EQ(refusal([&] { gunzipped("a", good.substr(0, 200), {}); }),
            "a: ends within what gzip made, expected more of it");
  EXPECT_EQ(refusal([&] { gunzipped("a", good, {.most_bytes = 1000}); }),
            "a: not what gzip makes of 1000 bytes at the most, expected that");
  std::string wrong = good;
  wrong[good.size() - 6] ^= 1;
  EXPECT_NE(refusal([&] { gunzipped("a", wrong, {}); }), "");
}

}  // namespace lammps_test
}  // namespace touchstone::vnv::doors
