#pragma once
/// Pickles of Python, as far as NumPy writes them into its files: numbers, texts, lists, dictionaries and arrays. A
/// pickle is a program that may call anything; here it may name five constructors of NumPy and nothing else.

#include "vnv/doors/read/numpy_array.hpp"

#include <deque>

namespace touchstone::vnv::doors::numpy {

struct Pickled {
  enum class Kind { none, number, text, list, dictionary, array, type, constructor };
  Kind kind = Kind::none;
  double number = 0;
  std::string_view text{};              // also of bytes and of the name of a constructor
  std::vector<const Pickled*> items{};  // of a dictionary: keys and values in turn
  NumpyArray array{};                   // of objects: those are `items`

  bool is(Kind other) const { return kind == other; }
  /// The value of a key, or null.
  const Pickled* operator[](std::string_view key) const;
};

/// A pickle that was read; its bytes have to live as long.
class Pickle {
 public:
  /// Throws Unreadable: an instruction or a name that is not allowed, an end too early, more than a million parts.
  Pickle(std::string_view bytes, const std::string& where);

  const Pickled& root() const { return *root_; }

 private:
  friend class PickleMachine;
  std::deque<Pickled> all_{};
  std::deque<std::string> decoded_{};  // bytes that older protocols write as text
  const Pickled* root_ = nullptr;
};

}  // namespace touchstone::vnv::doors::numpy
