#include "vnv/doors/read/numpy_array.hpp"

#include <fmt/format.h>

namespace touchstone::vnv::doors::numpy {

ElementType element_type(std::string_view descr, const std::string& where) {
  using vtk::Type;
  std::string_view text = descr;
  ElementType found;
  if (text.starts_with('>')) found.order = std::endian::big;
  if (text.starts_with('<') || text.starts_with('>') || text.starts_with('|') || text.starts_with('='))
    text.remove_prefix(1);
  constexpr std::array<std::pair<std::string_view, Type>, 11> known{{{"f8", Type::float64},
                                                                     {"f4", Type::float32},
                                                                     {"i8", Type::int64},
                                                                     {"i4", Type::int32},
                                                                     {"i2", Type::int16},
                                                                     {"i1", Type::int8},
                                                                     {"u8", Type::uint64},
                                                                     {"u4", Type::uint32},
                                                                     {"u2", Type::uint16},
                                                                     {"u1", Type::uint8},
                                                                     {"b1", Type::uint8}}};
  found.is_object = text == "O" || text == "O8";
  if (found.is_object) return found;
  const auto at = std::ranges::find(known, text, &std::pair<std::string_view, Type>::first);
  if (at == known.end())
    vtk::refuse(where, fmt::format("elements of type '{}', expected numbers of 1 to 8 bytes", descr.substr(0, 60)));
  found.type = at->second;
  return found;
}

Array numbers_of(const NumpyArray& array, const std::string& name, vtk::Budget& budget, const std::string& where) {
  std::size_t components = 1;
  for (std::size_t k = 1; k < array.shape.size(); ++k) {
    if (array.shape[k] == 0 || array.shape[k] > 1'000'000 || components > 1'000'000)
      vtk::refuse(where,
                  fmt::format("'{}' has {} components in a direction, expected 1 to a million", name, array.shape[k]));
    components *= array.shape[k];
  }
  const std::size_t count = budget.take(array.rows(), components, where), size = vtk::bytes_of(array.of.type);
  if (array.bytes.size() / size < count)
    vtk::refuse(where,
                fmt::format("'{}' has {} bytes, expected {} numbers of {}", name, array.bytes.size(), count, size));
  Array made{name, static_cast<int>(components)};
  vtk::append_bytes(array.bytes.substr(0, count * size), array.of.type, array.of.order, made.values);
  if (!array.is_fortran || array.shape.size() < 2) return made;
  if (array.shape.size() > 2)
    vtk::refuse(where, fmt::format("'{}' has {} dimensions in the order of Fortran, expected at most 2", name,
                                   array.shape.size()));
  const std::vector<double> columns = std::move(made.values);
  made.values.resize(count);
  for (std::size_t row = 0; row < array.rows(); ++row)
    for (std::size_t k = 0; k < components; ++k) made.values[row * components + k] = columns[k * array.rows() + row];
  return made;
}

}  // namespace touchstone::vnv::doors::numpy
