#include "src/mesh/formats/vtu/legacy_data.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <optional>

#include "src/mesh/files/text_numbers.hpp"

namespace percuss {
namespace {

constexpr std::string_view blanks = " \t\r\n";

/// Calls `use` with a value of the type of this name; false: there is none.
template <class Use>
bool with_legacy_type(std::string_view name, const Use& use) {
  const auto try_types = [&](auto value, std::initializer_list<std::string_view> called) {
    if (std::find(called.begin(), called.end(), name) == called.end()) return false;
    use(value);
    return true;
  };
  return try_types(double{}, {"double"}) || try_types(float{}, {"float"}) ||
         try_types(std::int32_t{}, {"int", "vtkidtype"}) || try_types(std::int64_t{}, {"long", "vtktypeint64"}) ||
         try_types(std::int16_t{}, {"short"}) || try_types(std::int8_t{}, {"char", "signed_char"}) ||
         try_types(std::uint8_t{}, {"unsigned_char"}) || try_types(std::uint16_t{}, {"unsigned_short"}) ||
         try_types(std::uint32_t{}, {"unsigned_int"}) || try_types(std::uint64_t{}, {"unsigned_long", "vtktypeuint64"});
}

/// A value of big-endian bytes.
template <class T>
T read_value(const char* bytes) {
  char turned[sizeof(T)];
  std::reverse_copy(bytes, bytes + sizeof(T), turned);
  T value;
  std::memcpy(&value, turned, sizeof(T));
  return value;
}

template <class T, class Parse>
std::vector<T> read_numbers(const LegacyData& data, std::size_t expected, const TextNames& names, const Parse& parse) {
  if (data.count != expected)
    names.refuse(data.place, fmt::format("these data have {} numbers ({} are expected)", data.count, expected));
  std::vector<T> numbers;
  numbers.reserve(data.count);
  if (data.is_binary && data.type == "bit") {
    for (std::size_t i = 0; i < data.count; ++i)
      numbers.push_back(static_cast<T>(static_cast<unsigned char>(data.bytes[i / 8]) >> (7 - i % 8) & 1));
    return numbers;
  }
  if (data.is_binary) {
    with_legacy_type(data.type, [&](auto value) {
      for (std::size_t i = 0; i < data.count; ++i)
        numbers.push_back(static_cast<T>(read_value<decltype(value)>(data.bytes.data() + i * sizeof(value))));
    });
    return numbers;
  }
  int line = data.place.line;
  for (std::size_t at = 0; at < data.bytes.size();) {
    const std::size_t first = std::min(data.bytes.find_first_not_of(blanks, at), data.bytes.size());
    line += static_cast<int>(std::count(data.bytes.begin() + static_cast<std::ptrdiff_t>(at),
                                        data.bytes.begin() + static_cast<std::ptrdiff_t>(first), '\n'));
    if (first == data.bytes.size()) break;
    at = std::min(data.bytes.find_first_of(blanks, first), data.bytes.size());
    const std::string_view word = data.bytes.substr(first, at - first);
    const auto number = parse(word);
    if (!number)
      names.refuse({data.place.file, line}, fmt::format("{} stands where a {} is expected", quote_field(word),
                                                        data.has_integers() ? "whole number" : "number"));
    numbers.push_back(*number);
  }
  return numbers;
}

}  // namespace

std::vector<std::int64_t> LegacyData::read_integers(std::size_t expected, const TextNames& names) const {
  if (!has_integers())
    names.refuse(place, fmt::format("these data are of type {} (whole numbers are expected)", quote_field(type)));
  return read_numbers<std::int64_t>(*this, expected, names, parse_integer);
}

std::vector<double> LegacyData::read_reals(std::size_t expected, const TextNames& names) const {
  return read_numbers<double>(*this, expected, names, parse_real);
}

bool LegacyScanner::next_line(std::string_view& line) {
  last_ = at_;
  last_line_ = line_;
  if (at_ >= text_.size()) return false;
  const std::size_t end = std::min(text_.find('\n', at_), text_.size());
  line = strip_blanks(text_.substr(at_, end - at_));
  at_ = std::min(end + 1, text_.size());
  ++line_;
  return true;
}

std::vector<std::string_view> LegacyScanner::next_words() {
  std::vector<std::string_view> words;
  const std::size_t first = at_;
  const int first_line = line_;
  for (std::string_view line; words.empty() && next_line(line);) {
    for (std::size_t at = line.find_first_not_of(blanks); at != std::string_view::npos;) {
      const std::size_t end = std::min(line.find_first_of(blanks, at), line.size());
      words.push_back(line.substr(at, end - at));
      at = line.find_first_not_of(blanks, end);
    }
  }
  last_ = first;
  last_line_ = first_line;
  return words;
}

std::string_view LegacyScanner::take_words(std::size_t count, const std::string& what) {
  const std::size_t first = at_;
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t word = text_.find_first_not_of(blanks, at_);
    if (word == std::string_view::npos) refuse(fmt::format("the file ends within {}", what));
    at_ = std::min(text_.find_first_of(blanks, word), text_.size());
  }
  const std::string_view words = text_.substr(first, at_ - first);
  line_ += static_cast<int>(std::count(words.begin(), words.end(), '\n'));
  return words;
}

LegacyData LegacyScanner::take_data(std::string_view type, std::size_t count, const std::string& what) {
  LegacyData data{std::string(type), is_binary, count, {}, {0, line_ + 1}};
  for (char& c : data.type) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  std::size_t size = 0;
  const bool is_known = with_legacy_type(data.type, [&](auto value) { size = sizeof(value); });
  if (!is_known && data.type != "bit")
    refuse(fmt::format("{} are of type {}, which is not read", what, quote_field(type)));
  const std::size_t left = text_.size() - at_;
  if (count > (is_binary ? left * 8 : left / 2 + 1))
    refuse(fmt::format("{} are {} numbers, which the rest of the file cannot hold", what, count));
  if (!is_binary) {
    data.bytes = take_words(count, what);
    return data;
  }
  const std::size_t bytes = is_known ? count * size : (count + 7) / 8;
  if (bytes > left) refuse(fmt::format("the file ends within {}", what));
  data.bytes = text_.substr(at_, bytes);
  at_ += bytes;
  return data;
}

}  // namespace percuss
