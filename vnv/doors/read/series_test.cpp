#include <fmt/format.h>
#include <gtest/gtest.h>

#include <fstream>

#include "vnv/doors/read/vtk_testing.hpp"

namespace touchstone::vnv::doors::vtk {
namespace series_test {

namespace fs = std::filesystem;

TEST(Series, ReadsThoseThatFoamToVtkWritesWithTheirTimes) {
  for (const char* name : {"xml/cavity.vtm.series", "xml_ascii/cavity.vtm.series", "legacy/cavity.vtk.series",
                           "legacy_ascii/cavity.vtk.series"}) {
    SCOPED_TRACE(name);
    const std::vector<Dataset> read = read_sample(std::string("openfoam/") + name);
    ASSERT_EQ(read.size(), 4u);  // points and cells of two times
    EXPECT_EQ(read[0].rows_are, Rows::particles);
    EXPECT_EQ(read[1].rows_are, Rows::cells);
    EXPECT_EQ(read[1].time, 0.01);
    EXPECT_EQ(read[3].time, 0.02);
    EXPECT_EQ(read[3].index, 4);
  }
  EXPECT_EQ(read_sample("openfoam/xml/cavity.vtm.series")[0].source,
            "cavity.vtm.series: cavity_2.vtm: cavity_2/internal.vtu");
}

class ASeries : public testing::Test {
 protected:
  ASeries() {
    fs::create_directories(folder_ / "below");
    fs::copy_file(sample("particles_appended_zlib_64.vtp"), folder_ / "a.vtp", fs::copy_options::overwrite_existing);
    fs::copy_file(sample("particles_binary.vtk"), folder_ / "below" / "b.vtk", fs::copy_options::overwrite_existing);
  }
  ~ASeries() override { fs::remove_all(outer_); }

  std::vector<Dataset> read(const std::string& text, const std::string& name = "run.pvd",
                            const Limits& limits = {}) const {
    std::ofstream(folder_ / name) << text;
    return read_as("series", folder_ / name, text, limits);
  }
  /// What it says of the series, without where the folder is.
  std::string refusal_of(const std::string& text, const std::string& name = "run.pvd",
                         const Limits& limits = {}) const {
    std::string message = refusal([&] { read(text, name, limits); });
    if (message.starts_with(folder_.string())) message.erase(0, folder_.string().size() + 1);
    return message;
  }
  static std::string collection(const std::string& file, const std::string& time = "0.5") {
    return fmt::format(
        R"(<VTKFile type="Collection"><Collection><DataSet timestep="{}" file="{}"/></Collection></VTKFile>)", time,
        file);
  }

  const fs::path outer_ = fs::path(testing::TempDir()) /
                          ("series." + std::string(testing::UnitTest::GetInstance()->current_test_info()->name()));
  const fs::path folder_ = outer_ / "run";
};

TEST_F(ASeries, OverridesTheTimesOfItsFilesAndOrdersThem) {
  const std::vector<Dataset> read_ones = read(
      R"(<VTKFile type="Collection"><Collection><DataSet timestep="2" file="a.vtp"/><DataSet timestep="1e-1" file="below/b.vtk"/></Collection></VTKFile>)");
  ASSERT_EQ(read_ones.size(), 2u);
  EXPECT_EQ(read_ones[0].time, 0.1);
  EXPECT_EQ(read_ones[0].index, 1);
  EXPECT_EQ(read_ones[0].source, "run.pvd: b.vtk");
  EXPECT_EQ(read_ones[1].time, 2);
  EXPECT_EQ(read(R"({"files": [{"name": "a.vtp"}]})", "run.vtp.series")[0].time, 0.125);  // that of the file
}

TEST_F(ASeries, ReadsNothingOutsideItsFolder) {
  fs::copy_file(folder_ / "a.vtp", outer_ / "a.vtp");
  fs::create_symlink(outer_ / "a.vtp", folder_ / "link.vtp");
  fs::create_directory_symlink(outer_, folder_ / "out");
  EXPECT_EQ(refusal_of(collection("../a.vtp")),
            "run.pvd: file '../a.vtp', expected a path below the folder of the file that names it");
  EXPECT_EQ(refusal_of(collection((folder_ / "a.vtp").string())).find(", expected a path below the folder") !=
                std::string::npos,
            true);
  EXPECT_EQ(refusal_of(collection("")), "run.pvd: file '', expected a path below the folder of the file that names it");
  EXPECT_EQ(refusal_of(collection("link.vtp")),
            "run.pvd: file 'link.vtp', expected a file within the folder, where no link leads out of it");
  EXPECT_EQ(refusal_of(collection("out/a.vtp")),
            "run.pvd: file 'out/a.vtp', expected a file within the folder, where no link leads out of it");
  EXPECT_EQ(refusal_of(collection("none.vtp")), "run.pvd: file 'none.vtp', expected a file that is there");
  EXPECT_EQ(refusal_of(collection("below")), "run.pvd: file 'below', expected a regular file");
  const std::string parallel =
      R"(<VTKFile type="PPolyData"><PPolyData><Piece Source="../a.vtp"/></PPolyData></VTKFile>)";
  std::ofstream(folder_ / "p.pvtp") << parallel;
  EXPECT_EQ(refusal_of(collection("p.pvtp")),
            "p.pvtp: file '../a.vtp', expected a path below the folder of the file that names it");
}

TEST_F(ASeries, IncludesNeitherItselfNorAFileTwice) {
  const std::string again = ", expected each file once, and none that includes itself";
  EXPECT_EQ(refusal_of(collection("run.pvd")), "run.pvd: file 'run.pvd'" + again);
  EXPECT_EQ(refusal_of(collection("./below/../run.pvd")).find("expected a path below") != std::string::npos, true);
  EXPECT_EQ(refusal_of(R"({"files": [{"name": "a.vtp"}, {"name": "./a.vtp"}]})", "run.vtp.series"),
            "run.vtp.series: file './a.vtp'" + again);
  std::ofstream(folder_ / "other.pvd") << collection("run.pvd");
  EXPECT_EQ(refusal_of(collection("other.pvd")),
            "other.pvd: type 'Collection', expected PolyData, UnstructuredGrid or their parallel forms");
  std::ofstream(folder_ / "tree.vtm")
      << R"(<VTKFile type="vtkMultiBlockDataSet"><vtkMultiBlockDataSet><DataSet file="tree.vtm"/></vtkMultiBlockDataSet></VTKFile>)";
  EXPECT_EQ(refusal_of(collection("tree.vtm")), "tree.vtm: file 'tree.vtm'" + again);
}

TEST_F(ASeries, RefusesWhatIsNone) {
  EXPECT_EQ(refusal_of(collection("a.vtp", "soon")),
            "run.pvd: timestep of 'a.vtp': number 1 'soon', expected a number");
  EXPECT_EQ(refusal_of(collection("a.vtp", "inf")), "run.pvd: time 'inf' of 'a.vtp', expected a number");
  EXPECT_EQ(refusal_of("<VTKFile type=\"PolyData\"/>"), "run.pvd: type 'PolyData', expected Collection");
  EXPECT_EQ(refusal_of("{\"files\": [", "a.series"), "a.series: byte 12: expected JSON of a series of files");
  EXPECT_EQ(refusal_of("{\"files\": 1}", "a.series"), "a.series: no list 'files', expected one");
  EXPECT_EQ(refusal_of("{\"files\": [1]}", "a.series"), "a.series: files[0]: expected a 'name'");
  EXPECT_EQ(refusal_of(R"({"files": [{"name": "a.vtp", "time": "1"}]})", "a.series"),
            "a.series: files[0]: 'time' is no number, expected one");
  EXPECT_EQ(refusal_of("{\"files\": " + std::string(100000, '['), "a.series"),
            "a.series: JSON of more than 3 levels, expected a series of files");
  EXPECT_EQ(refusal_of(collection("a.vtp"), "run.pvd", {.most_datasets = 0}),
            "run.pvd: '1' files, expected no more than 0");
  EXPECT_EQ(refusal_of(collection("a.vtp"), "run.pvd", {.most_bytes = 200}),
            "run.pvd: file 'a.vtp', expected no more than 200 bytes");
}

}  // namespace series_test
}  // namespace touchstone::vnv::doors::vtk
