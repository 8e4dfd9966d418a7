#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <bit>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>

#include "vnv/doors/read/most_held.hpp"
#include "vnv/doors/read/parts/columns.hpp"
#include "vnv/doors/read/testing.hpp"

namespace touchstone::vnv::doors {
namespace memory_test {

namespace fs = std::filesystem;

constexpr std::size_t count = 1 << 23;  // numbers of a byte each

/// A folder for as long as this lasts.
struct Folder {
  const fs::path path = fs::path(testing::TempDir()) / fmt::format("memory.{}", getpid());

  Folder() { fs::create_directories(path); }
  ~Folder() { fs::remove_all(path); }
  fs::path operator/(const std::string& name) const { return path / name; }
};

/// Ten times the file and 4 MiB, which every reader may hold, the file itself included.
std::size_t most_for(std::size_t bytes) { return 10 * bytes + (std::size_t{1} << 22); }

std::string npy(const std::string& shape, bool is_fortran) {
  std::string header =
      fmt::format("{{'descr': '|u1', 'fortran_order': {}, 'shape': {}, }}", is_fortran ? "True" : "False", shape);
  header.resize(118, ' ');
  return std::string("\x93NUMPY\x01\x00\x76\x00", 10) + header + std::string(count, '\7');
}

/// Places and a pressure of UInt8.
std::string vtp(std::size_t pieces, std::size_t numbers) {
  const std::size_t rows = numbers / 4 / pieces;
  std::string xml = R"(<VTKFile type="PolyData" byte_order="LittleEndian"><PolyData>)", data;
  const auto append = [&](std::size_t bytes) {
    const auto size = std::bit_cast<std::array<char, 4>>(static_cast<std::uint32_t>(bytes));
    data.append(size.begin(), size.end()).append(bytes, '\7');
  };
  for (std::size_t piece = 0; piece < pieces; ++piece) {
    xml += fmt::format(
        R"(<Piece NumberOfPoints="{}"><Points><DataArray type="UInt8" NumberOfComponents="3" format="appended" offset="{}"/></Points>)",
        rows, data.size());
    append(3 * rows);
    xml += fmt::format(
        R"(<PointData><DataArray type="UInt8" Name="p" format="appended" offset="{}"/></PointData></Piece>)",
        data.size());
    append(rows);
  }
  return xml + R"(</PolyData><AppendedData encoding="raw">_)" + data;
}

std::string legacy() {
  const std::size_t rows = count / 4;
  return fmt::format("# vtk DataFile Version 3.0\na\nBINARY\nDATASET POLYDATA\nPOINTS {} unsigned_char\n{}\n", rows,
                     std::string(3 * rows, '\7')) +
         fmt::format("POINT_DATA {}\nSCALARS p unsigned_char\nLOOKUP_TABLE default\n{}\n", rows,
                     std::string(rows, '\7'));
}

/// A pressure on a grid of so many points, of a heading that says where they are.
std::string structured(std::string heading, std::size_t points, const std::string& more = "") {
  heading = "# vtk DataFile Version 3.0\na\nBINARY\nDATASET " + heading;
  return heading + fmt::format("POINT_DATA {}\nSCALARS p unsigned_char\nLOOKUP_TABLE default\n{}\n{}", points,
                               std::string(points, '\7'), more);
}

std::string text_of(std::string heading, const std::string& row) {
  for (std::size_t k = 0; k < count / row.size(); ++k) heading += row;
  return heading;
}

void write(const fs::path& file, const std::string& bytes) { std::ofstream(file, std::ios::binary) << bytes; }

TEST(FileOfOneByteNumbers, IsReadWithinTenTimesItsSize) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "a sanitizer keeps what is freed";
#endif
  const Folder folder;
  const std::map<std::string, std::function<std::string()>> files = {
      {"list.npy", [] { return npy(fmt::format("({},)", count), false); }},
      {"table.npy", [] { return npy(fmt::format("({}, 2)", count / 2), false); }},
      {"fortran.npy", [] { return npy(fmt::format("({}, 2)", count / 2), true); }},
      {"one_piece.vtp", [] { return vtp(1, count); }},
      {"pieces.vtp", [] { return vtp(5, count); }},
      {"legacy.vtk", legacy},
      {"image.vtk", [] { return structured(fmt::format("STRUCTURED_POINTS\nDIMENSIONS {} 2 1\n", count / 2), count); }},
      {"lines.vtk",
       [] {
         const std::string axis = "_COORDINATES 1 unsigned_char\n\7\n";
         return structured(fmt::format("RECTILINEAR_GRID\nDIMENSIONS {0} 1 1\nX_COORDINATES {0} unsigned_char\n{1}\n",
                                       count / 2, std::string(count / 2, '\7')) +
                               "Y" + axis + "Z" + axis,
                           count / 2);
       }},
      {"ghosts.vtk",
       [] {
         return structured(fmt::format("STRUCTURED_POINTS\nDIMENSIONS {} 2 1\n", count / 4), count / 2,
                           fmt::format("SCALARS vtkGhostType unsigned_char\nLOOKUP_TABLE default\n\1{}\n",
                                       std::string(count / 2 - 1, '\0')));
       }},
      {"table.csv", [] { return text_of("x,y\n", "1,2\n"); }},
      {"dump.lammpstrj",
       [] { return text_of(fmt::format("ITEM: NUMBER OF ATOMS\n{}\nITEM: ATOMS x y\n", count / 4), "1 2\n"); }}};
  for (const auto& [name, bytes] : files) {
    const fs::path file = folder / name;
    write(file, bytes());
    const auto read = [&] {
      if (read_datasets(file).at(0).rows() == 0) throw Unreadable("no rows");
    };
    const std::size_t held = most_held(read), size = fs::file_size(file);
    EXPECT_LE(held, most_for(size)) << name;
    RecordProperty(name, fmt::format("{:.2f}", static_cast<double>(held) / static_cast<double>(size)));
  }
}

TEST(FileOfOneByteNumbers, MayBeInPiecesOfFilesOfTheirOwn) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "a sanitizer keeps what is freed";
#endif
  const Folder folder;
  std::string pieces;
  for (int piece = 0; piece < 5; ++piece) {
    pieces += fmt::format(R"(<Piece Source="{}.vtp"/>)", piece);
    write(folder / fmt::format("{}.vtp", piece), vtp(1, count / 5));
  }
  write(folder / "all.pvtp", R"(<VTKFile type="PPolyData"><PPolyData>)" + pieces + "</PPolyData></VTKFile>");
  const std::size_t held = most_held([&] { read_datasets(folder / "all.pvtp"); });
  EXPECT_LE(held, most_for(count));
}

TEST(RowsOfManyTimes, ArePartedWithoutASecondCopy) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "a sanitizer keeps what is freed";
#endif
  const auto part = [] {
    Dataset whole{.arrays = {{.name = "x"}, {.name = "t"}}};
    for (Array& array : whole.arrays) array.values.assign(count / 2, 1);
    for (std::size_t k = 0; k < count / 2; ++k) whole.arrays[1].values[k] = static_cast<double>(k % 3);
    if (parted_by_time(std::move(whole)).size() != 3) throw Unreadable("not of three times");
  };
  EXPECT_LE(most_held(part), most_for(count));
}

}  // namespace memory_test
}  // namespace touchstone::vnv::doors
