#include <fmt/format.h>
#include <gtest/gtest.h>

#include "vnv/doors/read/vtk_testing.hpp"

namespace touchstone::vnv::doors::vtk {
namespace vtk_legacy_test {

TEST(LegacyVtk, GivesTheBitsThatVtkWrote) {
  for (const char* name : {"particles_binary.vtk", "particles_binary_42.vtk", "cloud_binary.vtk"}) {
    SCOPED_TRACE(name);
    const std::vector<Dataset> read = read_sample(name);
    ASSERT_EQ(read.size(), 1u);
    EXPECT_EQ(differences(read[0], seven_particles()), "");
    EXPECT_EQ(read[0].format, "legacy VTK, binary");
  }
}

TEST(LegacyVtk, ReadsText) {
  const Dataset expected = seven_particles(false);
  for (const char* name : {"particles_ascii.vtk", "particles_ascii_42.vtk", "cloud_ascii.vtk"}) {
    SCOPED_TRACE(name);
    const std::vector<Dataset> read = read_sample(name);
    ASSERT_EQ(read.size(), 1u);
    EXPECT_EQ(read[0].format, "legacy VTK, text");
    EXPECT_EQ(differences(read[0], expected),
              "Points;velocity;wide <&> name;");  // VTK writes eleven digits, and six of floats
    for (const std::size_t array : {0u, 11u, 12u})
      for (std::size_t i = 0; i < expected.arrays[array].values.size(); ++i)
        EXPECT_NEAR(read[0].arrays[array].values[i], expected.arrays[array].values[i], array == 12 ? 1e-5 : 1e-10);
  }
}

TEST(LegacyVtk, GivesTheCellsThatXmlGives) {
  for (const char* name : {"mesh_binary.vtk", "mesh_binary_42.vtk", "mesh_ascii.vtk", "mesh_ascii_42.vtk"}) {
    SCOPED_TRACE(name);
    const std::vector<Dataset> read = read_sample(name), xml = read_sample("mesh.vtu");
    ASSERT_EQ(read.size(), 2u);
    EXPECT_EQ(differences(read[0], xml[0]), std::string(name).find("ascii") == std::string::npos ? "" : "height;");
    EXPECT_EQ(differences(read[1], xml[1]), "");
  }
  for (const char* name : {"plane_binary.vtk", "plane_ascii.vtk"})
    EXPECT_EQ(differences(read_sample(name)[0], read_sample("plane.vtp")[0]), "") << name;
}

TEST(LegacyVtk, PlacesThePointsOfStructuredGrids) {
  for (const char* name : {"image", "lines", "grid"}) {
    const std::vector<Dataset> read = read_sample(fmt::format("structured_{}.vtk", name));
    ASSERT_EQ(read.size(), 1u) << name;
    const Array& points = *read[0].array(points_array);
    std::vector<double> places;
    for (std::size_t row = 0; row < points.rows(); ++row)
      for (std::size_t k = 0; k < 3; ++k) places.push_back(points.at(row, k));
    EXPECT_EQ(places, (std::vector<double>{1, 2, 3, 1.5, 2, 3, 2, 2, 3, 1, 2.25, 3, 1.5, 2.25, 3, 2, 2.25, 3})) << name;
    EXPECT_NEAR(read[0].array("p")->values[5], 5 / 3., 1e-10) << name;
  }
}

TEST(LegacyVtk, LeavesOutPlacesOfAGridThatAreGhosts) {
  const std::vector<Dataset> read = read_as(
      "vtk_legacy", "run/a.vtk",
      "# vtk DataFile Version 3.0\na\nASCII\nDATASET STRUCTURED_POINTS\nDIMENSIONS 2 2 1\nPOINT_DATA 4\nFIELD f 2\n"
      "p 1 4 int\n1 2 3 4\nvtkGhostType 1 4 unsigned_char\n0 1 0 0\n",
      {});
  const Array& points = *read.at(0).array(points_array);
  ASSERT_EQ(points.rows(), 3u);
  EXPECT_EQ(read[0].array("p")->values, (std::vector<double>{1, 3, 4}));
  EXPECT_EQ(points.at(1, 0), 0);
  EXPECT_EQ(points.at(1, 1), 1);
  EXPECT_EQ(points.at(2, 0), 1);
}

TEST(LegacyVtk, ReadsWhatFoamToVtkWrites) {
  const std::vector<Dataset> binary = read_sample("openfoam/legacy/cavity_2.vtk"),
                             text = read_sample("openfoam/legacy_ascii/cavity_2.vtk"),
                             xml = read_sample("openfoam/xml/cavity_2/internal.vtu");
  ASSERT_EQ(binary.size(), 2u);
  EXPECT_EQ(binary[1].time, 0.01);
  EXPECT_EQ(binary[1].index, 2);
  EXPECT_NEAR(binary[1].layer[2], 0.01, 1e-9) << "all points stand at its bottom or its top";
  EXPECT_EQ(binary[1].layer[0] + binary[1].layer[1], 0);
  EXPECT_EQ(binary[1].cell_dimensions, 3);
  EXPECT_EQ(differences(binary[0], xml[0]) + differences(binary[1], xml[1]), "");
  for (std::size_t i = 0; i < 48; ++i)
    EXPECT_NEAR(text[1].array("U")->values[i], binary[1].array("U")->values[i], 1e-6);
}

const std::string good = R"(# vtk DataFile Version 3.0
two particles
ASCII
DATASET POLYDATA
POINTS 2 float
0 0 0 1 1 0
METADATA
INFORMATION 1
NAME L2_NORM_RANGE LOCATION vtkDataArray
DATA 2 0 1

VERTICES 2 4
1 0
1 1
POINT_DATA 2
SCALARS the%20pressure float
LOOKUP_TABLE default
3 4
VECTORS v double
1 2 0
3 4 0
FIELD more 1
rho 1 2 float
1000 1001
)";

std::string refusal_of(const std::string& text, const Limits& limits = {}) {
  return refusal([&] { read_as("vtk_legacy", "run/a.vtk", text, limits); });
}

TEST(LegacyVtk, ReadsTheFileThatItsRefusalsChange) {
  const std::vector<Dataset> read = read_as("vtk_legacy", "run/a_7.vtk", good, {});
  ASSERT_EQ(read.size(), 1u);
  EXPECT_EQ(read[0].array("the pressure")->values, (std::vector<double>{3, 4}));
  EXPECT_EQ(read[0].array("v")->values, (std::vector<double>{1, 2, 0, 3, 4, 0}));
  EXPECT_EQ(read[0].array("rho")->values, (std::vector<double>{1000, 1001}));
  EXPECT_EQ(read[0].index, 7);
}

TEST(LegacyVtk, RefusesInOneLineWhatItCannotRead) {
  const std::vector<std::tuple<std::string, std::string, std::string>> refusals = {
      {"# vtk", "# VTK", "expected '# vtk DataFile Version ' in its first line"},
      {"ASCII", "TEXT", "'TEXT', expected ASCII or BINARY"},
      {"POLYDATA", "MESH",
       "DATASET: 'MESH', expected POLYDATA, UNSTRUCTURED_GRID, STRUCTURED_POINTS, RECTILINEAR_GRID or STRUCTURED_GRID"},
      {"POINTS 2", "POINTS -2", "POINTS: '-2', expected a whole number from 0"},
      {"POINTS 2", "POINTS 99999999999",
       "POINTS: '99999999999' rows of 3 numbers, expected no more than 17179869184 bytes of numbers in a file"},
      {"POINTS 2", "POINTS 300", "POINTS: ends within its numbers, expected 900"},
      {"POINTS 2 float", "POINTS 2 bit", "POINTS: type 'bit', expected char to vtktypeuint64, float or double"},
      {"0 0 0 1", "0 0 x 1", "POINTS: number 3 'x', expected a number"},
      {"VERTICES 2 4", "VERTICES 3 4", "VERTICES: '4' numbers, expected corners of 1 cells more"},
      {"VERTICES 2 4\n1", "VERTICES 2 4\n9", "VERTICES: '4' numbers, expected corners of 2 cells more"},
      {"VERTICES 2 4\n1", "VERTICES 2 4\n-1", "VERTICES: '4' numbers, expected corners of 2 cells more"},
      {"VERTICES", "CORNERS", "'CORNERS', expected POINTS, CELLS, POINT_DATA or the like"},
      {"POINT_DATA 2", "POINT_DATA 3", "SCALARS 'the%20pressure': number 3 'VECTORS', expected a number"},
      {"pressure float", "pressure float 5000000",
       "SCALARS 'the%20pressure': '5000000' components, expected 1 to 1000"},
      {"VECTORS", "VERSORS", "'VERSORS', expected SCALARS, VECTORS, FIELD or the like"},
      {"rho 1 2", "rho 1 3", "FIELD 'rho': '3' rows, expected 2"},
      {"more 1", "more 2", "ends before its last '1' arrays of FIELD, expected them"},
  };
  for (const auto& [from, to, message] : refusals) {
    ASSERT_NE(good.find(from), good.npos) << from;
    EXPECT_EQ(refusal_of(std::string(good).replace(good.find(from), from.size(), to)), "run/a.vtk: " + message);
  }
  EXPECT_EQ(refusal_of(""), "run/a.vtk: expected '# vtk DataFile Version ' in its first line");
  EXPECT_EQ(refusal_of("# vtk DataFile Version 3.0\n\nBINARY\n"),
            "run/a.vtk: no DATASET, expected POLYDATA, UNSTRUCTURED_GRID or a structured one");
  EXPECT_EQ(refusal_of("# vtk DataFile Version 3.0\n\nBINARY\nDATASET POLYDATA\nPOINTS 1 float\n1234"),
            "run/a.vtk: POINTS: '12' bytes, expected no more than the 4 up to the end of the file");
  EXPECT_EQ(
      refusal_of(
          "# vtk DataFile Version 3.0\n\nASCII\nDATASET STRUCTURED_POINTS\nDIMENSIONS 2000000000 2000000000 1\nPOINT_DATA 1\nSCALARS a int\n1\n"),
      "run/a.vtk: DIMENSIONS: '2000000000 2000000000 1', expected as many points as the 1 rows of POINT_DATA");
  EXPECT_EQ(refusal_of("# vtk DataFile Version 3.0\n\nASCII\nDATASET STRUCTURED_POINTS\nDIMENSIONS 2000000000 2 1\n"),
            "run/a.vtk: expected arrays of POINT_DATA in a STRUCTURED_POINTS");
  EXPECT_EQ(
      refusal_of(
          "# vtk DataFile Version 5.1\n\nASCII\nDATASET POLYDATA\nPOINTS 1 float 0 0 0\nPOLYGONS 2 3\nOFFSETS vtktypeint64 0 9\nCONNECTIVITY vtktypeint64 0 0 0\n"),
      "run/a.vtk: POLYGONS: offset '9', expected one from 0 to 3");
}

}  // namespace vtk_legacy_test
}  // namespace touchstone::vnv::doors::vtk
