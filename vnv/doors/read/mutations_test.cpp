#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>

#include "vnv/doors/read/delimited.hpp"
#include "vnv/doors/read/hdf5.hpp"
#include "vnv/doors/read/lammps.hpp"
#include "vnv/doors/read/npy.hpp"
#include "vnv/doors/read/parts/gzip.hpp"
#include "vnv/doors/read/parts/pickle.hpp"
#include "vnv/doors/read/series.hpp"
#include "vnv/doors/read/testing.hpp"
#include "vnv/doors/read/vtk_legacy.hpp"
#include "vnv/doors/read/vtk_xml.hpp"

namespace touchstone::vnv::doors {
namespace mutations_test {

namespace fs = std::filesystem;

std::vector<fs::path> all_samples() {
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(samples()))
    if (entry.is_regular_file() && entry.path().filename().string().find("make_") != 0 &&
        entry.path().extension() != ".md")
      files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

/// One change of a few: a byte, a number, an end too early, a part that is twice there or is not there.
std::string mutated(std::string bytes, std::mt19937& random) {
  const auto place = [&] { return random() % bytes.size(); };
  switch (random() % 5) {
    case 0:
      bytes[place()] = static_cast<char>(random());
      break;
    case 1:
      bytes.resize(place());
      break;
    case 2:
      bytes.erase(place(), random() % 40);
      break;
    case 3:
      bytes.insert(place(), bytes.substr(place(), random() % 40));
      break;
    default: {
      const std::size_t digit = bytes.find_first_of("0123456789", place());
      constexpr std::array<const char*, 6> numbers = {"-1", "0", "4294967295", "18446744073709551615", "1e999", "nan"};
      if (digit != bytes.npos) bytes.replace(digit, 1, numbers[random() % numbers.size()]);
    }
  }
  return bytes;
}

using Reader = std::vector<Dataset> (*)(const fs::path&, std::string_view, const Limits&);

Reader read_as(const std::string& extension) {
  const std::map<std::string, Reader> readers = {
      {".vtk", read_vtk_legacy},
      {".series", read_series},
      {".npy", read_npy},
      {".npz", read_npz},
      {".lammpstrj", read_lammps},
      {".csv", read_delimited},
      {".tsv", read_delimited},
      {".txt", read_delimited},
      {".h5", read_hdf5},
      {".hdf5", read_hdf5},
      {".pickle", [](const fs::path& file, std::string_view bytes, const Limits&) {
         Pickle(bytes, file.string());
         return std::vector<Dataset>{};
       }}};
  if (const auto known = readers.find(extension); known != readers.end()) return known->second;
  if (extension.starts_with(".vt") || extension.starts_with(".pv")) return read_vtk_xml;
  throw std::logic_error(extension + ": a sample that no reader is named for here");
}

/// Datasets of equally many rows, or one line that says why there are none.
void expect_rows_or_one_line(const fs::path& file, const std::string& bytes) {
  const Limits limits{.most_bytes = 1 << 24};
  const std::string extension = file.extension().string();
  try {
    const std::vector<Dataset> datasets = read_as(extension)(file, bytes, limits);
    for (const Dataset& dataset : datasets)
      for (const Array& array : dataset.arrays) ASSERT_EQ(array.rows(), dataset.rows()) << file << " " << array.name;
  } catch (const Unreadable& error) {
    const std::string_view line = error.what();
    EXPECT_TRUE(std::none_of(line.begin(), line.end(), [](unsigned char c) { return c < ' '; })) << line;
    EXPECT_NE(line.find(": "), line.npos) << line;
  }
}

TEST(MutatedSamples, AreReadOrRefusedInOneLine) {
  std::mt19937 random(1);
  const std::vector<fs::path> all = all_samples();
  EXPECT_GT(all.size(), 100u);
  for (fs::path file : all) {
    std::string bytes = files::read_whole(file);
    if (file.extension() == ".gz") {
      for (int i = 0; i < 50; ++i) EXPECT_NE(refusal([&] { gunzipped("a", mutated(bytes, random), {}); }), "a");
      bytes = gunzipped(file.string(), bytes, {});
      file.replace_extension();
    }
    expect_rows_or_one_line(file, bytes);
    const int times = bytes.starts_with(hdf5_begins) ? 10 : 50;  // a process each
    for (int i = 0; i < times; ++i) expect_rows_or_one_line(file, mutated(bytes, random));
  }
}

}  // namespace mutations_test
}  // namespace touchstone::vnv::doors
