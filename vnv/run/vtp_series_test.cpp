#include "vnv/run/vtp_series.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "vnv/doors/read/dataset.hpp"
#include "vnv/files/whole_file.hpp"

namespace touchstone::vnv {
namespace {

using namespace doors;

namespace fs = std::filesystem;

Samples some_samples(Index particles, double time) {
  Samples samples{.time = time};
  const Scalars numbers = Scalars::LinSpaced(particles, 0, static_cast<double>(particles - 1));
  samples.x.resize(2, particles);
  samples.x << numbers.sin().matrix().transpose(), numbers.cos().matrix().transpose();
  samples.v = 3 * samples.x.colwise().reverse();
  samples.mass = numbers / 7;
  samples.density = 1000 + numbers / 3;
  samples.pressure = -numbers;
  return samples;
}

void expect_same(const Samples& samples, const Dataset& read) {
  EXPECT_EQ(read.time, samples.time);
  ASSERT_EQ(read.rows(), static_cast<std::size_t>(samples.size()));
  for (std::size_t i = 0; i < read.rows(); ++i) {
    const auto p = static_cast<Index>(i);
    for (const Index axis : {0, 1}) {
      EXPECT_EQ(read.array(points_array)->values[3 * i + static_cast<std::size_t>(axis)], samples.x(axis, p));
      EXPECT_EQ(read.array("velocity")->values[3 * i + static_cast<std::size_t>(axis)], samples.v(axis, p));
    }
    EXPECT_EQ(read.array(points_array)->values[3 * i + 2], 0);
    EXPECT_EQ(read.array("pressure")->values[i], samples.pressure[p]);
    EXPECT_EQ(read.array("density")->values[i], samples.density[p]);
    EXPECT_EQ(read.array("mass")->values[i], samples.mass[p]);
    EXPECT_EQ(read.array("particle number")->values[i], static_cast<double>(i));
  }
}

class AVtpFile : public testing::Test {
 protected:
  AVtpFile() { fs::create_directories(folder_); }
  ~AVtpFile() override { fs::remove_all(folder_); }
  const fs::path folder_ = fs::path(testing::TempDir()) /
                           ("vtp." + std::string(testing::UnitTest::GetInstance()->current_test_info()->name()));
};

TEST_F(AVtpFile, WritesWhatOurReaderReadsBitForBit) {
  for (const Index particles : {1, 100, 20000}) {  // of one block and of several
    const Samples samples = some_samples(particles, 1. / 3);
    write_vtp(folder_ / "a.vtp", samples);
    const std::vector<Dataset> read = read_datasets(folder_ / "a.vtp");
    ASSERT_EQ(read.size(), 1u);
    EXPECT_EQ(read[0].format, "VTP, appended raw, zlib");
    expect_same(samples, read[0]);
  }
  write_vtp(folder_ / "none.vtp", some_samples(0, 0));
  EXPECT_EQ(read_datasets(folder_ / "none.vtp")[0].rows(), 0u);
}

TEST_F(AVtpFile, WritesASeriesThatOurReaderReads) {
  const std::vector<Samples> series = {some_samples(5, 0), some_samples(5, 0.1)};
  write_vtp_series(folder_ / "run", "sph", series);
  const std::vector<Dataset> read = read_datasets(folder_ / "run" / "sph.pvd");
  ASSERT_EQ(read.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) expect_same(series[i], read[i]);
  EXPECT_EQ(read[1].index, 1);
}

TEST_F(AVtpFile, WritesWhatVtkReads) {
  if (std::system("python3 -c 'import vtk' > /dev/null 2>&1") != 0) GTEST_SKIP() << "python3 has no module vtk";
  write_vtp(folder_ / "a.vtp", some_samples(20000, 0.375));
  files::write_whole(folder_ / "check.py", R"(import sys, math, vtk
reader = vtk.vtkXMLPolyDataReader()
reader.SetFileName(sys.argv[1])
reader.Update()
data = reader.GetOutput()
points, arrays = data.GetPointData(), {}
assert data.GetNumberOfPoints() == data.GetNumberOfVerts() == 20000
assert data.GetFieldData().GetArray("TimeValue").GetValue(0) == 0.375
for i in range(0, 20000, 999):
    x, y, z = data.GetPoint(i)
    assert abs(x - math.sin(i)) < 1e-14 and abs(y - math.cos(i)) < 1e-14 and z == 0
    assert data.GetCell(i).GetPointId(0) == i
    assert points.GetArray("velocity").GetTuple(i) == (3 * y, 3 * x, 0)
    assert points.GetArray("pressure").GetValue(i) == -i and points.GetArray("mass").GetValue(i) == i / 7
    assert points.GetArray("density").GetValue(i) == 1000 + i / 3 and points.GetArray("particle number").GetValue(i) == i
)");
  EXPECT_EQ(
      std::system(fmt::format("python3 {} {}", (folder_ / "check.py").string(), (folder_ / "a.vtp").string()).c_str()),
      0);
}

TEST_F(AVtpFile, SaysWhereItCannotWrite) {
  EXPECT_THROW(write_vtp(folder_ / "nowhere" / "a.vtp", some_samples(1, 0)), std::runtime_error);
}

}  // namespace
}  // namespace touchstone::vnv
