#include "vnv/doors/fields.hpp"

#include <gtest/gtest.h>

namespace touchstone::vnv::doors {
namespace fields_test {

const Domain domain{.box = {.high = {1, 1}}};

/// Two particles of a fluid and, between their rows, one of a wall below it, as PySPH writes them.
Dataset fluid_and_wall() {
  return {.source = "a.npz",
          .time = 1,
          .arrays = {{.name = "V", .values = {9, 9, 9}},
                     {.name = "u", .values = {1, 3, 2}},
                     {.name = "v", .values = {4, 6, 5}},
                     {.name = "x", .values = {0.1, 0.3, 0.2}},
                     {.name = "y", .values = {0.1, -0.3, 0.2}},
                     {.name = "p", .values = {7, 9, 8}},
                     {.name = "rho", .values = {1001, 1003, 1002}},
                     {.name = "m", .values = {10, 30, 20}},
                     {.name = "array", .values = {0, 1, 0}, .labels = {"fluid", "wall"}}}};
}

std::string refusal(const Dataset& data, const Mapping& mapping) {
  try {
    reading_of(data, mapping, domain, 1000);
  } catch (const Unreadable& error) {
    return error.what();
  }
  return "";
}

TEST(Fields, AreOfTheRowsThatAWordNames) {
  const Samples samples = reading_of(fluid_and_wall(), {.only = "array=fluid"}, domain, 1000).samples;
  ASSERT_EQ(samples.size(), 2);
  EXPECT_EQ(samples.v, (Vectors(2, 2) << 1, 2, 4, 5).finished()) << "v is that of small letters";
  EXPECT_EQ(samples.x, (Vectors(2, 2) << 0.1, 0.2, 0.1, 0.2).finished());
  EXPECT_EQ(samples.pressure.matrix(), Vec2(7, 8));
  EXPECT_EQ(samples.density.matrix(), Vec2(1001, 1002));
  EXPECT_EQ(samples.mass.matrix(), Vec2(10, 20));
  EXPECT_EQ(refusal(fluid_and_wall(), {.only = "array=solid"}),
            "a.npz: no rows with array 'solid', expected one of: fluid, wall");
  EXPECT_EQ(reading_of(fluid_and_wall(), {}, domain, 1000).samples.size(), 2) << "fluid is chosen by its name";
  Dataset oil = fluid_and_wall();
  oil.arrays.back().labels = {"oil", "wall"};
  EXPECT_NE(refusal(oil, {}).find("--only NAME=VALUE (array is oil, wall) or --inside"), std::string::npos);
}

TEST(Fields, AreNotThoseOfColumnsWhoseNamesOnlyBeginAlike) {
  Dataset data{.source = "a.csv", .time = 1};
  for (const char* name :
       {"xmean", "x_old", "y0", "zone", "velmag", "vxmean", "vymean", "vx2", "vz_rms", "uvar", "p0", "pmean",
        "press_old", "rho0", "rhomean", "mass_flow", "massfraction", "volume_fraction", "vol_old"})
    data.arrays.push_back({.name = name, .values = {99, 99}});
  for (const auto& [name, values] : std::vector<std::pair<std::string, std::vector<double>>>{{"x", {0.1, 0.2}},
                                                                                             {"y", {0.3, 0.4}},
                                                                                             {"vx", {1, 2}},
                                                                                             {"vy", {3, 4}},
                                                                                             {"p", {5, 6}},
                                                                                             {"rho", {7, 8}},
                                                                                             {"mass", {9, 10}}})
    data.arrays.push_back({.name = name, .values = values});
  for (const bool is_reversed : {false, true}) {
    if (is_reversed) std::ranges::reverse(data.arrays);
    const Samples s = reading_of(data, {}, domain, 1000).samples;
    EXPECT_EQ(s.x, (Vectors(2, 2) << 0.1, 0.2, 0.3, 0.4).finished());
    EXPECT_EQ(s.v, (Vectors(2, 2) << 1, 2, 3, 4).finished());
    EXPECT_EQ(s.pressure.matrix(), Vec2(5, 6));
    EXPECT_EQ(s.density.matrix(), Vec2(7, 8));
    EXPECT_EQ(s.mass.matrix(), Vec2(9, 10));
  }
}

TEST(Fields, KeepADensityWithoutMassesAndMassesWithoutADensity) {
  const auto without = [](const std::string& name) {
    Dataset data = fluid_and_wall();
    std::erase_if(data.arrays, [&](const Array& array) { return array.name == name; });
    return reading_of(data, {}, domain, 1000);
  };
  const Reading masses = without("rho"), densities = without("m");
  EXPECT_EQ(masses.samples.mass.matrix(), Vec2(10, 20));
  EXPECT_EQ(masses.samples.density.matrix(), Vec2(1000, 1000)) << "that of the flow";
  EXPECT_TRUE(masses.has_volumes);
  EXPECT_EQ(densities.samples.density.matrix(), Vec2(1001, 1002));
  EXPECT_EQ(densities.samples.volumes().matrix(), Vec2(1, 1)) << "rows weigh the same";
  EXPECT_FALSE(densities.has_volumes);
}

/// Cells of a mesh, half of which water, the rest air, but for one at the surface.
Dataset water_and_air() {
  return {.source = "a.vtu",
          .time = 1,
          .rows_are = Rows::cells,
          .arrays = {{.name = cell_centres_array, .components = 2, .values = {0.1, 0.1, 0.1, 0.3, 0.1, 0.5, 0.1, 0.7}},
                     {.name = cell_volumes_array, .values = {0.04, 0.04, 0.04, 0.04}},
                     {.name = "alpha.water", .values = {1, 1, 0.25, 0}}}};
}

TEST(Fields, AreOfTheRowsAboveOrBelowAThreshold) {
  EXPECT_EQ(reading_of(water_and_air(), {.only = "alpha.water>0.25"}, domain, 1000).samples.size(), 2);
  EXPECT_EQ(reading_of(water_and_air(), {.only = "alpha.water<0.5"}, domain, 1000).samples.x(1, 0), 0.5);
  const std::string expected =
      ", expected NAME=VALUE, NAME>VALUE or NAME<VALUE of an array of one component or of x, y or z";
  for (const std::string only :
       {"alpha.water>", "alpha.water>=0.5", "alpha.water>0.5m", "alpha.air>0.5", "alpha.water"})
    EXPECT_EQ(refusal(water_and_air(), {.only = only}), "a.vtu: --only '" + only + "'" + expected);
  EXPECT_EQ(refusal(fluid_and_wall(), {.only = "array>0"}), "a.npz: --only 'array>0'" + expected) << "words";
}

TEST(Fields, OfACellAtASurfaceWeighByItsFluid) {
  const Mapping by_fraction{.arrays = {{"fraction", "alpha.water"}}, .only = "alpha.water>0"};
  EXPECT_EQ(reading_of(water_and_air(), by_fraction, domain, 1000).samples.mass.matrix(), Eigen::Vector3d(40, 40, 10));
  EXPECT_EQ(refusal(water_and_air(), {.arrays = by_fraction.arrays}),
            "a.vtu: row 4: fraction 0 of volume 0.04, expected both above 0: --only 'alpha.water>0' leaves rows out");
  Dataset without_volumes = water_and_air();
  without_volumes.arrays.erase(without_volumes.arrays.begin() + 1);
  EXPECT_EQ(refusal(without_volumes, by_fraction),
            "a.vtu: row 1: fraction 1 of volume nan, expected both above 0: --only 'alpha.water>0' leaves rows out");
}

TEST(Fields, OfALayerOfBodiesAreWeighedByVolumesOverItsDepth) {
  Dataset layer = water_and_air();
  layer.cell_dimensions = 3;
  layer.layer = {0, 0, 0.5};
  const Reading metres = reading_of(layer, {}, domain, 1000);
  EXPECT_EQ(metres.samples.mass[0], 80);
  EXPECT_EQ(metres.words.back(), "volume: cell volumes, of a layer 0.5 m deep");
  for (double& x : layer.arrays[0].values) x *= 1000;
  for (double& volume : layer.arrays[1].values) volume *= 1e9;
  layer.layer[2] *= 1000;
  const Reading millimetres = reading_of(layer, {.units = {{"length", "mm"}}}, domain, 1000);
  EXPECT_NEAR(millimetres.samples.mass[0], 80, 1e-10);
  EXPECT_EQ(millimetres.words.back(), metres.words.back());
  layer.layer = {};
  EXPECT_EQ(reading_of(layer, {.units = {{"length", "mm"}}}, domain, 1000).words.back(),
            "volume: cell volumes, as of a layer 1 m deep");
}

TEST(Fields, MayBeOfALayerAlongAnyAxis) {
  struct Case {
    std::array<std::size_t, 2> along;  // those of the file that are x and y of the flow
    std::string axes;
  };
  for (const auto& [along, axes] : {Case{{0, 2}, ""}, {{0, 2}, "xz"}, {{2, 0}, "zx"}, {{1, 2}, "yz"}, {{2, 1}, "zy"}}) {
    const std::size_t across = 3 - along[0] - along[1];
    Dataset layer{.source = "a.vtu", .time = 1, .rows_are = Rows::cells};
    layer.cell_dimensions = 3;
    layer.layer[across] = 0.5;
    std::vector<double> places(6, 0.25), velocities(6, 99);
    for (const std::size_t cell : {0u, 1u})
      for (const std::size_t k : {0u, 1u}) {
        places[3 * cell + along[k]] = 0.1 + 0.2 * static_cast<double>(cell) + 0.4 * static_cast<double>(k);
        velocities[3 * cell + along[k]] = static_cast<double>(1 + cell + 2 * k);
      }
    layer.arrays = {{.name = cell_centres_array, .components = 3, .values = places},
                    {.name = cell_volumes_array, .values = {0.02, 0.03}},
                    {.name = "U", .components = 3, .values = velocities}};
    const Reading reading = reading_of(layer, {.axes = axes}, domain, 1000);
    EXPECT_TRUE(reading.samples.x.isApprox((Vectors(2, 2) << 0.1, 0.3, 0.5, 0.7).finished())) << axes;
    EXPECT_EQ(reading.samples.v, (Vectors(2, 2) << 1, 2, 3, 4).finished()) << axes;
    EXPECT_TRUE(reading.samples.mass.matrix().isApprox(Vec2(40, 60))) << axes;
    EXPECT_EQ(reading.words.back(), "volume: cell volumes, of a layer 0.5 m deep") << axes;
  }
}

TEST(Fields, AreOfColumnsThatTheUserLists) {
  Dataset table{.source = "a.npy", .time = 1};
  for (const char* name : {"column 1", "column 2", "column 3", "c_v[1]"})
    table.arrays.push_back({.name = name, .values = {0.1, 0.2}});
  Mapping mapping{.arrays = {{"position", "column 1,column 2"}, {"velocity", "column 3,c_v[1]"}}};
  EXPECT_EQ(reading_of(table, mapping, domain, 1000).samples.v(1, 1), 0.2);
  mapping.arrays["velocity"] = "column 3,column 5";
  EXPECT_EQ(refusal(table, mapping),
            "a.npy: no array 'column 3,column 5' for velocity, expected one of: column 1, "
            "column 2, column 3, c_v[1]");
}

/// A table of places and of one component of the velocity.
Dataset with_velocity(const std::string& component) {
  Dataset table = fluid_and_wall();
  table.arrays.erase(table.arrays.begin() + 1);
  table.arrays[1].name = component;
  return table;
}

TEST(Fields, MayLackTheVelocityAcross) {
  const Reading reading = reading_of(with_velocity("v_x"), {}, domain, 1000);
  EXPECT_EQ(std::ranges::count(reading.fields, velocity_along_x), 1);
  EXPECT_EQ(std::ranges::count(reading.fields, "velocity"), 0);
  EXPECT_TRUE(reading.samples.v.row(0).allFinite());
  EXPECT_TRUE(reading.samples.v.row(1).array().isNaN().all());
  EXPECT_EQ(reading_of(with_velocity("w"), {.arrays = {{"velocity", "w"}}}, domain, 1000).fields, reading.fields);
}

TEST(Fields, ByWhichRowsAreWeighedAreNumbers) {
  Dataset data = fluid_and_wall();
  data.arrays[6].values[2] = NAN;
  EXPECT_EQ(refusal(data, {}), "a.npz: row 3: rho = nan, expected a finite number");
  data.arrays[6].values = {1001, NAN, 1002};
  EXPECT_EQ(refusal(data, {}), "") << "of a row that is no fluid";
  data.arrays[5].values[0] = NAN;
  EXPECT_EQ(refusal(data, {}), "") << "a pressure is judged";
}

TEST(Fields, OfAMeshAreNotWrappedIntoAShorterPeriod) {
  Dataset mesh = water_and_air();
  for (double& x : mesh.arrays[0].values) x *= 1000;
  const Domain periodic{.box = {.high = {1, 1}}, .periodic_x = true, .periodic_y = true};
  EXPECT_THROW(reading_of(mesh, {}, periodic, 1000), LongerThanPeriod);
  EXPECT_NEAR(reading_of(mesh, {.units = {{"length", "mm"}}}, periodic, 1000).samples.x(1, 3), 0.7, 1e-12);
}

TEST(Fields, AreTurnedWithAxesThatRunTheOtherWay) {
  Dataset data{.source = "a.csv",
               .time = 1.0,
               .arrays = {{.name = "x", .values = {0.25, 0.75}},
                          {.name = "y", .values = {0, 0}},
                          {.name = "z", .values = {-0.25, -0.75}},
                          {.name = "vx", .values = {1, 2}},
                          {.name = "vy", .values = {0, 0}},
                          {.name = "vz", .values = {-3, -4}}}};
  const Samples s = reading_of(data, {.axes = "-zx"}, domain, 1000).samples;
  EXPECT_EQ(s.x, (Vectors(2, 2) << 0.25, 0.75, 0.25, 0.75).finished());
  EXPECT_EQ(s.v, (Vectors(2, 2) << 3, 4, 1, 2).finished());
  EXPECT_EQ(reading_of(data, {.axes = "zx", .origin = {-1, 0}}, domain, 1000).samples.x(0, 0), 0.75);
  data.arrays[2].values = {0.75, 0.25};
  EXPECT_EQ(reading_of(data, {.axes = "-zx", .origin = {1, 0}}, domain, 1000).samples.x(0, 0), 0.25)
      << "the origin is told in the coordinates of the file";
  EXPECT_THROW(require_known_names({.axes = "xx"}, "read"), std::invalid_argument);
}

TEST(Fields, OfAVelocityAreAtLeastThatAlongX) {
  EXPECT_EQ(refusal(with_velocity("v_y"), {}), "a.npz: velocity is 'v_y' alone, expected its component along x too");
  EXPECT_EQ(refusal(with_velocity("v_x"), {.axes = "yx"}),
            "a.npz: velocity is 'v_x' alone, expected its component along y too");
}

}  // namespace fields_test
}  // namespace touchstone::vnv::doors
