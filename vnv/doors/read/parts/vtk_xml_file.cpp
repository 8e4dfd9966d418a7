#include "vnv/doors/read/parts/vtk_xml_file.hpp"

#include <fmt/format.h>
#include <lz4.h>
#include <zlib.h>

#include <limits>
#include <utility>

namespace touchstone::vnv::doors::vtk {
namespace {

/// Of XML: one without attributes takes 64 bytes of memory, and as many for the text in it.
std::size_t most_elements(std::size_t bytes) { return 10000 + bytes / 16; }

std::string_view attribute_of(std::string_view tag, std::string_view name) {
  const std::size_t at = tag.find(name);
  if (at == tag.npos) return {};
  const std::size_t open = tag.find_first_of("\"'", at);
  if (open == tag.npos) return {};
  return tag.substr(open + 1, tag.find(tag[open], open + 1) - open - 1);
}

std::optional<Type> type_named(std::string_view name) {
  constexpr std::array<std::string_view, 10> names = {"Int8",   "UInt8", "Int16",  "UInt16",  "Int32",
                                                      "UInt32", "Int64", "UInt64", "Float32", "Float64"};
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) return {};
  return static_cast<Type>(found - names.begin());
}

constexpr std::array<signed char, 256> digits_of_base64 = [] {
  std::array<signed char, 256> digits{};
  digits.fill(-1);
  constexpr std::string_view alphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  for (std::size_t i = 0; i < alphabet.size(); ++i)
    digits[static_cast<unsigned char>(alphabet[i])] = static_cast<signed char>(i);
  return digits;
}();

}  // namespace

/// Bytes that are taken one after the other, as they are or out of base64, whose parts may each end in padding.
class XmlFile::Bytes {
 public:
  Bytes(std::string_view text, bool is_base64, std::string where, std::size_t& unread)
      : text_(text), is_base64_(is_base64), where_(std::move(where)), unread_(unread) {}

  const std::string& where() const { return where_; }

  /// No fewer than there are.
  std::size_t most() const { return is_base64_ ? decoded_.size() + text_.size() / 4 * 3 : text_.size(); }

  /// Valid until the next call. Throws Unreadable where there are fewer.
  std::string_view take(std::size_t size) {
    if (size > most())
      refuse(where_,
             fmt::format("'{}' bytes that begin here, expected no more than the {} up to its end", size, most()));
    if (size > unread_) refuse(where_, "reads what another array has read, expected each byte in one array");
    unread_ -= size;
    if (is_base64_) return decode(size);
    const std::string_view taken = text_.substr(0, size);
    text_.remove_prefix(size);
    return taken;
  }

 private:
  std::string_view decode(std::size_t size) {
    decoded_.erase(0, taken_);
    decoded_.reserve(size + 3);
    while (decoded_.size() < size) decode_four();
    taken_ = size;
    return std::string_view(decoded_).substr(0, size);
  }

  void decode_four() {
    std::uint32_t bits = 0;
    std::size_t padding = 0;
    if (text_.size() < 4) refuse(where_, "ends within its base64, expected more of it");
    for (const char c : text_.substr(0, 4)) {
      const signed char digit = digits_of_base64[static_cast<unsigned char>(c)];
      if (c == '=' ? padding == 2 : digit < 0 || padding > 0)
        refuse(where_, fmt::format("byte {} of its base64, expected A-Z, a-z, 0-9, + or /, or = at its end",
                                   static_cast<unsigned char>(c)));
      padding += c == '=';
      bits = bits << 6 | static_cast<std::uint32_t>(c == '=' ? 0 : digit);
    }
    text_.remove_prefix(4);
    const std::array<char, 3> bytes = {static_cast<char>(bits >> 16), static_cast<char>(bits >> 8),
                                       static_cast<char>(bits)};
    decoded_.append(bytes.data(), 3 - padding);
  }

  std::string_view text_;
  bool is_base64_;
  std::string where_;
  std::size_t& unread_;
  std::string decoded_{};
  std::size_t taken_ = 0;  // of what is decoded
};

XmlFile::XmlFile(std::string name, std::string_view bytes, const Limits& limits)
    : name_(std::move(name)), size_(bytes.size()), budget_(limits), unread_(bytes.size()) {
  if (bytes.size() > limits.most_bytes)
    refuse(name_, fmt::format("'{}' bytes, expected no more than {}", bytes.size(), limits.most_bytes));
  const std::size_t appended = bytes.find("<AppendedData");
  if (appended == bytes.npos) {
    text_ = bytes;
  } else {  // what follows may be no XML
    const std::size_t end = bytes.find('>', appended);
    if (end == bytes.npos) refuse(name_, "ends within AppendedData, expected '_' and the data");
    const std::string_view encoding = attribute_of(bytes.substr(appended, end - appended), "encoding");
    if (encoding != "raw" && encoding != "base64")
      refuse(name_ + ": AppendedData", fmt::format("encoding '{}', expected raw or base64", encoding.substr(0, 40)));
    const std::size_t begin = bytes.find_first_not_of(" \t\r\n", end + 1);
    if (begin == bytes.npos || bytes[begin] != '_') refuse(name_ + ": AppendedData", "expected '_' before the data");
    appended_is_raw_ = encoding == "raw";
    appended_ = bytes.substr(begin + 1);
    text_ = fmt::format("{}</VTKFile>", bytes.substr(0, appended));
  }
  if (std::cmp_greater(std::count(text_.begin(), text_.end(), '<'), most_elements(bytes.size())))
    refuse(name_, fmt::format("expected XML of no more than {} elements", most_elements(bytes.size())));
  const pugi::xml_parse_result parsed =
      document_.load_buffer_inplace(text_.data(), text_.size(), pugi::parse_default, pugi::encoding_utf8);
  if (!parsed)
    refuse(fmt::format("{}: byte {}", name_, parsed.offset),
           fmt::format("{}, expected XML of VTK", parsed.description()));
  if (std::string_view(root().name()) != "VTKFile")
    refuse(name_, fmt::format("element '{:.40}', expected VTKFile", root().name()));
  const std::string_view header = root().attribute("header_type").as_string("UInt32"),
                         order = root().attribute("byte_order").as_string("LittleEndian"),
                         compressor = root().attribute("compressor").value();
  if (header != "UInt32" && header != "UInt64")
    refuse(name_, fmt::format("header_type '{}', expected UInt32 or UInt64", header.substr(0, 40)));
  if (order != "LittleEndian" && order != "BigEndian")
    refuse(name_, fmt::format("byte_order '{}', expected LittleEndian or BigEndian", order.substr(0, 40)));
  if (!compressor.empty() && compressor != "vtkZLibDataCompressor" && compressor != "vtkLZ4DataCompressor")
    refuse(name_, fmt::format("compressor '{}', expected none, vtkZLibDataCompressor or vtkLZ4DataCompressor",
                              compressor.substr(0, 40)));
  header_ = *type_named(header);
  order_ = order == "BigEndian" ? std::endian::big : std::endian::little;
  compressor_ = compressor.empty()                      ? Compressor::none
                : compressor == "vtkZLibDataCompressor" ? Compressor::zlib
                                                        : Compressor::lz4;
}

std::string XmlFile::encoding(const pugi::xml_node& piece) const {
  const std::string_view format = piece.child("Points").child("DataArray").attribute("format").value();
  const std::string_view appended = format != "appended" ? "" : appended_is_raw_ ? " raw" : " base64";
  const std::string_view compressed = format == "ascii" || compressor_ == Compressor::none ? ""
                                      : compressor_ == Compressor::zlib                    ? ", zlib"
                                                                                           : ", LZ4";
  return fmt::format("{}{}{}", format, appended, compressed);
}

std::optional<double> XmlFile::time() {
  pugi::xml_node best;
  const auto consider = [&](const pugi::xml_node& parent) {
    for (const pugi::xml_node& field : parent.children("FieldData"))
      for (const pugi::xml_node& array : field.children("DataArray")) {
        const auto rank = rank_as_time(array.attribute("Name").value()),
                   known = rank_as_time(best.attribute("Name").value());
        if (rank && (!known || *rank < *known) && array.attribute("NumberOfTuples").as_ullong(1) == 1) best = array;
      }
  };
  consider(root());
  for (const pugi::xml_node& child : root().children()) {
    consider(child);
    for (const pugi::xml_node& piece : child.children("Piece")) consider(piece);
  }
  if (!best || components(best) != 1) return {};
  std::vector<double> time;
  append(best, 1, time);
  return time_of(time[0], *type_named(best.attribute("type").value()), where(best));
}

std::size_t XmlFile::count(const pugi::xml_node& element, const char* attribute, bool may_lack) const {
  const pugi::xml_attribute found = element.attribute(attribute);
  if (!found && may_lack) return 0;
  return whole_number(found.value(), fmt::format("{}: {}: {}", name_, element.name(), attribute));
}

std::size_t XmlFile::components(const pugi::xml_node& array) const {
  return array.attribute("NumberOfComponents") ? count(array, "NumberOfComponents") : 1;
}

std::string XmlFile::where(const pugi::xml_node& array) const {
  return fmt::format("{}: {} '{:.80}'", name_, array.parent().name(), array.attribute("Name").value());
}

template <class To>
void XmlFile::append(const pugi::xml_node& array, std::size_t rows, std::vector<To>& to) {
  const std::string place = where(array);
  const std::string_view type_name = array.attribute("type").value(), format = array.attribute("format").value();
  const std::optional<Type> type = type_named(type_name);
  if (!type)
    refuse(place, fmt::format("type '{}', expected Int8 to UInt64, Float32 or Float64", type_name.substr(0, 40)));
  if (std::is_integral_v<To> && !is_whole(*type))
    refuse(place, fmt::format("type '{}', expected whole numbers", type_name));
  const std::size_t numbers = budget_.take(rows, components(array), place);
  std::string_view text = array.text().get();
  if (format == "ascii") {
    append_text(text, numbers, *type, place, to);
    if (!next_word(text).empty()) refuse(place, fmt::format("more than its {} numbers, expected no more", numbers));
    return;
  }
  const bool is_appended = format == "appended";
  if (!is_appended && format != "binary")
    refuse(place, fmt::format("format '{}', expected ascii, binary or appended", format.substr(0, 40)));
  if (is_appended) {
    const std::size_t offset = count(array, "offset");
    if (offset > appended_.size())
      refuse(place, fmt::format("offset '{}', expected no more than the {} bytes that are appended", offset,
                                appended_.size()));
    text = appended_.substr(offset);
  } else {
    text.remove_prefix(std::min(text.find_first_not_of(" \t\r\n"), text.size()));
    text = text.substr(0, text.find_last_not_of(" \t\r\n") + 1);
  }
  if (numbers == 0) return;
  Bytes bytes(text, !is_appended || !appended_is_raw_, place, unread_);
  compressor_ == Compressor::none ? append_plain(bytes, numbers, *type, place, to)
                                  : append_compressed(bytes, numbers, *type, place, to);
}

std::size_t XmlFile::next_header(Bytes& bytes) const {
  const std::string_view taken = bytes.take(bytes_of(header_));
  return header_ == Type::uint32 ? load<std::uint32_t>(taken.data(), order_)
                                 : load<std::uint64_t>(taken.data(), order_);
}

template <class To>
void XmlFile::append_plain(Bytes& bytes, std::size_t count, Type type, const std::string& where, std::vector<To>& to) {
  const std::size_t size = next_header(bytes);
  if (size != count * bytes_of(type))
    refuse(where, fmt::format("'{}' bytes, expected {} of {} numbers", size, count * bytes_of(type), count));
  append_bytes(bytes.take(size), type, order_, to);
}

template <class To>
void XmlFile::append_compressed(Bytes& bytes, std::size_t count, Type type, const std::string& where,
                                std::vector<To>& to) {
  const std::size_t blocks = next_header(bytes), each = next_header(bytes), last = next_header(bytes),
                    size = count * bytes_of(type);
  const std::size_t whole = blocks - (last != 0), most_in_file = bytes.most() * most_that_deflate_saves;
  if (blocks == 0 || each == 0 || whole > size / each || whole * each + last != size || last > each)
    refuse(where,
           fmt::format("'{}' blocks of {} bytes, the last of {}, expected {} bytes in all", blocks, each, last, size));
  if (size > most_in_file)
    refuse(where, fmt::format("'{}' bytes once decompressed, expected no more than {} times those of the file", size,
                              most_that_deflate_saves));
  if (blocks > bytes.most() / bytes_of(header_))
    refuse(where, fmt::format("'{}' blocks, expected their sizes", blocks));
  std::vector<std::size_t> sizes(blocks);
  for (std::size_t& compressed : sizes) compressed = next_header(bytes);
  if (to.empty()) to.reserve(count);
  std::string block;  // after what is left of the former one, where blocks end within a number
  for (std::size_t i = 0; i < blocks; ++i) {
    const std::size_t left = block.size(), expected = i + 1 == blocks && last ? last : each;
    const std::string_view compressed = bytes.take(sizes[i]);
    block.resize(left + expected);
    char* out = block.data() + left;
    uLongf decompressed = expected;
    constexpr std::size_t most_of_lz4 = std::numeric_limits<int>::max();
    const bool is_whole =
        compressor_ == Compressor::zlib
            ? uncompress(reinterpret_cast<Bytef*>(out), &decompressed,
                         reinterpret_cast<const Bytef*>(compressed.data()), compressed.size()) == Z_OK &&
                  decompressed == expected
            : compressed.size() <= most_of_lz4 && expected <= most_of_lz4 &&
                  std::cmp_equal(LZ4_decompress_safe(compressed.data(), out, static_cast<int>(compressed.size()),
                                                     static_cast<int>(expected)),
                                 expected);
    if (!is_whole)
      refuse(where, fmt::format("block {} of {}, expected {} bytes compressed by {}", i + 1, blocks, expected,
                                compressor_ == Compressor::zlib ? "zlib" : "LZ4"));
    const std::size_t numbers = block.size() / bytes_of(type) * bytes_of(type);
    append_bytes(std::string_view(block).substr(0, numbers), type, order_, to);
    block.erase(0, numbers);
  }
}

template void XmlFile::append(const pugi::xml_node&, std::size_t, std::vector<double>&);
template void XmlFile::append(const pugi::xml_node&, std::size_t, std::vector<std::int64_t>&);
template void XmlFile::append(const pugi::xml_node&, std::size_t, std::vector<std::uint8_t>&);

}  // namespace touchstone::vnv::doors::vtk
