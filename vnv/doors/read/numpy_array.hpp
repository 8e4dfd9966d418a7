#pragma once
/// Arrays as NumPy keeps them: a type, a shape and bytes, whether in a file of their own or in a pickle.

#include "vnv/doors/read/vtk_numbers.hpp"

namespace touchstone::vnv::doors::numpy {

/// Of the elements: "<f8" is double precision with the least byte first, "|O" any object of Python.
struct ElementType {
  bool is_object = false;
  vtk::Type type = vtk::Type::float64;
  std::endian order = std::endian::little;
};
/// Throws Unreadable for what is no number of 1 to 8 bytes, such as complex numbers and records.
ElementType element_type(std::string_view descr, const std::string& where);

struct NumpyArray {
  ElementType of{};
  std::vector<std::size_t> shape{};
  bool is_fortran = false;  // the first index runs fastest
  std::string_view bytes{};

  std::size_t rows() const { return shape.empty() ? 1 : shape.front(); }
};

/// Its numbers, a row for each first index, in the order of C. Throws Unreadable where the bytes are too few or the
/// limits too narrow.
Array numbers_of(const NumpyArray& array, const std::string& name, vtk::Budget& budget, const std::string& where);

}  // namespace touchstone::vnv::doors::numpy
