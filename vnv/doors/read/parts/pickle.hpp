#pragma once
/// What Python pickled, protocols 2 to 5, as far as it is plain: dictionaries, lists, tuples, text, bytes, numbers and
/// numpy's arrays of them. A pickle is a program; of this one nothing is called, and any other name is refused.

#include <deque>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "vnv/doors/read/parts/numpy_array.hpp"

namespace touchstone::vnv::doors {

class Pickle {
 public:
  /// Objects refer to each other, and may do so in circles; texts and bytes to the pickle or to what was decoded of it.
  struct Object {
    enum class Is { none, number, text, list, dictionary, name, type, array } is = Is::none;
    double number = 0;
    std::string_view text{};             // and bytes, and of a name "numpy.dtype"
    std::vector<const Object*> items{};  // of a list or tuple; of a dictionary keys and values in turn
    numpy::NumpyArray array{};           // of a type only its kind; of an array of objects items[0] is their list
  };

  /// Throws Unreadable: another opcode, protocol or name, more than 100000 objects, an end too early.
  Pickle(std::string_view bytes, std::string where);

  const Object& root() const { return *root_; }

  /// The value of a key, where the object is a dictionary that has it.
  static const Object* value(const Object* object, std::string_view key);

 private:
  Object* make(Object object);
  void push(Object object) { stack_.push_back(make(std::move(object))); }
  Object* pop();
  std::vector<Object*> pop_to_mark();
  std::string_view take(std::size_t size);
  std::string_view take_line();
  std::size_t take_whole(std::size_t bytes);
  void run(unsigned char opcode);
  void push_name(std::string_view module, std::string_view name);
  void push_long(std::string_view bytes);
  void append(Object& to, std::vector<Object*> items, Object::Is is);
  void recall(std::size_t slot);
  std::vector<std::size_t> shape_of(const Object& lengths) const;
  Object reduced(const Object& function, const Object& arguments);
  void build(Object& object, const Object& state);
  [[noreturn]] void refuse_here(const std::string& what) const;

  std::string_view rest_;
  std::string where_;
  std::size_t size_;
  std::deque<Object> objects_{};
  std::deque<std::string> decoded_{};
  std::size_t decoded_bytes_ = 0;
  std::vector<Object*> stack_{};
  std::vector<std::size_t> marks_{};
  std::unordered_map<std::size_t, Object*> memo_{};
  const Object* root_ = nullptr;
};

}  // namespace touchstone::vnv::doors
