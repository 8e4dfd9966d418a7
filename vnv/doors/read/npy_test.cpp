#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "vnv/doors/read/parts/pickle.hpp"
#include "vnv/doors/read/testing.hpp"

namespace touchstone::vnv::doors {
namespace npy_test {

std::string bytes_of_sample(const std::string& name) { return files::read_whole(samples() / "npy" / name); }
std::vector<Dataset> read(const std::string& name) { return read_datasets(samples() / "npy" / name); }
std::string refusal_of_npy(const std::string& bytes) {
  return refusal([&] { read_as("npy", "a.npy", bytes, {}); });
}
std::string refusal_of_npz(const std::string& bytes, const Limits& limits = {}) {
  return refusal([&] { read_as("npz", "a.npz", bytes, limits); });
}

TEST(Npy, GivesTheSameNumbersOfEveryTypeAndOrderOfBytes) {
  for (const char* type : {"f2", "f4", "f8", "i1", "i2", "i4", "i8", "u1", "u2", "u4", "u8", "b1"})
    for (const char* order : {"little", "big"}) {
      const std::vector<Dataset> found = read(fmt::format("{}_{}.npy", type, order));
      const bool is_bool = std::string_view(type) == "b1";
      EXPECT_EQ(found.at(0).array("column 1")->values,
                is_bool ? (std::vector<double>{0, 1, 0, 1, 0}) : (std::vector<double>{1, 4, 7, 10, 13}))
          << type << " " << order;
    }
}

TEST(Npy, GivesColumnsOfATableInEitherOrderAndVersion) {
  for (const char* name : {"table_c.npy", "table_fortran.npy", "version_2.npy", "version_3.npy", "table.npz"}) {
    const std::vector<Dataset> found = read(name);
    ASSERT_EQ(found.at(0).arrays.size(), 4u) << name;
    for (std::size_t k = 0; k < 4; ++k) {
      EXPECT_EQ(found[0].arrays[k].name, fmt::format("column {}", k + 1));
      EXPECT_EQ(found[0].arrays[k].values, five("xyuv"[k])) << name;
    }
  }
}

TEST(Npz, GivesArraysByTheirNamesWithTheirTime) {
  for (const char* name : {"columns.npz", "columns_deflated_12.npz"}) {
    const std::vector<Dataset> found = read(name);
    ASSERT_EQ(found.size(), 1u);
    for (const char column : {'x', 'y', 'u', 'v'}) EXPECT_EQ(found[0].array({column})->values, five(column)) << name;
    EXPECT_EQ(found[0].time, 0.25);
  }
  EXPECT_EQ(read("columns_deflated_12.npz")[0].index, 12);
  const Dataset vectors = read("vectors.npz").at(0);
  EXPECT_EQ(vectors.time, 0.1);
  EXPECT_EQ(vectors.array("vel")->components, 2);
  for (std::size_t k = 0; k < 5; ++k) {
    EXPECT_EQ(vectors.array("pos")->values[2 * k + 1], five('y')[k]);
    EXPECT_EQ(vectors.array("vel")->values[2 * k], five('u')[k]);
  }
}

TEST(Npz, PartsRowsByTheirTimeAndGridsIntoPoints) {
  const std::vector<Dataset> times = read("times.npz");
  ASSERT_EQ(times.size(), 2u);
  EXPECT_EQ(times[0].time, 0.1);
  EXPECT_EQ(times[0].array("x")->values, (std::vector<double>{five('x')[1], five('x')[3]}));
  const Dataset grid = read("grid.npz").at(0);
  EXPECT_EQ(grid.rows(), 15u);
  EXPECT_EQ(grid.array("u")->components, 1);
  EXPECT_EQ(grid.array("u")->values[6], five('x')[1] + five('y')[1]);
}

TEST(Npz, GivesRealParticlesOfPysphWithTheNameOfTheirArray) {
  for (const char* name : {"pysph_7.npz", "pysph_deflated_7.npz"}) {
    const Dataset found = read(name).at(0);
    EXPECT_EQ(found.time, 0.1 * 3);
    EXPECT_EQ(found.index, 7);
    EXPECT_EQ(found.format, "NPZ of PySPH");
    const Array& of = *found.array("array");
    ASSERT_EQ(found.rows(), 6u) << "four of five are real, and two of the wall";
    EXPECT_EQ(of.labels, (std::vector<std::string>{"fluid", "wall"}));
    EXPECT_EQ(of.values, (std::vector<double>{0, 0, 0, 0, 1, 1}));
    EXPECT_EQ(found.array("u")->values[2], 2 / 3.);
    EXPECT_EQ(found.array("stress")->components, 2);
    EXPECT_EQ(found.array("stress")->values[3], 3 / 8.);
    EXPECT_TRUE(std::isnan(found.array("stress")->values[8])) << "the wall has none";
    EXPECT_EQ(found.array("y")->values[5], -0.5);
  }
}

TEST(Npy, IsRefusedInOneLineWhereItsHeaderLies) {
  const std::string good = bytes_of_sample("table_c.npy");
  EXPECT_EQ(refusal_of_npy(good), "");
  EXPECT_EQ(refusal_of_npy(with(good, "(5, 4)", "(6, 4)")), "a.npy: '160' bytes, expected 24 numbers of 8");
  EXPECT_EQ(refusal_of_npy(with(good, "(5, 4)", "(5, 3)")), "a.npy: '160' bytes, expected 15 numbers of 8");
  EXPECT_EQ(refusal_of_npy(with(good, "(5, 4), }               ", "(4294967296, 4294967296)")),
            "a.npy: a shape of more numbers than its 160 bytes, expected no more");
  EXPECT_EQ(refusal_of_npy(with(good, "(5, 4)", "(-5,4)")), "a.npy: shape: '-5', expected a whole number from 0");
  EXPECT_EQ(refusal_of_npy(with(good, "(5, 4)", "(5,2,2)")), "a.npy: '3' dimensions, expected 1 or 2");
  EXPECT_EQ(refusal_of_npy(with(good, "<f8", "<c8")),
            "a.npy: type '<c8', expected f2, f4, f8, i1 to i8, u1 to u8 or b1");
  EXPECT_EQ(refusal_of_npy(with(good, "<f8", "|O8")), "a.npy: type 'O', expected numbers");
  EXPECT_EQ(refusal_of_npy(with(good, "shape", "shade")), "a.npy: no 'shape' in its header, expected one");
  EXPECT_EQ(refusal_of_npy(good.substr(0, 250)), "a.npy: '122' bytes, expected 20 numbers of 8");
  EXPECT_EQ(refusal_of_npy(good.substr(0, 50)), "a.npy: a header of '118' bytes, expected no more than 40");
  EXPECT_EQ(refusal_of_npy(with(good, "\x01", "\x04")), "a.npy: version '4', expected 1, 2 or 3");
}

TEST(Npz, IsRefusedInOneLineWhereItsEntriesLie) {
  const std::string good = bytes_of_sample("columns_deflated_12.npz");
  EXPECT_EQ(refusal_of_npz(good), "");
  EXPECT_EQ(refusal_of_npz(good.substr(0, 900)).find("a.npz: "), 0u);
  EXPECT_EQ(refusal_of_npz(good, {.most_bytes = 500}).find("a.npz: 'y.npy': '168' bytes out of "), 0u);
  std::string large = good;  // the first entry says in the central directory that it holds 2 GB
  const std::size_t size_at = large.find("PK\x01\x02") + 24;
  large.replace(size_at, 4, std::string("\0\0\0\x7f", 4));
  EXPECT_EQ(refusal_of_npz(large).find("a.npz: "), 0u);
  std::string wrong = good;  // a byte of what is compressed
  wrong[wrong.find("t.npy") + 60] ^= 1;
  EXPECT_EQ(refusal_of_npz(wrong).find("a.npz: '"), 0u);
  EXPECT_EQ(refusal_of_npz(bytes_of_sample("objects.npz")),
            "a.npz: 'x.npy': objects of Python, expected numbers, or 'particles' and 'solver_data' of PySPH");
  const std::string none = refusal_of_npz("PK\x03\x04");  // why is said by libzip, whose words change with its version
  EXPECT_TRUE(none.starts_with("a.npz: ") && none.ends_with(", expected a zip file of numpy's arrays")) << none;
}

TEST(Npz, TakesTheNameOfAnEntryForNoMoreThanAName) {
  std::string bytes = bytes_of_sample("vectors.npz");
  for (int i = 0; i < 2; ++i) bytes = with(bytes, "pos.npy", "../pos.");
  EXPECT_NE(read_as("npz", "a.npz", bytes, {}).at(0).array("../pos."), nullptr);
}

std::string refusal_of_pickle(const std::string& bytes) {
  return refusal([&] { Pickle(bytes, "a"); });
}

TEST(Pickled, DictionariesAreReadOfProtocols2To5) {
  for (int protocol = 2; protocol <= 5; ++protocol) {
    const std::string bytes = bytes_of_sample(fmt::format("protocol_{}.pickle", protocol));
    const Pickle pickle(bytes, "a");
    const auto at = [&](const char* key) { return Pickle::value(&pickle.root(), key); };
    Budget budget(Limits{});
    const std::vector<double> table = numpy::numbers_of(at("c")->array, budget, "c");
    EXPECT_EQ(table, numpy::numbers_of(at("f")->array, budget, "f"));
    ASSERT_EQ(table.size(), 20u);
    EXPECT_EQ(table[14], five('u')[3]);
    EXPECT_EQ(numpy::numbers_of(at("big")->array, budget, "big")[3],
              static_cast<double>(static_cast<float>(five('x')[3])));
    EXPECT_EQ(at("nothing")->is, Pickle::Object::Is::none);
    const auto& list = at("list")->items;
    ASSERT_EQ(list.size(), 6u);
    EXPECT_EQ(list[1]->number, -300);
    EXPECT_EQ(list[2]->number, 2.5);
    EXPECT_EQ(list[3]->number, 1);
    EXPECT_EQ(list[4]->text, "\xe9");
    EXPECT_EQ(list[5]->text, "\xc3\xa9");
    EXPECT_EQ(at("far")->number, std::pow(2, 40));
    EXPECT_EQ(at("none such"), nullptr);
  }
}

TEST(Pickled, NamesThatAreNotNumpysAreRefused) {
  const auto expect = [](const std::string& name, const std::string& bytes) {
    EXPECT_EQ(refusal_of_pickle(bytes),
              fmt::format("a: byte {} of its pickle: the name '{}', expected plain numbers, texts, lists, dictionaries "
                          "and numpy's arrays",
                          bytes.find('|'), name));
  };
  expect("os.system",
         "\x80\x02"
         "cos\nsystem\n|X\x04\0\0\0true\x85R.");
  expect("builtins.eval",
         "\x80\x04\x8c\x08"
         "builtins\x8c\x04"
         "eval\x93|.");
  expect("numpy.core.multiarray.fromfile",
         "\x80\x02"
         "cnumpy.core.multiarray\nfromfile\n|.");
  for (const char opcode : {'i', 'o', 'P', 'Q', 'I', 'S', 'V', '\x81', '\x82', '\x92', '\x97', '2'})
    EXPECT_NE(refusal_of_pickle(fmt::format("\x80\x02N{}\n\n.", opcode)).find("opcode"), std::string::npos) << opcode;
}

TEST(Pickled, LiesAreRefusedInOneLine) {
  const std::string name = "cnumpy.core.multiarray\n_reconstruct\n";
  for (const auto& [bytes, message] : std::vector<std::pair<std::string, std::string>>{
           {"", "0 of its pickle: '2' bytes, expected no more than 0"},
           {"\x80\x01N.", "2 of its pickle: protocol '1', expected a pickle of protocol 2 to 5"},
           {"\x80\x02.", "3 of its pickle: takes from an empty stack, expected an object on it"},
           {"\x80\x02N", "3 of its pickle: '1' bytes, expected no more than 0"},
           {"\x80\x02X\xff\xff\xff\xff", "7 of its pickle: '4294967295' bytes, expected no more than 0"},
           {"\x80\x02t.", "3 of its pickle: no mark, expected one"},
           {"\x80\x02h\x07.", "4 of its pickle: recalls '7', expected what it memorised"},
           {"\x80\x02]NNs.", "6 of its pickle: adds to what it cannot, expected a list or a dictionary"},
           {"\x80\x02N(0.", "5 of its pickle: takes from an empty stack, expected an object on it"},
           {"\x80\x02)NR.", "5 of its pickle: calls what is no function of numpy, expected one"},
           {"\x80\x02" + name + ")R(K\x01Nb.",
            "45 of its pickle: a state of other parts than numpy gives it, expected those"},
           {"\x80\x02" + name + ")R)b.",
            "42 of its pickle: a state of other parts than numpy gives it, expected those"},
           {"\x80\x02\x8a\x09", "4 of its pickle: '9' bytes, expected no more than 0"}})
    EXPECT_EQ(refusal_of_pickle(bytes), "a: byte " + message);
  EXPECT_NE(refusal_of_pickle("\x80\x02" + std::string(100001, 'N') + ".").find("no more than 100000 objects"),
            std::string::npos);
  const std::string circle = "\x80\x02]q" + std::string(1, '\0') + "h" + std::string(1, '\0') + "a.";
  EXPECT_EQ(refusal_of_pickle(circle), "") << "a list in itself is no harm where none follows it";
}

}  // namespace npy_test
}  // namespace touchstone::vnv::doors
