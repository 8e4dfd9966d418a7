#include "vnv/doors/read/npy.hpp"

#include "vnv/doors/read/pickle.hpp"

#include <fmt/format.h>
#include <zip.h>

#include <map>
#include <memory>

namespace touchstone::vnv::doors {
namespace {

using numpy::numbers_of;
using numpy::NumpyArray;
using numpy::Pickle;
using numpy::Pickled;
using Kind = Pickled::Kind;

/// One member of an archive, decompressed.
struct Member {
  std::string name, bytes;
};

std::vector<Member> members_of(std::string_view bytes, const std::string& where, const Limits& limits) {
  zip_error_t error{};
  zip_source_t* source = zip_source_buffer_create(bytes.data(), bytes.size(), 0, &error);
  const auto close = [](zip_t* zip) { zip_discard(zip); };
  const std::unique_ptr<zip_t, decltype(close)> zip(source ? zip_open_from_source(source, ZIP_RDONLY, &error) : nullptr,
                                                    close);
  if (!zip) {
    const std::string why = zip_error_strerror(&error);
    if (source) zip_source_free(source);
    zip_error_fini(&error);
    vtk::refuse(where, "no ZIP archive: " + why);
  }
  std::vector<Member> members;
  std::size_t left = limits.most_bytes;
  for (zip_int64_t k = 0; k < zip_get_num_entries(zip.get(), 0); ++k) {
    zip_stat_t stat{};
    if (zip_stat_index(zip.get(), static_cast<zip_uint64_t>(k), 0, &stat) != 0 || !(stat.valid & ZIP_STAT_SIZE))
      vtk::refuse(where, fmt::format("member {} of the archive has no size", k + 1));
    if (stat.size > left || members.size() >= limits.most_datasets)
      vtk::refuse(
          where, fmt::format("'{}' has {} bytes, expected at most {} in all", stat.name, stat.size, limits.most_bytes));
    if (stat.size > 1100 * (stat.comp_size + 1))  // more than deflation can do
      vtk::refuse(where, fmt::format("'{}' claims {} bytes of {}", stat.name, stat.size, stat.comp_size));
    left -= stat.size;
    Member member{stat.name, std::string(stat.size, '\0')};
    const auto close_file = [](zip_file_t* file) { zip_fclose(file); };
    const std::unique_ptr<zip_file_t, decltype(close_file)> file(
        zip_fopen_index(zip.get(), static_cast<zip_uint64_t>(k), 0), close_file);
    if (!file || zip_fread(file.get(), member.bytes.data(), stat.size) != static_cast<zip_int64_t>(stat.size))
      vtk::refuse(where, fmt::format("'{}' in the archive cannot be read", member.name));
    if (member.name.ends_with(".npy")) member.name.resize(member.name.size() - 4);
    members.push_back(std::move(member));
  }
  return members;
}

/// What stands behind a key of the header, which is a dictionary as Python writes it.
std::string_view value_of(std::string_view header, std::string_view key, const std::string& where) {
  const std::size_t at = header.find(fmt::format("'{}':", key));
  if (at == header.npos) vtk::refuse(where, fmt::format("no '{}' in the header of the array", key));
  std::string_view value = header.substr(at + key.size() + 3);
  value.remove_prefix(std::min(value.find_first_not_of(' '), value.size()));
  const std::size_t end = value.find_first_of(value.starts_with('(') ? ")" : value.starts_with('[') ? "]" : ",}");
  return value.substr(0, end);
}

/// The array of a .npy file, and its bytes, which for objects are a pickle.
NumpyArray array_in(std::string_view bytes, const std::string& where) {
  if (!bytes.starts_with("\x93NUMPY") || bytes.size() < 10) vtk::refuse(where, "no array of NumPy");
  const bool is_first = bytes[6] == 1;
  const std::size_t start = is_first ? 10 : 12;
  if (bytes.size() < start) vtk::refuse(where, "ends within its header");
  const std::size_t length = is_first ? vtk::load<std::uint16_t>(&bytes[8], std::endian::little)
                                      : vtk::load<std::uint32_t>(&bytes[8], std::endian::little);
  if (length > bytes.size() - start) vtk::refuse(where, "ends within its header");
  const std::string_view header = bytes.substr(start, length);
  std::string_view descr = value_of(header, "descr", where), shape = value_of(header, "shape", where);
  if (descr.size() > 2 && descr.starts_with('\'')) descr = descr.substr(1, descr.size() - 2);
  NumpyArray array{.of = numpy::element_type(descr, where),
                   .is_fortran = value_of(header, "fortran_order", where) == "True"};
  if (!shape.starts_with('(')) vtk::refuse(where, "a shape without brackets");
  for (shape.remove_prefix(1); shape.find_first_of("0123456789") != shape.npos;) {
    shape.remove_prefix(shape.find_first_of("0123456789"));
    const std::size_t end = std::min(shape.find_first_not_of("0123456789"), shape.size());
    array.shape.push_back(vtk::whole_number(shape.substr(0, end), where));
    shape.remove_prefix(end);
  }
  array.bytes = bytes.substr(start + length);
  return array;
}

bool is_time(std::string_view name) { return name == "t" || name == "time"; }

/// Arrays by their length: those of the length that most have are a dataset.
class Collected {
 public:
  Collected(const std::filesystem::path& file, std::string format, const Limits& limits)
      : file_(file), format_(std::move(format)), budget_(limits) {}

  void add(const NumpyArray& array, const std::string& name) {
    const std::string where = fmt::format("{}: {}", file_.string(), name);
    if (array.shape.empty() || (array.shape.size() == 1 && array.shape[0] == 1 && is_time(name)))
      add_number(numbers_of({array.of, {}, false, array.bytes}, name, budget_, where).values.front(), name);
    else
      by_part_[""].push_back(numbers_of(array, name, budget_, where));
  }
  void add_number(double number, std::string_view name) {
    if (is_time(name)) time_ = number;
  }

  /// Dictionaries of arrays, at any depth: the name of one that holds "arrays", or arrays themselves, is that of a
  /// part.
  void add(const Pickled& one, const std::string& name, int depth = 0) {
    if (depth > 8) vtk::refuse(file_.string(), "dictionaries nine deep, expected at most eight");
    if (one.is(Kind::array) && one.array.of.is_object) {
      for (const Pickled* item : one.items) add(*item, name, depth + 1);
    } else if (one.is(Kind::number)) {
      add_number(one.number, name);
    } else if (one.is(Kind::dictionary)) {
      const Pickled* arrays = one["arrays"];
      const Pickled& of = arrays ? *arrays : one;
      for (std::size_t k = 0; k + 1 < of.items.size(); k += 2) {
        const Pickled &key = *of.items[k], &value = *of.items[k + 1];
        if (!key.is(Kind::text)) continue;
        const std::string word(key.text);
        if (value.is(Kind::array) && !value.array.of.is_object && !value.array.shape.empty())
          by_part_[name].push_back(
              numbers_of(value.array, word, budget_, fmt::format("{}: {}: {}", file_.string(), name, word)));
        else if (!arrays)
          add(value, word, depth + 1);
      }
    }
  }

  std::vector<Dataset> datasets() const {
    std::vector<Dataset> all;
    for (const auto& [part, arrays] : by_part_) {
      std::map<std::size_t, int> lengths;
      for (const Array& array : arrays) ++lengths[array.rows()];
      const auto most = std::ranges::max_element(lengths, {}, [](const auto& one) { return one.second; });
      Dataset data{
          .source = file_.string(), .format = format_, .part = part, .time = time_, .index = vtk::number_of(file_)};
      for (const Array& array : arrays)
        if (array.rows() == most->first) data.arrays.push_back(array);
      all.push_back(std::move(data));
    }
    if (all.empty()) vtk::refuse(file_.string(), "no arrays of numbers, expected at least one");
    return all;
  }

 private:
  const std::filesystem::path& file_;
  std::string format_;
  vtk::Budget budget_;
  std::map<std::string, std::vector<Array>> by_part_{};
  std::optional<double> time_{};
};

}  // namespace

std::vector<Dataset> read_npy(const std::filesystem::path& file, std::string_view bytes, const Limits& limits) {
  const bool is_archive = bytes.starts_with("PK");
  Collected all(file, is_archive ? "NPZ" : "NPY", limits);
  const std::vector<Member> members = is_archive ? members_of(bytes, file.string(), limits)
                                                 : std::vector<Member>{{file.stem().string(), std::string(bytes)}};
  for (const Member& member : members) {
    const std::string where = fmt::format("{}: {}", file.string(), member.name);
    const NumpyArray array = array_in(member.bytes, where);
    if (array.of.is_object)
      all.add(Pickle(array.bytes, where).root(), member.name);
    else
      all.add(array, member.name);
  }
  return all.datasets();
}

}  // namespace touchstone::vnv::doors
