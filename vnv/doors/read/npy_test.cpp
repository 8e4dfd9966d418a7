#include "vnv/doors/read/npy.hpp"

#include "vnv/doors/read/vtk_testing.hpp"

#include <gtest/gtest.h>

namespace touchstone::vnv::doors {
namespace npy_test {

std::filesystem::path sample(const std::string& name) { return vtk::all_formats() / "npy" / name; }

std::vector<Dataset> read(const std::string& name) {
  return read_npy(sample(name), files::read_whole(sample(name)), {});
}
std::string refusal(const std::string& bytes, const Limits& limits = {}) {
  return vtk::refusal([&] { read_npy("a.npz", bytes, limits); });
}
bool says(const std::string& text, const std::string& part) { return text.find(part) != text.npos; }

/// As samples/npy/make_samples.py gives them.
const std::vector<double> x{0.25, 0.125, 0.75, 0.5, 1. / 3, 1e-300}, v{1, -2, 0.1, 0.2, 3, -0.0},
    p{101325, -1.5, 1. / 7};

void expect_array(const Dataset& data, const std::string& name, int components, const std::vector<double>& values) {
  const Array* array = data.array(name);
  ASSERT_NE(array, nullptr) << name;
  EXPECT_EQ(array->components, components) << name;
  EXPECT_TRUE(vtk::same_bits(array->values, values)) << name;
}

TEST(NumpyFiles, HoldTheSameNumbersHoweverTheyWereWritten) {
  for (const char* name : {"plain.npz", "compressed.npz", "big_endian_fortran.npz"}) {
    const std::vector<Dataset> all = read(name);
    ASSERT_EQ(all.size(), 1u) << name;
    EXPECT_EQ(all[0].time, 0.5) << name;
    expect_array(all[0], "x", 2, x);
    expect_array(all[0], "v", 2, v);
    expect_array(all[0], "p", 1, p);
  }
  expect_array(read("whole_numbers.npy")[0], "whole_numbers", 2, {1, -2, 3, 40000});
  expect_array(read("single.npy")[0], "single", 2, {1, -2, 0.1f, 0.2f, 3, -0.0});
}

TEST(NumpyFiles, HoldPickledDictionariesOfEachProtocol) {
  for (const char* name : {"pickled_2.npy", "pickled_3.npy", "pickled_4.npy", "pickled_5.npy"}) {
    const std::vector<Dataset> all = read(name);
    ASSERT_EQ(all.size(), 1u) << name;
    EXPECT_EQ(all[0].part, "fluid") << name;
    EXPECT_EQ(all[0].time, 0.5) << name;
    expect_array(all[0], "x", 1, {0.25, 0.75, 1. / 3});
    expect_array(all[0], "p", 1, p);
  }
}

TEST(NumpyFiles, OfPySphHoldEachKindOfParticlesWithTimeAndIndex) {
  const std::vector<Dataset> all = read("pysph_12.npz");
  ASSERT_EQ(all.size(), 2u);
  EXPECT_EQ(all[0].part, "fluid");
  EXPECT_EQ(all[1].part, "wall");
  EXPECT_EQ(all[0].time, 0.5);
  EXPECT_EQ(all[0].index, 12);
  expect_array(all[0], "x", 1, {0.25, 0.75, 1. / 3});
  expect_array(all[0], "m", 1, {1, 2, 3});
  expect_array(all[1], "y", 1, {-0.5, -0.5});
}

/// A .npy file of one object whose pickle this is.
std::string pickled(const std::string& pickle) {
  std::string header = "{'descr': '|O', 'fortran_order': False, 'shape': (), }";
  header.resize(118, ' ');
  return std::string("\x93NUMPY\x01\x00\x76\x00", 10) + header + pickle;
}

TEST(NumpyFiles, RunNothingThatAPickleAsksFor) {
  EXPECT_TRUE(says(refusal(pickled("cos\nsystem\n(S'touch pwned'\ntR.")),
                   "asks for 'os.system', expected only what makes arrays of NumPy"));
  EXPECT_TRUE(says(refusal(pickled("\x80\x04\x8c\x08"
                                   "builtins\x8c\x04"
                                   "eval\x93.")),
                   "asks for 'builtins.eval'"));
  EXPECT_TRUE(says(refusal(pickled("cnumpy\nndarray\n)R.")), "calls 'ndarray'"));
  EXPECT_TRUE(says(refusal(pickled("i")), "instruction 0x69, which NumPy does not write"));
  EXPECT_TRUE(says(refusal(pickled(std::string("\x80\x09.", 3))), "protocol 9, expected 0 to 5"));
  EXPECT_TRUE(says(refusal(pickled("h\x01.")), "recalls what was not kept"));
  EXPECT_TRUE(says(refusal(pickled("X\xff\xff\xff\x7f"
                                   "abc")),
                   "ends too early"));
  EXPECT_TRUE(says(refusal(pickled("")), "ends too early"));
  std::string deep;
  for (int k = 0; k < 20; ++k)
    deep += std::string(
        "}X\x01\x00\x00\x00"
        "a",
        7);
  deep += 'N';
  for (int k = 0; k < 20; ++k) deep += 's';
  EXPECT_TRUE(says(refusal(pickled(deep + ".")), "dictionaries nine deep"));
  EXPECT_TRUE(says(refusal(pickled(std::string("}q\x01X\x01\x00\x00\x00"
                                               "ah\x01s.",
                                               13))),
                   "nine deep"))
      << "one within itself";
}

TEST(NumpyFiles, AreRefusedInOneLineWhereTheyLie) {
  const std::string single = files::read_whole(sample("single.npy"));
  const auto changed = [&](const std::string& from, const std::string& to) {
    std::string bytes = single;
    return bytes.replace(bytes.find(from), from.size(), to);
  };
  EXPECT_TRUE(says(refusal(changed("(3, 2)", "(9, 2)")), "'a' has 24 bytes, expected 18 numbers of 4"));
  EXPECT_TRUE(says(refusal(changed("(3, 2)", "(99999999999999999999, 2)")), "a.npz: a: "));
  EXPECT_TRUE(says(refusal(changed("<f4", "<c8")), "elements of type '<c8', expected numbers of 1 to 8 bytes"));
  EXPECT_TRUE(says(refusal(changed("descr", "deskr")), "no 'descr' in the header"));
  EXPECT_TRUE(says(refusal(single.substr(0, 60)), "ends within its header"));
  const std::string archive = files::read_whole(sample("plain.npz"));
  EXPECT_TRUE(says(refusal(archive.substr(0, 700)), "no ZIP archive"));
  EXPECT_TRUE(says(refusal(archive, {.most_bytes = 300}), "expected at most 300 in all"));
}

}  // namespace npy_test
}  // namespace touchstone::vnv::doors
