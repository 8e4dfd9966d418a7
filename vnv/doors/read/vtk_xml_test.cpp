#include <fmt/format.h>
#include <gtest/gtest.h>

#include <numeric>

#include "vnv/doors/read/vtk_testing.hpp"

namespace touchstone::vnv::doors::vtk {
namespace vtk_xml_test {

TEST(VtkXml, GivesTheSameBitsThroughEveryEncodingThatVtkWrites) {
  const std::vector<std::pair<std::string, std::string>> formats = {
      {"binary_plain_32", "binary"},
      {"binary_plain_64", "binary"},
      {"binary_zlib_64", "binary, zlib"},
      {"binary_lz4_64", "binary, LZ4"},
      {"appended_plain_32", "appended raw"},
      {"appended_plain_64", "appended raw"},
      {"appended_zlib_32", "appended raw, zlib"},
      {"appended_zlib_64", "appended raw, zlib"},
      {"appended_lz4_32", "appended raw, LZ4"},
      {"appended_lz4_64", "appended raw, LZ4"},
      {"appended_base64_plain_32", "appended base64"},
      {"appended_base64_plain_64", "appended base64"},
      {"appended_base64_zlib_64", "appended base64, zlib"},
      {"appended_base64_lz4_64", "appended base64, LZ4"},
      {"big_endian", "appended raw"},
      {"big_endian_zlib", "binary, zlib"}};
  for (const auto& [name, format] : formats) {
    SCOPED_TRACE(name);
    const std::vector<Dataset> read = read_sample("particles_" + name + ".vtp");
    ASSERT_EQ(read.size(), 1u);
    EXPECT_EQ(differences(read[0], seven_particles()), "");
    EXPECT_EQ(read[0].format, "VTP, " + format);
    EXPECT_EQ(read[0].source, "particles_" + name + ".vtp");
  }
  EXPECT_EQ(read_sample("particles_appended_lz4_64.vtp")[0].index, 64);
}

TEST(VtkXml, ReadsText) {
  const std::vector<Dataset> read = read_sample("particles_ascii.vtp");
  ASSERT_EQ(read.size(), 1u);
  EXPECT_EQ(read[0].format, "VTP, ascii");
  EXPECT_EQ(differences(read[0], seven_particles(false)), "");
}

TEST(VtkXml, ReadsVerticesOfAGridAsParticles) {
  const std::vector<Dataset> read = read_sample("particles.vtu");
  ASSERT_EQ(read.size(), 1u);
  EXPECT_EQ(read[0].format, "VTU, appended raw, zlib");
  EXPECT_EQ(differences(read[0], seven_particles()), "");
}

TEST(VtkXml, PutsPiecesTogether) {
  const std::vector<Dataset> read = read_sample("parallel.pvtp");
  ASSERT_EQ(read.size(), 1u);
  Dataset twice = seven_particles();  // VTK wrote the same into both pieces
  for (Array& array : twice.arrays)
    array.values.insert(array.values.end(), array.values.begin(), array.values.begin() + std::ssize(array.values));
  EXPECT_EQ(differences(read[0], twice), "");
  EXPECT_EQ(read[0].format, "PVTP, appended base64, zlib");
}

void expect_mesh(const std::vector<Dataset>& read, const std::string& kind) {
  ASSERT_EQ(read.size(), 2u);
  EXPECT_EQ(read[0].rows_are, Rows::particles);
  EXPECT_EQ(read[0].rows(), 48u);
  EXPECT_EQ(read[0].array("height")->values[5], 5. / 48);
  const Dataset& cells = read[1];
  EXPECT_EQ(cells.rows_are, Rows::cells);
  EXPECT_EQ(cells.format, kind);
  EXPECT_EQ(cells.time, 0.25);
  ASSERT_EQ(cells.rows(), 6u);
  const std::vector<double> volumes = {1. / 6, 1, 1, 1. / 2, 1. / 3, 1};
  const std::vector<double> heights = {1. / 4, 1. / 2, 1. / 2, 1. / 2, 1. / 4, 1. / 2},
                            across = {1. / 4, 2.5, 4.5, 6 + 1. / 3, 8.375, 10.5};
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_NEAR(cells.array(cell_volumes_array)->values[i], volumes[i], 1e-14) << i;
    EXPECT_NEAR(cells.array(cell_centres_array)->values[3 * i], across[i], 1e-14) << i;
    EXPECT_NEAR(cells.array(cell_centres_array)->values[3 * i + 2], heights[i], 1e-14) << i;
    EXPECT_EQ(cells.array("p")->values[i], static_cast<double>(i) / 4);
  }
}

TEST(VtkXml, GivesCentresAndVolumesOfCellsOfEveryKind) {
  expect_mesh(read_sample("mesh.vtu"), "VTU, appended raw, LZ4");
  expect_mesh(read_sample("mesh_ascii.vtu"), "VTU, ascii");
}

TEST(VtkXml, GivesAreasOfPolygonsAndStrips) {
  const std::vector<Dataset> read = read_sample("plane.vtp");
  ASSERT_EQ(read.size(), 1u);
  EXPECT_EQ(read[0].rows_are, Rows::cells);
  EXPECT_EQ(read[0].array(cell_volumes_array)->values, (std::vector<double>{0.5, 1, 1.5, 1}));
  EXPECT_EQ(read[0].array("U")->values, (std::vector<double>{0, 0, 0, 1, 2, 0, 2, 4, 0, 3, 6, 0}));
  EXPECT_EQ(read[0].array("two")->components, 2);
  EXPECT_EQ(read[0].array("stress")->components, 9);
}

TEST(VtkXml, ReadsTheCellsAndPointsThatFoamToVtkWrites) {
  const std::vector<Dataset> tree = read_sample("openfoam/xml/cavity_2.vtm"),
                             file = read_sample("openfoam/xml/cavity_2/internal.vtu");
  ASSERT_EQ(tree.size(), 2u);
  ASSERT_EQ(file.size(), 2u);
  EXPECT_EQ(tree[1].source, "cavity_2.vtm: cavity_2/internal.vtu");
  EXPECT_EQ(tree[1].time, 0.01);
  EXPECT_EQ(tree[1].index, 2);
  EXPECT_EQ(differences(tree[0], file[0]) + differences(tree[1], file[1]), "");
  EXPECT_EQ(tree[0].rows(), 50u);
  ASSERT_EQ(tree[1].rows(), 16u);
  const std::vector<double>& volumes = tree[1].array(cell_volumes_array)->values;
  for (const double volume : volumes) EXPECT_NEAR(volume, 0.025 * 0.025 * 0.01, 1e-12);
  EXPECT_NEAR(tree[1].array(cell_centres_array)->values[0], 0.0125, 1e-9);
  EXPECT_EQ(read_sample("openfoam/xml/cavity_2/boundary/lid.vtp").size(), 2u);
}

/// A file of two particles; pieces of it are replaced by what cannot be read.
const std::string good =
    R"(<VTKFile type="PolyData" version="1.0" byte_order="LittleEndian" header_type="UInt64" compressor="">
<PolyData><FieldData><DataArray type="Float64" Name="TimeValue" NumberOfTuples="1" format="ascii">2</DataArray></FieldData>
<Piece NumberOfPoints="2" NumberOfVerts="0" NumberOfLines="0" NumberOfStrips="0" NumberOfPolys="0">
<PointData><DataArray type="Float32" Name="p" NumberOfComponents="1" format="binary">CAAAAAAAAAAAAIA/AAAAQA==</DataArray></PointData>
<Points><DataArray type="Float64" NumberOfComponents="3" format="ascii">0 0 0 1 1 0</DataArray></Points>
</Piece></PolyData></VTKFile>)";

std::string with(std::string text, const std::vector<std::pair<std::string, std::string>>& changes) {
  for (const auto& [from, to] : changes) {
    EXPECT_NE(text.find(from), text.npos) << from;
    text.replace(text.find(from), from.size(), to);
  }
  return text;
}

std::string refusal_of(const std::string& text, const Limits& limits = {}) {
  return refusal([&] { read_as("vtk_xml", "run/a.vtp", text, limits); });
}

TEST(VtkXml, ReadsTheFileThatItsRefusalsChange) {
  const std::vector<Dataset> read = read_as("vtk_xml", "run/a_3.vtp", good, {});
  EXPECT_EQ(read[0].array("p")->values, (std::vector<double>{1, 2}));
  EXPECT_EQ(read[0].time, 2);
  EXPECT_EQ(read[0].index, 3);
}

TEST(VtkXml, RefusesInOneLineWhatItCannotRead) {
  const std::vector<std::tuple<std::string, std::string, std::string>> refusals = {
      {"VTKFile type", "vtk type", "run/a.vtp: byte 581: Start-end tags mismatch, expected XML of VTK"},
      {"PolyData\" v", "ImageData\" v",
       "run/a.vtp: type 'ImageData', expected PolyData, UnstructuredGrid or their parallel forms"},
      {"UInt64", "UInt16", "run/a.vtp: header_type 'UInt16', expected UInt32 or UInt64"},
      {"LittleEndian", "MiddleEndian", "run/a.vtp: byte_order 'MiddleEndian', expected LittleEndian or BigEndian"},
      {"compressor=\"", "compressor=\"vtkLZMADataCompressor",
       "run/a.vtp: compressor 'vtkLZMADataCompressor', expected none, vtkZLibDataCompressor or vtkLZ4DataCompressor"},
      {"Points=\"2", "Points=\"-2", "run/a.vtp: Piece: NumberOfPoints: '-2', expected a whole number from 0"},
      {"Points=\"2", "Points=\"9999999999999999999",
       "run/a.vtp: Points '': '9999999999999999999' rows of 3 numbers, expected no more than 17179869184 bytes of numbers in a file"},
      {"Points=\"2", "Points=\"3", "run/a.vtp: Points '': ends within its numbers, expected 9"},
      {"Points=\"2", "Points=\"1", "run/a.vtp: Points '': more than its 3 numbers, expected no more"},
      {"Components=\"1", "Components=\"5000000", "run/a.vtp: PointData 'p': '5000000' components, expected 1 to 1000"},
      {"Components=\"1", "Components=\"0", "run/a.vtp: PointData 'p': '0' components, expected 1 to 1000"},
      {"Components=\"1", "Components=\"2", "run/a.vtp: PointData 'p': '8' bytes, expected 16 of 4 numbers"},
      {"Components=\"3", "Components=\"2", "run/a.vtp: Points: '2' components, expected 3"},
      {"Float32", "Float16", "run/a.vtp: PointData 'p': type 'Float16', expected Int8 to UInt64, Float32 or Float64"},
      {"format=\"binary", "format=\"text",
       "run/a.vtp: PointData 'p': format 'text', expected ascii, binary or appended"},
      {"format=\"binary", "offset=\"7\" format=\"appended",
       "run/a.vtp: PointData 'p': offset '7', expected no more than the 0 bytes that are appended"},
      {"CAAAAAAA", "CAAAAAA/", "run/a.vtp: PointData 'p': '69269232549896' bytes, expected 8 of 2 numbers"},
      {"AAQA==", "", "run/a.vtp: PointData 'p': ends within its base64, expected more of it"},
      {"CAAA", "C*AA",
       "run/a.vtp: PointData 'p': byte 42 of its base64, expected A-Z, a-z, 0-9, + or /, or = at its end"},
      {">0 0 0 1", ">0 0 none 1", "run/a.vtp: Points '': number 3 'none', expected a number"},
      {"ascii\">2", "ascii\">nan", "run/a.vtp: FieldData 'TimeValue': 'nan', expected a time"},
      {"<Points><DataArray type=\"Float64\" NumberOfComponents=\"3\" format=\"ascii\">0 0 0 1 1 0</DataArray></Points>",
       "", "run/a.vtp: no Points in a Piece, expected an array of 3 components"},
      {"Polys=\"0", "Polys=\"4", "run/a.vtp: Cells: no array 'offsets', expected one"},
      {"</PointData>", "<DataArray type=\"Int8\" Name=\"p\" format=\"ascii\">1 2</DataArray></PointData>",
       "a.vtp: array 'p' of 4 rows, expected 2, as 'Points' has"},
      {"Name=\"p\"", "Name=\"Points\"", "a.vtp: array 'Points' twice, expected each name once"},
      {"</PolyData>", "</PolyData><AppendedData>", "run/a.vtp: AppendedData: encoding '', expected raw or base64"},
      {"</PolyData>", "</PolyData><AppendedData encoding=\"raw\">",
       "run/a.vtp: AppendedData: expected '_' before the data"},
  };
  for (const auto& [from, to, message] : refusals) EXPECT_EQ(refusal_of(with(good, {{from, to}})), message) << to;
  EXPECT_EQ(refusal_of(""), "run/a.vtp: byte 0: No document element found, expected XML of VTK");
  EXPECT_EQ(refusal_of(good, {.most_bytes = 100}),
            fmt::format("run/a.vtp: '{}' bytes, expected no more than 100", good.size()));
  EXPECT_EQ(refusal([] { read_sample("particles_lzma.vtp"); }),
            sample("particles_lzma.vtp").string() +
                ": compressor 'vtkLZMADataCompressor', expected none, vtkZLibDataCompressor or vtkLZ4DataCompressor");
}

TEST(VtkXml, RefusesEntitiesAndTooManyElements) {
  const std::string bomb = R"(<!DOCTYPE v [<!ENTITY a "aaaaaaaaaa"><!ENTITY b "&a;&a;&a;&a;&a;">]>)" +
                           with(good, {{"Name=\"p\"", "Name=\"&b;\""}});
  EXPECT_NE(read_as("vtk_xml", "a.vtp", bomb, {})[0].array("&b;"), nullptr);  // no entity is expanded
  std::string many = "<VTKFile>";
  for (int i = 0; i < 20000; ++i) many += "<a/>";
  EXPECT_EQ(refusal_of(many), "run/a.vtp: expected XML of no more than 15000 elements");
}

std::string appended(const std::string& arrays, const std::string& header, const std::string& bytes) {
  return R"(<VTKFile type="PolyData" byte_order="LittleEndian" )" + header +
         R"(><PolyData><Piece NumberOfPoints="2"><Points>)" +
         R"(<DataArray type="Float64" format="ascii">0 0 0 1 1 0</DataArray></Points><PointData>)" + arrays +
         R"(</PointData></Piece></PolyData><AppendedData encoding="raw">_)" + bytes;
}

std::string words(std::initializer_list<std::uint32_t> numbers) {
  return std::string(reinterpret_cast<const char*>(numbers.begin()), 4 * numbers.size());
}

TEST(VtkXml, RefusesLyingHeadersOfAppendedData) {
  const std::string p = R"(<DataArray type="Float32" Name="p" format="appended" offset="0"/>)",
                    zlib = R"(compressor="vtkZLibDataCompressor")", lz4 = R"(compressor="vtkLZ4DataCompressor")";
  EXPECT_EQ(refusal_of(appended(p, "", words({8, 0, 0}))), "");
  EXPECT_EQ(refusal_of(appended(p, "", words({8, 0}))),
            "run/a.vtp: PointData 'p': '8' bytes that begin here, expected no more than the 4 up to its end");
  EXPECT_EQ(
      refusal_of(appended(p, zlib, words({1, 8, 0}))),
      "run/a.vtp: PointData 'p': '8' bytes once decompressed, expected no more than 1032 times those of the file");
  EXPECT_EQ(refusal_of(appended(p, zlib, words({4000000000, 8, 0, 1}))),
            "run/a.vtp: PointData 'p': '4000000000' blocks of 8 bytes, the last of 0, expected 8 bytes in all");
  EXPECT_EQ(refusal_of(appended(p, zlib, words({8, 1, 0, 1}))),
            "run/a.vtp: PointData 'p': '8' blocks, expected their sizes");
  EXPECT_EQ(refusal_of(appended(p, zlib, words({1, 8, 0, 4, 7}))),
            "run/a.vtp: PointData 'p': block 1 of 1, expected 8 bytes compressed by zlib");
  EXPECT_EQ(refusal_of(appended(p, lz4, words({1, 8, 0, 4, 7}))),
            "run/a.vtp: PointData 'p': block 1 of 1, expected 8 bytes compressed by LZ4");
  EXPECT_EQ(refusal_of(appended(p, zlib, words({1, 8, 0, 400, 7}))),
            "run/a.vtp: PointData 'p': '400' bytes that begin here, expected no more than the 4 up to its end");
  std::string arrays;  // as many as would be made of the same bytes
  for (int i = 0; i < 300; ++i)
    arrays +=
        fmt::format(R"(<DataArray type="UInt8" Name="{}" NumberOfComponents="400" format="appended" offset="0"/>)", i);
  const std::string message = refusal_of(appended(arrays, "", words({800}) + std::string(800, 'a')));
  EXPECT_TRUE(message.ends_with("reads what another array has read, expected each byte in one array")) << message;
  EXPECT_EQ(refusal_of(appended("", "compressor=\"a\n\x1b[31mb\"", "")),
            "run/a.vtp: compressor 'a ?[31mb', expected none, vtkZLibDataCompressor or vtkLZ4DataCompressor");
}

TEST(VtkXml, RefusesCellsThatAreNone) {
  const auto grid = [](const std::string& connectivity, const std::string& offsets, const std::string& types,
                       const std::string& more = "") {
    const auto count = 1 + std::count(types.begin(), types.end(), ' ');
    return refusal_of(fmt::format(
        R"(<VTKFile type="UnstructuredGrid"><UnstructuredGrid><Piece NumberOfPoints="4" NumberOfCells="{}"><Points>
<DataArray type="Float64" format="ascii">0 0 0 1 0 0 0 1 0 0 0 1</DataArray></Points><Cells><DataArray type="Int64" Name="connectivity" format="ascii">{}</DataArray>
<DataArray type="Int64" Name="offsets" format="ascii">{}</DataArray><DataArray type="Int32" Name="types" format="ascii">{}</DataArray>{}</Cells></Piece></UnstructuredGrid></VTKFile>)",
        count, connectivity, offsets, types, more));
  };
  const auto faces = [](const std::string& stream, int end) {
    return fmt::format(
        R"(<DataArray type="Int64" Name="faces" format="ascii">{}</DataArray><DataArray type="Int64" Name="faceoffsets" format="ascii">{}</DataArray>)",
        stream, end);
  };
  EXPECT_EQ(grid("0 1 2 3", "4", "10"), "");
  EXPECT_EQ(grid("0 1 2 4", "4", "10"), "run/a.vtp: cells: corner '4', expected a point from 0 to 3");
  EXPECT_EQ(grid("0 1 2 -1", "4", "10"), "run/a.vtp: cells: corner '-1', expected a point from 0 to 3");
  EXPECT_EQ(grid("0 1 2", "3", "10"), "run/a.vtp: cells: cell 0 of type 10 with '3' corners, expected 4");
  EXPECT_EQ(grid("0 1 2 3", "4", "24"), "run/a.vtp: cells: cell type '24', expected VTK's 0 to 14 or 42");
  EXPECT_EQ(grid("0 1 2", "6 3", "5 5"), "run/a.vtp: offsets: '6', expected one from 0 to 3");
  EXPECT_EQ(grid("0 1 2", "-3", "5"), "run/a.vtp: offsets: '-3', expected a whole number from 0");
  EXPECT_EQ(grid("0 1 2 3", "4", "42"), "run/a.vtp: Cells: no array 'faceoffsets', expected one");
  EXPECT_EQ(grid("0 1 2 3", "4", "42", faces("4 3 0 1 2 3 0 1 3 3 1 2 3 3 0 2 3", 17)), "");
  EXPECT_EQ(grid("0 1 2 3", "4", "42", faces("5 3 0 1 2 3 0 1 3 3 1 2 3 3 0 2 3", 17)),
            "run/a.vtp: cells: a polyhedron ends within its faces, expected the corners of each");
  EXPECT_EQ(grid("0 1 2 3", "4", "42", faces("4 3 0 1 2 3 0 1 3 3 1 2 3 9 0 2 3", 17)),
            "run/a.vtp: cells: a polyhedron of '9' faces or corners of one, expected no more than 3");
  EXPECT_EQ(grid("0 1 2 3", "4", "42", faces("1 2 0 1", 4)),
            "run/a.vtp: cells: a face of '2' corners, expected 3 or more");
  EXPECT_EQ(grid("0 1 2 3", "4", "42", faces("4", -7)),
            "run/a.vtp: Cells 'faces': more than its 0 numbers, expected no more");
}

TEST(VtkXml, LeavesOutRowsThatAnotherPieceOwns) {
  const std::string ghosts = with(
      good,
      {{"</PointData>", R"(<DataArray type="UInt8" Name="vtkGhostType" format="ascii">1 0</DataArray></PointData>)"}});
  const Dataset read = read_as("vtk_xml", "a.vtp", ghosts, {})[0];
  EXPECT_EQ(read.array("p")->values, std::vector<double>{2});
  EXPECT_EQ(read.array(points_array)->values, (std::vector<double>{1, 1, 0}));
  EXPECT_EQ(read.array("vtkGhostType"), nullptr);
}

}  // namespace vtk_xml_test
}  // namespace touchstone::vnv::doors::vtk
