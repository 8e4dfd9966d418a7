#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>

#include "vnv/doors/read/parts/gzip.hpp"
#include "vnv/doors/read/testing.hpp"

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

/// Whether it is read, into datasets of equally many rows; else one line has to say why not.
bool is_read_or_refused(const Format& format, const fs::path& file, const std::string& bytes) {
  try {
    const std::vector<Dataset> datasets = read_as(format, file, bytes, {.most_bytes = 1 << 24});
    for (const Dataset& dataset : datasets)
      for (const Array& array : dataset.arrays) EXPECT_EQ(array.rows(), dataset.rows()) << file << " " << array.name;
    return true;
  } catch (const Unreadable& error) {
    const std::string_view line = error.what();
    EXPECT_TRUE(std::none_of(line.begin(), line.end(), [](unsigned char c) { return c < ' '; })) << line;
    EXPECT_NE(line.find(": "), line.npos) << line;
    return false;
  }
}

TEST(MutatedSamples, AreReadOrRefusedInOneLine) {
  std::mt19937 random(1);
  const std::vector<fs::path> all = all_samples();
  EXPECT_GT(all.size(), 100u);
  std::set<std::string_view> read;
  for (fs::path file : all) {
    std::string bytes = files::read_whole(file);
    if (file.extension() == ".gz") {
      for (int i = 0; i < 50; ++i) EXPECT_NE(refusal([&] { gunzipped("a", mutated(bytes, random), {}); }), "a");
      bytes = gunzipped(file.string(), bytes, {});
      file.replace_extension();
    }
    const std::string ending = file.extension().string();
    const Format format = ending == ".pickle" ? format_named("pickle") : format_of(file, bytes);
    EXPECT_NE(std::ranges::find(format.endings, ending), format.endings.end())
        << file << " is told to be " << format.words;
    if (is_read_or_refused(format, file, bytes)) read.insert(format.words);
    const int times = format.may_crash ? 10 : 50;  // a process each
    for (int i = 0; i < times; ++i) is_read_or_refused(format, file, mutated(bytes, random));
  }
  for (const auto& [name, format] : all_formats())
    EXPECT_TRUE(read.contains(format().words)) << name << ": expected a sample that is read";
}

}  // namespace mutations_test
}  // namespace touchstone::vnv::doors
