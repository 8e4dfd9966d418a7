#include "vnv/doors/read/pickle.hpp"

#include <fmt/format.h>

#include <map>

namespace touchstone::vnv::doors::numpy {

using Kind = Pickled::Kind;

const Pickled* Pickled::operator[](std::string_view key) const {
  if (kind == Kind::dictionary)
    for (std::size_t k = 0; k + 1 < items.size(); k += 2)
      if (items[k]->is(Kind::text) && items[k]->text == key) return items[k + 1];
  return nullptr;
}

/// The instructions of pickletools (Python 3.11), protocols 0 to 5, but for what NumPy does not write.
class PickleMachine {
 public:
  PickleMachine(Pickle& pickle, std::string_view bytes, const std::string& where)
      : pickle_(pickle), all_bytes_(bytes), left_(bytes), where_(where) {}

  void run() {
    while (true) {
      const char code = take(1).front();
      if (code == '.') break;
      execute(code);
    }
    pickle_.root_ = pop();
  }

 private:
  [[noreturn]] void refuse(const std::string& what) const {
    vtk::refuse(where_, fmt::format("pickle, byte {}: {}", all_bytes_.size() - left_.size(), what));
  }

  std::string_view take(std::size_t count) {
    if (count > left_.size()) refuse("ends too early");
    const std::string_view part = left_.substr(0, count);
    left_.remove_prefix(count);
    return part;
  }
  template <class Number>
  Number whole() {
    return vtk::load<Number>(take(sizeof(Number)).data(), std::endian::little);
  }
  std::string_view line() {
    const std::size_t end = left_.find('\n');
    if (end == left_.npos) refuse("a line without an end");
    const std::string_view text = take(end);
    take(1);
    return text;
  }

  Pickled& make(Kind kind) {
    if (pickle_.all_.size() > 1'000'000) refuse("more than a million parts");
    Pickled& made = pickle_.all_.emplace_back();
    made.kind = kind;
    return made;
  }
  void push(Pickled& made) { stack_.push_back(&made); }
  void push_number(double value) {
    Pickled& made = make(Kind::number);
    made.number = value;
    push(made);
  }
  void push_text(std::string_view text) {
    Pickled& made = make(Kind::text);
    made.text = text;
    push(made);
  }
  Pickled* pop() {
    if (stack_.empty()) refuse("takes what is not there");
    Pickled* top = stack_.back();
    stack_.pop_back();
    return top;
  }
  Pickled& top() {
    if (stack_.empty()) refuse("asks for what is not there");
    return *stack_.back();
  }
  /// All above the last mark.
  std::vector<const Pickled*> above_mark() {
    if (marks_.empty() || marks_.back() > stack_.size()) refuse("no mark");
    const auto first = stack_.begin() + static_cast<std::ptrdiff_t>(marks_.back());
    std::vector<const Pickled*> items(first, stack_.end());
    stack_.erase(first, stack_.end());
    marks_.pop_back();
    return items;
  }
  void push_list(std::vector<const Pickled*> items) {
    Pickled& made = make(Kind::list);
    made.items = std::move(items);
    push(made);
  }
  void push_last(std::size_t count) {
    std::vector<const Pickled*> items(count);
    for (std::size_t k = count; k > 0; --k) items[k - 1] = pop();
    push_list(std::move(items));
  }
  void add(const std::vector<const Pickled*>& items, Kind kind) {
    Pickled& to = top();
    if (!to.is(kind) || (kind == Kind::dictionary && items.size() % 2 != 0))
      refuse("adds to what is no container of it");
    to.items.insert(to.items.end(), items.begin(), items.end());
  }

  void execute(char code) {
    switch (code) {
      case '\x80':
        if (const int protocol = whole<std::uint8_t>(); protocol > 5)
          refuse(fmt::format("protocol {}, expected 0 to 5", protocol));
        break;
      case '\x95':  // FRAME
        take(8);
        break;
      case '(':
        marks_.push_back(stack_.size());
        break;
      case '0':
        pop();
        break;
      case 'N':
        push(make(Kind::none));
        break;
      case '\x88':
      case '\x89':
        push_number(code == '\x88');
        break;
      case 'K':
        push_number(whole<std::uint8_t>());
        break;
      case 'M':
        push_number(whole<std::uint16_t>());
        break;
      case 'J':
        push_number(whole<std::int32_t>());
        break;
      case '\x8a':
        push_long(take(whole<std::uint8_t>()));
        break;
      case 'G':
        push_number(vtk::load<double>(take(8).data(), std::endian::big));
        break;
      case 'X':
      case 'B':
        push_text(take(whole<std::uint32_t>()));
        break;
      case '\x8c':
      case 'C':
      case 'U':
        push_text(take(whole<std::uint8_t>()));
        break;
      case '\x8d':
      case '\x8e':
      case '\x96':
        push_text(take(whole<std::uint64_t>()));
        break;
      case ')':
      case ']':
        push_list({});
        break;
      case '}':
        push(make(Kind::dictionary));
        break;
      case 't':
      case 'l':
        push_list(above_mark());
        break;
      case '\x85':
      case '\x86':
      case '\x87':
        push_last(static_cast<std::size_t>(code - '\x84'));
        break;
      case 'a': {
        const Pickled* item = pop();
        add({item}, Kind::list);
        break;
      }
      case 'e':
        add(above_mark(), Kind::list);
        break;
      case 's': {
        const Pickled *value = pop(), *key = pop();
        add({key, value}, Kind::dictionary);
        break;
      }
      case 'u':
        add(above_mark(), Kind::dictionary);
        break;
      case 'q':
        memo_[whole<std::uint8_t>()] = &top();
        break;
      case 'r':
        memo_[whole<std::uint32_t>()] = &top();
        break;
      case '\x94':
        memo_[memo_.size()] = &top();
        break;
      case 'h':
        push(remembered(whole<std::uint8_t>()));
        break;
      case 'j':
        push(remembered(whole<std::uint32_t>()));
        break;
      case 'c': {
        const std::string_view module = line();
        push_constructor(module, line());
        break;
      }
      case '\x93': {
        const Pickled *name = pop(), *module = pop();
        push_constructor(module->text, name->text);
        break;
      }
      case 'R':
        call();
        break;
      case 'b':
        build();
        break;
      default:
        refuse(fmt::format("instruction {:#04x}, which NumPy does not write", static_cast<unsigned char>(code)));
    }
  }

  Pickled& remembered(std::size_t number) {
    const auto found = memo_.find(number);
    if (found == memo_.end()) refuse("recalls what was not kept");
    return *found->second;
  }

  void push_long(std::string_view bytes) {  // two's complement, least byte first
    if (bytes.size() > 9) refuse("a whole number of more than 8 bytes");
    double value = 0, place = 1;
    for (const char byte : bytes) {
      value += place * static_cast<unsigned char>(byte);
      place *= 256;
    }
    push_number(!bytes.empty() && (bytes.back() & 0x80) ? value - place : value);
  }

  void push_constructor(std::string_view module, std::string_view name) {
    constexpr std::array<std::pair<std::string_view, std::string_view>, 9> allowed{
        {{"numpy", "ndarray"},
         {"numpy", "dtype"},
         {"numpy.core.multiarray", "_reconstruct"},
         {"numpy.core.multiarray", "scalar"},
         {"numpy._core.multiarray", "_reconstruct"},
         {"numpy._core.multiarray", "scalar"},
         {"numpy.core.numeric", "_frombuffer"},
         {"numpy._core.numeric", "_frombuffer"},
         {"_codecs", "encode"}}};
    if (std::ranges::find(allowed, std::pair(module, name)) == allowed.end())
      refuse(fmt::format("asks for '{}.{}', expected only what makes arrays of NumPy", module.substr(0, 40),
                         name.substr(0, 40)));
    Pickled& made = make(Kind::constructor);
    made.text = name;
    push(made);
  }

  const Pickled& argument(const std::vector<const Pickled*>& of, std::size_t k, Kind kind) const {
    if (k >= of.size() || !of[k]->is(kind))
      refuse(fmt::format("argument {} of a constructor is not what it should be", k + 1));
    return *of[k];
  }

  void call() {
    const Pickled *arguments = pop(), *constructor = pop();
    if (!constructor->is(Kind::constructor) || !arguments->is(Kind::list)) refuse("calls what is no constructor");
    const auto& of = arguments->items;
    if (constructor->text == "_reconstruct") {
      push(make(Kind::array));
    } else if (constructor->text == "dtype") {
      Pickled& made = make(Kind::type);
      made.text = argument(of, 0, Kind::text).text;
      made.array.of = element_type(made.text, where_);
      push(made);
    } else if (constructor->text == "encode") {
      push_text(pickle_.decoded_.emplace_back(bytes_of_latin1(argument(of, 0, Kind::text).text)));
    } else if (constructor->text == "scalar") {
      push_scalar(argument(of, 0, Kind::type).array.of, argument(of, 1, Kind::text).text);
    } else if (constructor->text == "_frombuffer") {
      Pickled& made = make(Kind::array);
      made.array.of = argument(of, 1, Kind::type).array.of;
      made.array.shape = shape(argument(of, 2, Kind::list));
      made.array.is_fortran = argument(of, 3, Kind::text).text == "F";
      made.array.bytes = argument(of, 0, Kind::text).text;
      push(made);
    } else {
      refuse(fmt::format("calls '{}', expected what makes arrays", constructor->text));
    }
  }

  /// Up to protocol 2 a byte is the character of its number, in UTF-8.
  std::string bytes_of_latin1(std::string_view text) const {
    std::string bytes;
    for (std::size_t k = 0; k < text.size(); ++k) {
      const auto byte = static_cast<unsigned char>(text[k]);
      if (byte < 0x80) {
        bytes += text[k];
        continue;
      }
      if ((byte != 0xc2 && byte != 0xc3) || k + 1 == text.size()) refuse("characters that are no bytes");
      bytes += static_cast<char>((byte & 3) << 6 | (text[++k] & 0x3f));
    }
    return bytes;
  }

  void push_scalar(const ElementType& of, std::string_view bytes) {
    if (of.is_object || bytes.size() != vtk::bytes_of(of.type)) refuse("a scalar of another size than its type");
    std::vector<double> one;
    vtk::append_bytes(bytes, of.type, of.order, one);
    push_number(one.front());
  }

  std::vector<std::size_t> shape(const Pickled& list) const {
    std::vector<std::size_t> lengths;
    for (const Pickled* length : list.items) {
      if (!length->is(Kind::number) || !(length->number >= 0 && length->number < 1e15)) refuse("a shape that is none");
      lengths.push_back(static_cast<std::size_t>(length->number));
    }
    return lengths;
  }

  /// What is called back to give a type its order of bytes, and an array its shape, type and contents.
  void build() {
    const Pickled* state = pop();
    Pickled& made = top();
    if (made.is(Kind::type)) {
      if (state->items.size() > 1 && state->items[1]->text == ">") made.array.of.order = std::endian::big;
      return;
    }
    if (!made.is(Kind::array) || !state->is(Kind::list)) refuse("gives a state to what has none");
    const auto& of = state->items;
    made.array.shape = shape(argument(of, 1, Kind::list));
    made.array.of = argument(of, 2, Kind::type).array.of;
    made.array.is_fortran = argument(of, 3, Kind::number).number != 0;
    if (made.array.of.is_object)
      made.items = argument(of, 4, Kind::list).items;
    else
      made.array.bytes = argument(of, 4, Kind::text).text;
  }

  Pickle& pickle_;
  std::string_view all_bytes_, left_;
  const std::string& where_;
  std::vector<Pickled*> stack_{};
  std::vector<std::size_t> marks_{};
  std::map<std::size_t, Pickled*> memo_{};
};

Pickle::Pickle(std::string_view bytes, const std::string& where) { PickleMachine(*this, bytes, where).run(); }

}  // namespace touchstone::vnv::doors::numpy
