#include "vnv/doors/read/parts/numpy_array.hpp"

#include <fmt/format.h>

#include <Eigen/Core>

namespace touchstone::vnv::doors::numpy {
namespace {

/// Of the dictionary that describes an array, as Python writes it: what stands behind a key.
std::string_view behind(std::string_view header, const std::string& key, const std::string& where) {
  const std::size_t at = header.find("'" + key + "':");
  if (at == header.npos) refuse(where, fmt::format("no '{}' in its header, expected one", key));
  const std::string_view rest = header.substr(at + key.size() + 3);
  return rest.substr(std::min(rest.find_first_not_of(' '), rest.size()));
}

}  // namespace

NumberType kind_named(std::string_view name, const std::string& where) {
  NumberType kind;
  std::string_view rest = name;
  if (rest.starts_with('>')) kind.order = std::endian::big;
  if (!rest.empty() && std::string_view("<>|=").find(rest[0]) != rest.npos) rest.remove_prefix(1);
  kind.letter = rest.empty() ? '?' : rest[0];
  kind.bytes = 0;
  const std::string_view digits = rest.substr(std::min<std::size_t>(rest.size(), 1));
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), kind.bytes);
  const bool has_size = error == std::errc{} && end == digits.data() + digits.size();
  if (digits.empty() && kind.letter == 'O') kind.bytes = 8;
  const bool is_power = kind.bytes == 2 || kind.bytes == 4 || kind.bytes == 8;
  const std::string_view no_numbers = "OSU";
  const bool is_known = (kind.letter == 'b' && kind.bytes == 1) || (kind.letter == 'f' && is_power) ||
                        ((kind.letter == 'i' || kind.letter == 'u') && (is_power || kind.bytes == 1)) ||
                        no_numbers.find(kind.letter) != no_numbers.npos;
  if (!is_known || (!digits.empty() && !has_size))
    refuse(where, fmt::format("type '{:.40}', expected f2, f4, f8, i1 to i8, u1 to u8 or b1", name));
  return kind;
}

NumpyArray npy_array(std::string_view bytes, const std::string& where) {
  constexpr std::size_t longest_header = 1 << 16, version_at = npy_begins.size(), length_at = version_at + 2;
  const auto at = [&](std::size_t i) { return i < bytes.size() ? static_cast<unsigned char>(bytes[i]) : 0u; };
  if (!bytes.starts_with(npy_begins)) refuse(where, "no array of numpy, expected one");
  const unsigned version = at(version_at);
  if (version < 1 || version > 3) refuse(where, fmt::format("version '{}', expected 1, 2 or 3", version));
  const std::size_t begin = length_at + (version == 1 ? 2 : 4);
  std::size_t length = at(length_at) | at(length_at + 1) << 8;
  if (version > 1) length |= at(length_at + 2) << 16 | static_cast<std::size_t>(at(length_at + 3)) << 24;
  if (length > longest_header || begin + length > bytes.size())
    refuse(where, fmt::format("a header of '{}' bytes, expected no more than {}", length,
                              std::min(longest_header, bytes.size() - std::min(begin, bytes.size()))));
  const std::string_view header = bytes.substr(begin, length), type = behind(header, "descr", where);
  const bool is_plain = type.starts_with('\'');
  NumpyArray array{.kind = numpy::kind_named(is_plain ? type.substr(1, type.find('\'', 1) - 1) : type, where),
                   .is_fortran = behind(header, "fortran_order", where).starts_with("True"),
                   .bytes = bytes.substr(begin + length)};
  std::string_view shape = behind(header, "shape", where);
  if (!shape.starts_with('(') || shape.find(')') == shape.npos) refuse(where, "no tuple as its shape, expected one");
  for (shape = shape.substr(1, shape.find(')') - 1); !shape.empty();) {
    const std::string_view one = shape.substr(0, shape.find(','));
    array.shape.push_back(
        whole_number(one.substr(std::min(one.find_first_not_of(' '), one.size())), where + ": shape"));
    shape.remove_prefix(std::min(one.size() + 1, shape.size()));
  }
  return array;
}

std::size_t size_of(const NumpyArray& array, const std::string& where) {
  std::size_t size = 1;
  for (const std::size_t length : array.shape) {
    if (length != 0 && size > array.bytes.size() / length)
      refuse(where, fmt::format("a shape of more numbers than its {} bytes, expected no more", array.bytes.size()));
    size *= length;
  }
  if (array.kind.bytes != 0 &&
      (array.bytes.size() % array.kind.bytes != 0 || array.bytes.size() / array.kind.bytes != size))
    refuse(where, fmt::format("'{}' bytes, expected {} numbers of {}", array.bytes.size(), size, array.kind.bytes));
  return size;
}

/// Appends numbers of the kind, all that the bytes hold.
static void append(std::string_view bytes, const NumberType& kind, std::vector<double>& to) {
  if (kind.letter == 'f' && kind.bytes == 2) {
    const std::size_t size = bytes.size() / 2;
    reserve_more(to, size);
    for (std::size_t i = 0; i < size; ++i)
      to.push_back(Eigen::half_impl::half_to_float(
          Eigen::half_impl::raw_uint16_to_half(load<std::uint16_t>(bytes.data() + 2 * i, kind.order))));
  } else {
    const auto power = static_cast<std::size_t>(std::countr_zero(kind.bytes));  // of 1, 2, 4 or 8 bytes
    append_bytes(bytes,
                 kind.letter == 'f' ? (kind.bytes == 4 ? Type::float32 : Type::float64)
                                    : static_cast<Type>(2 * power + (kind.letter != 'i')),
                 kind.order, to);
  }
}

std::vector<double> numbers_of(const NumpyArray& array, Budget& budget, const std::string& where) {
  if (!array.kind.is_number()) refuse(where, fmt::format("type '{}', expected numbers", array.kind.letter));
  if (array.shape.size() > 2) refuse(where, fmt::format("'{}' dimensions, expected 1 or 2", array.shape.size()));
  std::vector<double> numbers;
  const std::size_t size = size_of(array, where);
  if (size == 0) return numbers;
  budget.take(size, 1, where);
  if (!array.is_fortran || array.shape.size() < 2) {
    append(array.bytes, array.kind, numbers);
    return numbers;
  }
  constexpr std::size_t at_once = 1 << 14;  // so that no second copy stands beside all
  const std::size_t rows = array.shape[0], columns = array.shape[1];
  std::vector<double> some;
  reserve_more(numbers, size);
  numbers.resize(size);
  for (std::size_t column = 0; column < columns; ++column)
    for (std::size_t first = 0; first < rows; first += at_once) {
      some.clear();
      append(array.bytes.substr((column * rows + first) * array.kind.bytes,
                                std::min(at_once, rows - first) * array.kind.bytes),
             array.kind, some);
      for (std::size_t i = 0; i < some.size(); ++i) numbers[(first + i) * columns + column] = some[i];
    }
  return numbers;
}

}  // namespace touchstone::vnv::doors::numpy
