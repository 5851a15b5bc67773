#include "src/mesh/formats/vtu/vtu_arrays.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <optional>
#include <type_traits>

#include "src/mesh/files/text_numbers.hpp"

namespace percuss {
namespace {

/// Calls `use` with a value of the type of this name; false: there is none.
template <class Use>
bool with_vtk_type(const std::string& name, const Use& use) {
  const auto try_type = [&](const char* called, auto value) {
    if (name != called) return false;
    use(value);
    return true;
  };
  return try_type("Float64", double{}) || try_type("Float32", float{}) || try_type("Int64", std::int64_t{}) ||
         try_type("Int32", std::int32_t{}) || try_type("UInt8", std::uint8_t{}) ||
         try_type("UInt64", std::uint64_t{}) || try_type("UInt32", std::uint32_t{}) ||
         try_type("Int8", std::int8_t{}) || try_type("Int16", std::int16_t{}) || try_type("UInt16", std::uint16_t{});
}

std::int64_t parse_number(const XmlTag& tag, const std::string& key, std::int64_t otherwise, const TextNames& names) {
  const std::string text = tag.attribute(key);
  const auto value = text.empty() ? std::optional(otherwise) : parse_integer(text);
  if (!value || *value < 0)
    names.refuse(tag.place, fmt::format("{} is {} (a whole number is expected)", key, quote_field(text)));
  return *value;
}

}  // namespace

void VtuArrays::refuse(const VtuArray& array, const std::string& why) const {
  names_.refuse(array.place, fmt::format("array {} {}", quote_field(array.name), why));
}

void VtuArrays::read_file_tag(const XmlTag& tag) {
  const std::string type = tag.attribute("type"), header = tag.attribute("header_type"),
                    compressor = tag.attribute("compressor"), order = tag.attribute("byte_order");
  if (type != "UnstructuredGrid")
    names_.refuse(tag.place, fmt::format("the file is a {} (UnstructuredGrid is read)", quote_field(type)));
  if (!header.empty() && header != "UInt32" && header != "UInt64")
    names_.refuse(tag.place, fmt::format("header_type is {} (UInt32 and UInt64 are read)", quote_field(header)));
  if (!compressor.empty() && compressor != "vtkZLibDataCompressor")
    names_.refuse(tag.place, fmt::format("compressor is {}: save the file with zlib, or without compression",
                                         quote_field(compressor)));
  storage_.header_bytes = header == "UInt64" ? 8 : 4;
  storage_.is_compressed = !compressor.empty();
  is_big_endian_ = order == "BigEndian";
}

VtuArray VtuArrays::read_array_tag(const XmlTag& tag) const {
  VtuArray array;
  array.name = tag.attribute("Name");
  array.type = tag.attribute("type");
  array.format = tag.attribute("format").empty() ? tag.attribute("Format") : tag.attribute("format");
  if (array.format.empty()) array.format = "ascii";
  array.components = parse_number(tag, "NumberOfComponents", 1, names_);
  array.offset = parse_number(tag, "offset", 0, names_);
  array.text = tag.text;
  array.place = tag.place;
  return array;
}

void VtuArrays::read_appended_tag(const XmlTag& tag) {
  const std::string encoding = tag.attribute("encoding");
  if (encoding != "raw" && encoding != "base64")
    names_.refuse(tag.place, fmt::format("encoding is {} (raw and base64 are read)", quote_field(encoding)));
  const std::size_t begin = tag.text.find_first_not_of(" \t\r\n");
  if (begin == std::string_view::npos || tag.text[begin] != '_')
    names_.refuse(tag.place, "appended data do not begin with an underscore");
  appended_ = tag.text.substr(begin + 1);
  is_appended_base64_ = encoding == "base64";
  has_appended_ = true;
}

std::string VtuArrays::read_bytes(const VtuArray& array, std::size_t bytes) const {
  if (is_big_endian_) refuse(array, "is big-endian (save the file as little-endian, or as ASCII)");
  try {
    if (array.format == "binary") return take_bytes(array.text, true, storage_, bytes);
    if (array.format != "appended")
      refuse(array, fmt::format("has the format {} (ascii, binary and appended are read)", quote_field(array.format)));
    if (!has_appended_) refuse(array, "is appended, but the file has no AppendedData");
    if (static_cast<std::uint64_t>(array.offset) >= appended_.size())
      refuse(array, "begins behind the end of the file");
    return take_bytes(appended_.substr(static_cast<std::size_t>(array.offset)), is_appended_base64_, storage_, bytes);
  } catch (const VtuFault& fault) {
    refuse(array, fault.reason);
  }
}

template <class T, class Parse>
std::vector<T> VtuArrays::read_text(const VtuArray& array, std::size_t count, const Parse& parse) const {
  constexpr std::string_view blanks = " \t\r\n";
  std::vector<T> numbers;
  if (count > array.text.size() / 2 + 1) refuse(array, fmt::format("has fewer than {} numbers", count));
  numbers.reserve(count);
  for (std::size_t at = array.text.find_first_not_of(blanks); at != std::string_view::npos;) {
    const std::size_t end = std::min(array.text.find_first_of(blanks, at), array.text.size());
    const std::string_view word = array.text.substr(at, end - at);
    const auto number = parse(word);
    if (!number) {
      const auto lines = std::count(array.text.begin(), array.text.begin() + static_cast<std::ptrdiff_t>(at), '\n');
      names_.refuse({array.place.file, array.place.line + static_cast<int>(lines)},
                    fmt::format("array {} has {} (a {} is expected)", quote_field(array.name), quote_field(word),
                                std::is_same_v<T, double> ? "number" : "whole number"));
    }
    if (numbers.size() == count) refuse(array, fmt::format("has more than {} numbers", count));
    numbers.push_back(*number);
    at = array.text.find_first_not_of(blanks, end);
  }
  if (numbers.size() != count) refuse(array, fmt::format("has {} numbers ({} are expected)", numbers.size(), count));
  return numbers;
}

template <class T>
std::vector<T> VtuArrays::read(const VtuArray& array, std::size_t count) const {
  constexpr std::size_t most = std::size_t{1} << 40;
  std::vector<T> numbers;
  if (count > most) refuse(array, "has more numbers than the file can hold");
  const bool is_known = with_vtk_type(array.type, [&](auto value) {
    const std::string bytes = read_bytes(array, count * sizeof(value));
    numbers.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
      std::memcpy(&value, bytes.data() + i * sizeof(value), sizeof(value));
      numbers.push_back(static_cast<T>(value));
    }
  });
  if (!is_known) refuse(array, fmt::format("has the type {}, which is unknown", quote_field(array.type)));
  return numbers;
}

std::vector<std::int64_t> VtuArrays::read_integers(const VtuArray& array, std::size_t count) const {
  if (!array.has_integers())
    refuse(array, fmt::format("has the type {} (whole numbers are expected)", quote_field(array.type)));
  if (array.format == "ascii") return read_text<std::int64_t>(array, count, parse_integer);
  return read<std::int64_t>(array, count);
}

std::vector<double> VtuArrays::read_reals(const VtuArray& array, std::size_t count) const {
  if (array.format == "ascii") return read_text<double>(array, count, parse_real);
  return read<double>(array, count);
}

}  // namespace percuss
