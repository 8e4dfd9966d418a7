#pragma once
/// One file of VTK's XML: its elements, and the numbers of its arrays, which stand in them or are appended.

#include <pugixml.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "vnv/doors/read/parts/numbers.hpp"

namespace touchstone::vnv::doors::vtk {

class XmlFile {
 public:
  /// Throws Unreadable.
  XmlFile(std::string name, std::string_view bytes, const Limits& limits);

  const std::string& name() const { return name_; }
  std::size_t size() const { return size_; }
  pugi::xml_node root() const { return document_.document_element(); }
  std::string_view type() const { return root().attribute("type").value(); }

  /// How its arrays are written, as the first of a piece says: "appended raw, zlib".
  std::string encoding(const pugi::xml_node& piece) const;

  /// TimeValue or the like among its arrays of fields.
  std::optional<double> time();

  /// A count that an element must give, or may leave out where it is then 0.
  std::size_t count(const pugi::xml_node& element, const char* attribute, bool may_lack = false) const;

  /// Of an array: numbers a row.
  std::size_t components(const pugi::xml_node& array) const;

  /// Appends `rows` rows of the array. Throws Unreadable where it holds more or fewer.
  template <class To>  // double, std::int64_t or std::uint8_t
  void append(const pugi::xml_node& array, std::size_t rows, std::vector<To>& to);

 private:
  class Bytes;
  template <class To>
  void append_plain(Bytes& bytes, std::size_t count, Type type, const std::string& where, std::vector<To>& to);
  template <class To>
  void append_compressed(Bytes& bytes, std::size_t count, Type type, const std::string& where, std::vector<To>& to);
  std::string where(const pugi::xml_node& array) const;
  std::size_t next_header(Bytes& bytes) const;

  enum class Compressor { none, zlib, lz4 };
  std::string name_;
  std::size_t size_;  // in bytes
  pugi::xml_document document_{};
  std::string text_{};  // which the document refers to
  std::string_view appended_{};
  bool appended_is_raw_ = false;
  Type header_ = Type::uint32;
  std::endian order_ = std::endian::little;
  Compressor compressor_ = Compressor::none;
  Budget budget_;
  std::size_t unread_;  // bytes of the file that no array has read yet
};

}  // namespace touchstone::vnv::doors::vtk
