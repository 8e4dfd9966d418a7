#include <gtest/gtest.h>

#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstdlib>

#include "vnv/doors/read/parts/in_a_child.hpp"
#include "vnv/doors/read/testing.hpp"

namespace touchstone::vnv::doors {
namespace hdf5_test {

std::vector<Dataset> read(const std::string& name) { return read_datasets(samples() / "hdf5" / name); }
std::string refusal_of(const std::string& name, const Limits& limits = {}) {
  return refusal([&] { read_as("hdf5", "a.h5", files::read_whole(samples() / "hdf5" / name), limits); });
}

TEST(Hdf5, GivesNumbersOfEveryTypeWithTheirTime) {
  const Dataset found = read("columns_3.h5").at(0);
  EXPECT_EQ(found.time, 0.25);
  EXPECT_EQ(found.index, 3);
  EXPECT_EQ(found.arrays.size(), 26u) << "one number and a text are of no row";
  for (const char column : {'x', 'y', 'u', 'v'}) EXPECT_EQ(found.array({column})->values, five(column));
  for (const std::string type : {"f2", "f4", "f8", "i1", "i2", "i4", "i8", "u1", "u2", "u4", "u8"})
    for (const char* order : {"_little", "_big"})
      EXPECT_EQ(found.array(type + order)->values, (std::vector<double>{1, 4, 7, 10, 13})) << type << order;
}

TEST(Hdf5, GivesTheOnlyGroupAndWhatGzipMadeSmaller) {
  const Dataset found = read("latest.h5").at(0);
  EXPECT_EQ(found.source, "latest.h5: fluid");
  EXPECT_EQ(found.time, 0.1);
  EXPECT_EQ(found.array("pos")->components, 2);
  for (std::size_t k = 0; k < 5; ++k) {
    EXPECT_EQ(found.array("pos")->values[2 * k + 1], five('y')[k]);
    EXPECT_EQ(found.array("vel")->values[2 * k], five('u')[k]);
  }
}

TEST(Hdf5, GivesStepsOfH5PartInTheirOrder) {
  const std::vector<Dataset> steps = read("h5part.h5");
  ASSERT_EQ(steps.size(), 2u);
  EXPECT_EQ(steps[0].index, 2);
  EXPECT_EQ(steps[0].time, 0.25);
  EXPECT_EQ(steps[1].array("x")->values[1], 10.1);
}

TEST(Hdf5, GivesRealParticlesOfPysphAsItsNpzDoes) {
  const Dataset npz = read_datasets(samples() / "npy/pysph_7.npz").at(0);
  for (const char* name : {"pysph_7.hdf5.gz", "pysph_deflated_7.hdf5.gz"}) {
    const Dataset found = read(name).at(0);
    EXPECT_EQ(found.time, npz.time);
    EXPECT_EQ(found.index, 7);
    for (const char* array : {"x", "y", "u", "v", "tag", "array"})
      EXPECT_EQ(found.array(array)->values, npz.array(array)->values) << array;
    EXPECT_EQ(found.array("array")->labels, npz.array("array")->labels);
    EXPECT_EQ(found.array("stress")->components, 2);
    EXPECT_TRUE(std::isnan(found.array("stress")->values[8])) << "the wall has none";
  }
}

TEST(Hdf5, IsRefusedInOneLineWhatIsNotInTheFileOrNotRead) {
  EXPECT_EQ(refusal_of("external.h5"), "a.h5: 'u': numbers that stand in another file, expected them in this one");
  EXPECT_EQ(refusal_of("virtual.h5"), "a.h5: 'x': numbers that stand in another file, expected them in this one");
  EXPECT_EQ(refusal_of("lzf.h5"), "a.h5: 'x': filter '32000', expected gzip (1) or shuffle (2)");
  EXPECT_EQ(refusal_of("sparse.h5"),
            "a.h5: 'x': a shape (1099511627776) out of 0 bytes, expected no more than the file holds");
  EXPECT_EQ(refusal_of("columns_3.h5", {.most_bytes = 64}),
            "a.h5: 'f2_little': '5' rows of 1 numbers, expected no more than 64 bytes of numbers in a file");
  const std::string good = files::read_whole(samples() / "hdf5/columns_3.h5");
  for (const std::size_t size : {std::size_t{10}, good.size() / 2, good.size() - 1})
    EXPECT_TRUE(refusal([&] { read_as("hdf5", "a.h5", good.substr(0, size), {}); }).starts_with("a.h5: ")) << size;
}

TEST(AChild, MayCrashOrRunOnWithoutHarm) {
  const auto with = [](const std::function<void()>& harm) {
    return refusal([&] {
      read_in_a_child("a", 1, 1 << 26, [&] {
        harm();
        return std::vector<Dataset>{};
      });
    });
  };
  EXPECT_EQ(with([] {}), "");
  EXPECT_EQ(with([] { throw Unreadable("a: why"); }), "a: why");
  EXPECT_EQ(with([] { std::raise(SIGSEGV); }),
            "a: the library that reads it ended by signal 11, expected a file that it can read");
  EXPECT_EQ(with([] { std::raise(SIGKILL); }),
            "a: the library that reads it ended by signal 9, expected a file that it can read");
  EXPECT_EQ(with([] { std::_Exit(3); }),
            "a: the library that reads it ended with status 3, expected a file that it can read");
#ifndef __SANITIZE_ADDRESS__  // whose allocator ends a program that has no memory left
  EXPECT_EQ(with([] { std::vector<char>(1 << 27); }), "a: takes more than 67108864 bytes of memory");
#endif
  EXPECT_NE(with([] {
              const volatile bool runs = true;
              while (runs) {
              }
            }),
            "");
}

}  // namespace hdf5_test
}  // namespace touchstone::vnv::doors
