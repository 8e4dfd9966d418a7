#include "vnv/doors/judge.hpp"
#include "vnv/doors/read/most_held.hpp"
#include "vnv/files/whole_file.hpp"
#include "vnv/programs/scratch_folder.hpp"

#include <fmt/format.h>

namespace touchstone::vnv::doors {
namespace memory_of_judging_test {

constexpr std::size_t across = 700, rows = across * across;  // of vortices in a square of 1 m

Vec2 place(std::size_t row) {
  return Vec2(0.5 + static_cast<double>(row % across), 0.5 + static_cast<double>(row / across)) / across;
}

/// Six numbers a row, to the last digit.
std::string csv() {
  std::string text = "x,y,vx,vy,p,rho\n";
  for (std::size_t row = 0; row < rows; ++row)
    text += fmt::format("{0:.17g},{1:.17g},{0:.17g},{1:.17g},{0:.17g},1000\n", place(row).x(), place(row).y());
  return text;
}

/// Raw: places and velocities, of three numbers each, and pressures.
std::string vtp() {
  constexpr std::string_view array =
      R"(<DataArray type="Float64" Name="{}" NumberOfComponents="{}" format="appended" offset="{}"/>)";
  const std::size_t three = 8 + 24 * rows;  // bytes, with how many there are
  std::string bytes = fmt::format(
      R"(<VTKFile type="PolyData" byte_order="LittleEndian" header_type="UInt64"><PolyData><Piece NumberOfPoints="{}">)"
      "<Points>{}</Points><PointData>{}{}</PointData></Piece></PolyData>"
      R"(<AppendedData encoding="raw">_)",
      rows, fmt::format(array, "Points", 3, 0), fmt::format(array, "velocity", 3, three),
      fmt::format(array, "pressure", 1, 2 * three));
  const auto append = [&](const auto& number) { bytes.append(reinterpret_cast<const char*>(&number), sizeof(number)); };
  for (const std::size_t components : {3, 3, 1}) {
    append(8 * components * rows);
    for (std::size_t row = 0; row < rows; ++row)
      for (std::size_t k = 0; k < components; ++k) append(k < 2 ? place(row)[static_cast<Eigen::Index>(k)] : 0.);
  }
  return bytes + "</AppendedData></VTKFile>";
}

TEST(JudgingAFile, TakesThreeTimesItsNumbersAtMost) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "a sanitizer keeps what is freed";
#endif
  const programs::ScratchFolder folder;
  for (const auto& [name, text, columns] : {std::tuple("all.csv", &csv, 6), std::tuple("all.vtp", &vtp, 7)}) {
    const std::filesystem::path file = folder / name;
    files::write_whole(file, text());
    const auto judge = [&] {
      const Judgement judgement =
          judge_files(flow_named("taylor_green"), {file}, {.time = 1}, {}, {.at_most = 1, .diagnose = true});
      if (judgement.record.values.empty() || judgement.record.diagnoses.size() != 2)
        throw Unreadable("not judged, or not diagnosed");
    };
    const auto numbers = static_cast<double>(8 * rows * static_cast<std::size_t>(columns));  // bytes
    const double times = static_cast<double>(most_held(judge)) / numbers;
    EXPECT_LE(times, 3) << name;
    RecordProperty(name, fmt::format("{:.2f}", times));
  }
}

}  // namespace memory_of_judging_test
}  // namespace touchstone::vnv::doors
