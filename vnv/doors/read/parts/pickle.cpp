#include "vnv/doors/read/parts/pickle.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace touchstone::vnv::doors {
namespace {

using Object = Pickle::Object;
using Is = Object::Is;

constexpr std::size_t most_objects = 100'000, most_dimensions = 32;  // the last of numpy

/// numpy 2 calls numpy.core numpy._core.
constexpr std::array<std::string_view, 10> names_that_are_known = {"numpy.core.multiarray._reconstruct",
                                                                   "numpy._core.multiarray._reconstruct",
                                                                   "numpy.core.multiarray.scalar",
                                                                   "numpy._core.multiarray.scalar",
                                                                   "numpy.core.numeric._frombuffer",
                                                                   "numpy._core.numeric._frombuffer",
                                                                   "numpy.ndarray",
                                                                   "numpy.dtype",
                                                                   "_codecs.encode",
                                                                   "collections.OrderedDict"};

/// Latin-1 of what UTF-8 holds, as Python 2 and 3 pass bytes to each other; nothing where it is beyond.
std::optional<std::string> latin1_of(std::string_view text) {
  std::string bytes;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto c = static_cast<unsigned char>(text[i]);
    if (c < 0x80) {
      bytes += text[i];
    } else if ((c == 0xc2 || c == 0xc3) && i + 1 < text.size()) {
      bytes += static_cast<char>((c & 3) << 6 | (static_cast<unsigned char>(text[++i]) & 0x3f));
    } else {
      return {};
    }
  }
  return bytes;
}

}  // namespace

Pickle::Pickle(std::string_view bytes, std::string where)
    : rest_(bytes), where_(std::move(where)), size_(bytes.size()) {
  const std::string_view head = take(2);
  if (head[0] != '\x80' || head[1] < 2 || head[1] > 5)
    refuse_here(fmt::format("protocol '{}', expected a pickle of protocol 2 to 5", static_cast<int>(head[1])));
  while (!root_) run(static_cast<unsigned char>(take(1)[0]));
}

const Object* Pickle::value(const Object* object, std::string_view key) {
  if (!object || object->is != Is::dictionary) return nullptr;
  for (std::size_t i = 0; i + 1 < object->items.size(); i += 2)
    if (object->items[i]->is == Is::text && object->items[i]->text == key) return object->items[i + 1];
  return nullptr;
}

void Pickle::refuse_here(const std::string& what) const {
  refuse(fmt::format("{}: byte {} of its pickle", where_, size_ - rest_.size()), what);
}

Object* Pickle::make(Object object) {
  if (objects_.size() == most_objects) refuse_here(fmt::format("expected no more than {} objects", most_objects));
  return &objects_.emplace_back(std::move(object));
}

Object* Pickle::pop() {
  if (stack_.empty() || (!marks_.empty() && marks_.back() == stack_.size()))
    refuse_here("takes from an empty stack, expected an object on it");
  Object* top = stack_.back();
  stack_.pop_back();
  return top;
}

std::vector<Object*> Pickle::pop_to_mark() {
  if (marks_.empty()) refuse_here("no mark, expected one");
  std::vector<Object*> items(stack_.begin() + static_cast<std::ptrdiff_t>(marks_.back()), stack_.end());
  stack_.resize(marks_.back());
  marks_.pop_back();
  return items;
}

std::string_view Pickle::take(std::size_t size) {
  if (size > rest_.size()) refuse_here(fmt::format("'{}' bytes, expected no more than {}", size, rest_.size()));
  const std::string_view taken = rest_.substr(0, size);
  rest_.remove_prefix(size);
  return taken;
}

std::string_view Pickle::take_line() {
  const std::size_t end = rest_.find('\n');
  if (end == rest_.npos) refuse_here("ends within a name, expected more of it");
  const std::string_view line = take(end);
  take(1);
  return line;
}

std::size_t Pickle::take_whole(std::size_t bytes) {
  std::size_t value = 0;
  const std::string_view taken = take(bytes);
  for (std::size_t i = bytes; i-- > 0;) value = value << 8 | static_cast<unsigned char>(taken[i]);
  return value;
}

void Pickle::push_long(std::string_view bytes) {
  if (bytes.size() > 8) refuse_here(fmt::format("a number of '{}' bytes, expected no more than 8", bytes.size()));
  std::uint64_t value = 0;
  for (std::size_t i = bytes.size(); i-- > 0;) value = value << 8 | static_cast<unsigned char>(bytes[i]);
  const std::size_t unused = 64 - 8 * bytes.size();
  push({.is = Is::number,
        .number = bytes.empty() ? 0. : static_cast<double>(static_cast<std::int64_t>(value << unused) >> unused)});
}

void Pickle::push_name(std::string_view module, std::string_view name) {
  const std::string& whole = decoded_.emplace_back(fmt::format("{}.{}", module, name));
  if (std::ranges::find(names_that_are_known, whole) == names_that_are_known.end())
    refuse_here(
        fmt::format("the name '{:.80}', expected plain numbers, texts, lists, dictionaries and numpy's arrays", whole));
  push({.is = Is::name, .text = whole});
}

void Pickle::append(Object& to, std::vector<Object*> items, Is is) {
  if (to.is != is || (is == Is::dictionary && items.size() % 2 != 0))
    refuse_here("adds to what it cannot, expected a list or a dictionary");
  to.items.insert(to.items.end(), items.begin(), items.end());
}

void Pickle::recall(std::size_t slot) {
  const auto known = memo_.find(slot);
  if (known == memo_.end()) refuse_here(fmt::format("recalls '{}', expected what it memorised", slot));
  stack_.push_back(known->second);
}

void Pickle::run(unsigned char opcode) {
  const auto top = [&]() -> Object& { return *stack_.emplace_back(pop()); };
  const auto list_of = [&](std::size_t count) {
    Object list{.is = Is::list, .items = std::vector<const Object*>(count)};
    while (count-- > 0) list.items[count] = pop();
    push(std::move(list));
  };
  switch (opcode) {
    case '.':  // STOP
      root_ = pop();
      return;
    case 0x95:  // FRAME
      take(8);
      return;
    case '(':  // MARK
      marks_.push_back(stack_.size());
      return;
    case '0':  // POP
      pop();
      return;
    case 'N':
      return push({});
    case 0x88:  // NEWTRUE
    case 0x89:  // NEWFALSE
      return push({.is = Is::number, .number = opcode == 0x88 ? 1. : 0.});
    case 'J':  // BININT
      return push_long(take(4));
    case 'K':  // BININT1
      return push({.is = Is::number, .number = static_cast<double>(take_whole(1))});
    case 'M':  // BININT2
      return push({.is = Is::number, .number = static_cast<double>(take_whole(2))});
    case 0x8a:  // LONG1
      return push_long(take(take_whole(1)));
    case 0x8b:  // LONG4
      return push_long(take(take_whole(4)));
    case 'G':  // BINFLOAT
      return push({.is = Is::number, .number = load<double>(take(8).data(), std::endian::big)});
    case 0x8c:  // SHORT_BINUNICODE
    case 'C':   // SHORT_BINBYTES
    case 'U':   // SHORT_BINSTRING
      return push({.is = Is::text, .text = take(take_whole(1))});
    case 'X':  // BINUNICODE
    case 'B':  // BINBYTES
    case 'T':  // BINSTRING
      return push({.is = Is::text, .text = take(take_whole(4))});
    case 0x8d:  // BINUNICODE8
    case 0x8e:  // BINBYTES8
    case 0x96:  // BYTEARRAY8
      return push({.is = Is::text, .text = take(take_whole(8))});
    case ']':  // EMPTY_LIST
    case ')':  // EMPTY_TUPLE
      return push({.is = Is::list});
    case '}':  // EMPTY_DICT
      return push({.is = Is::dictionary});
    case 0x85:  // TUPLE1
    case 0x86:  // TUPLE2
    case 0x87:  // TUPLE3
      return list_of(opcode - 0x84);
    case 't': {  // TUPLE
      const std::vector<Object*> items = pop_to_mark();
      return push({.is = Is::list, .items = {items.begin(), items.end()}});
    }
    case 'a': {  // APPEND
      Object* item = pop();
      return append(top(), {item}, Is::list);
    }
    case 'e': {  // APPENDS
      const std::vector<Object*> items = pop_to_mark();
      return append(top(), items, Is::list);
    }
    case 's': {  // SETITEM
      Object *item = pop(), *key = pop();
      return append(top(), {key, item}, Is::dictionary);
    }
    case 'u': {  // SETITEMS
      const std::vector<Object*> items = pop_to_mark();
      return append(top(), items, Is::dictionary);
    }
    case 'q':  // BINPUT
    case 'r':  // LONG_BINPUT
      memo_[take_whole(opcode == 'q' ? 1 : 4)] = &top();
      return;
    case 0x94:  // MEMOIZE
      memo_[memo_.size()] = &top();
      return;
    case 'h':  // BINGET
    case 'j':  // LONG_BINGET
      return recall(take_whole(opcode == 'h' ? 1 : 4));
    case 'c': {  // GLOBAL
      const std::string_view module = take_line();
      return push_name(module, take_line());
    }
    case 0x93: {  // STACK_GLOBAL
      const Object *name = pop(), *module = pop();
      return push_name(module->text, name->text);
    }
    case 'R': {  // REDUCE
      const Object *arguments = pop(), *function = pop();
      return push(reduced(*function, *arguments));
    }
    case 'b': {  // BUILD
      const Object* state = pop();
      return build(top(), *state);
    }
    default:
      refuse_here(fmt::format("opcode '{}', expected those of plain numbers, texts, lists and dictionaries", opcode));
  }
}

std::vector<std::size_t> Pickle::shape_of(const Object& lengths) const {
  std::vector<std::size_t> shape;
  if (lengths.items.size() > most_dimensions)
    refuse_here(fmt::format("'{}' dimensions, expected no more than {}", lengths.items.size(), most_dimensions));
  for (const Object* length : lengths.items) {
    if (length->is != Is::number || !(length->number >= 0 && length->number < 1e15))
      refuse_here(fmt::format("a length of '{}', expected a whole number from 0", length->number));
    shape.push_back(static_cast<std::size_t>(length->number));
  }
  return shape;
}

/// What numpy's functions would give.
Object Pickle::reduced(const Object& function, const Object& arguments) {
  const auto& given = arguments.items;
  const auto is = [&](std::size_t i, Is kind) { return i < given.size() && given[i]->is == kind; };
  if (function.is != Is::name || arguments.is != Is::list)
    refuse_here("calls what is no function of numpy, expected one");
  const std::string_view name = function.text.substr(function.text.rfind('.') + 1);
  if (name == "OrderedDict" && given.empty()) return {.is = Is::dictionary};
  if (name == "_reconstruct") return {.is = Is::array};
  if (name == "dtype" && is(0, Is::text))
    return {.is = Is::type, .array = {.kind = numpy::kind_named(given[0]->text, where_)}};
  if (name == "encode" && is(0, Is::text)) {
    decoded_bytes_ += given[0]->text.size();
    if (decoded_bytes_ > size_) refuse_here("decodes the same text again, expected each once");
    if (const std::optional<std::string> bytes = latin1_of(given[0]->text))
      return {.is = Is::text, .text = decoded_.emplace_back(*bytes)};
  }
  if (name == "scalar" && is(0, Is::type) && is(1, Is::text)) {
    const numpy::NumpyArray one{.kind = given[0]->array.kind, .bytes = given[1]->text};
    if (!one.kind.is_number()) return {.is = Is::text, .text = one.bytes};
    Budget budget(Limits{});
    return {.is = Is::number, .number = numpy::numbers_of(one, budget, where_).at(0)};
  }
  if (name == "_frombuffer" && is(0, Is::text) && is(1, Is::type) && is(2, Is::list) && is(3, Is::text)) {
    return {.is = Is::array,
            .array = {.kind = given[1]->array.kind,
                      .shape = shape_of(*given[2]),
                      .is_fortran = given[3]->text == "F",
                      .bytes = given[0]->text}};
  }
  refuse_here(fmt::format("{} of other arguments than numpy gives it, expected those", function.text));
}

/// The state of a type, (version, byte order, ...), or of an array, (version, shape, type, Fortran's order, bytes).
void Pickle::build(Object& object, const Object& state) {
  const auto& given = state.items;
  const auto is = [&](std::size_t i, Is kind) { return i < given.size() && given[i]->is == kind; };
  if (object.is == Is::type && is(1, Is::text) && is(2, Is::none) && is(3, Is::none)) {
    object.array.kind.order = given[1]->text == ">" ? std::endian::big : std::endian::little;
  } else if (object.is == Is::array && is(1, Is::list) && is(2, Is::type) && is(3, Is::number) &&
             (is(4, Is::text) || is(4, Is::list))) {
    object.array = {.kind = given[2]->array.kind,
                    .shape = shape_of(*given[1]),
                    .is_fortran = given[3]->number != 0,
                    .bytes = given[4]->text};
    object.items = {given[4]};
  } else {
    refuse_here("a state of other parts than numpy gives it, expected those");
  }
}

}  // namespace touchstone::vnv::doors
