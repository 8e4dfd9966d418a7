#pragma once
/// Arrays as numpy keeps them: a type, a shape and bytes.

#include <string>
#include <string_view>
#include <vector>

#include "vnv/doors/read/parts/numbers.hpp"

namespace touchstone::vnv::doors::numpy {

/// What numpy calls a dtype: '<f8' is a number of the kind 'f', of 8 bytes, the lowest first.
struct NumberType {
  char letter = 'f';  // b f i u as numpy names them; O, S and U are no numbers
  std::size_t bytes = 8;
  std::endian order = std::endian::little;

  bool is_number() const { return letter == 'b' || letter == 'f' || letter == 'i' || letter == 'u'; }
};

/// Throws Unreadable for what is none of f2 f4 f8 i1 to i8 u1 to u8 b1 O S U.
NumberType kind_named(std::string_view name, const std::string& where);

struct NumpyArray {
  NumberType kind{};
  std::vector<std::size_t> shape{};  // of none: one number
  bool is_fortran = false;           // the first index runs fastest
  std::string_view bytes{};
};

inline constexpr std::string_view npy_begins = "\x93NUMPY";

/// An array as a .npy holds it; `bytes` of its numbers are all that follow its header. Throws Unreadable.
NumpyArray npy_array(std::string_view bytes, const std::string& where);

/// How many numbers; throws Unreadable unless the bytes are just those.
std::size_t size_of(const NumpyArray& array, const std::string& where);

/// All numbers, the last index fastest. Throws Unreadable where they are none, or of more than two dimensions.
std::vector<double> numbers_of(const NumpyArray& array, Budget& budget, const std::string& where);

}  // namespace touchstone::vnv::doors::numpy
