#pragma once
// Words, numbers and bytes of a file of Gmsh.

#include <fmt/format.h>

#include <bit>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <type_traits>

#include "src/mesh/files/text_numbers.hpp"
#include "src/mesh/files/text_source.hpp"

namespace percuss {

/// Reads one after the other. Throws InputError with the line, which of binary content is that before it.
class GmshScanner {
 public:
  GmshScanner(std::string_view text, const TextNames& names) : text_(text), names_(names) {}

  bool is_binary = false;

  TextPlace place() const { return {0, line_}; }
  std::size_t bytes_left() const { return text_.size() - at_; }
  [[noreturn]] void refuse(const std::string& what) const { refuse_at(place(), what); }
  [[noreturn]] void refuse_at(const TextPlace& place, const std::string& what) const { names_.refuse(place, what); }

  /// The rest of the line.
  std::string_view next_line() {
    const std::size_t end = std::min(text_.find('\n', at_), text_.size());
    const std::string_view line = text_.substr(at_, end - at_);
    at_ = std::min(end + 1, text_.size());
    ++line_;
    return strip_blanks(line);
  }

  /// The next word, in whatever line; empty at the end.
  std::string_view next_word() {
    while (at_ < text_.size() && is_space(text_[at_])) line_ += text_[at_++] == '\n' ? 1 : 0;
    const std::size_t first = at_;
    while (at_ < text_.size() && !is_space(text_[at_])) ++at_;
    return text_.substr(first, at_ - first);
  }

  /// A whole number: a word, or bytes of type T in a binary file.
  template <class T>
  std::int64_t next_integer(const char* what) {
    if (is_binary) return static_cast<std::int64_t>(next_bytes<T>(what));
    const std::string_view word = next_word();
    const auto value = parse_integer(word);
    if (!value) refuse(fmt::format("{} is {} (a whole number is expected)", what, quote_field(word)));
    return *value;
  }

  double next_real(const char* what) {
    if (is_binary) return next_bytes<double>(what);
    const std::string_view word = next_word();
    const auto value = parse_real(word);
    if (!value) refuse(fmt::format("{} is {} (a number is expected)", what, quote_field(word)));
    return *value;
  }

  /// How many follow, each of which takes at least so many bytes.
  template <class T>
  std::int64_t next_count(const char* what, std::size_t bytes_each) {
    const std::int64_t count = next_integer<T>(what);
    if (count < 0 || static_cast<std::uint64_t>(count) > bytes_left() / bytes_each + 1)
      refuse(fmt::format("{} is {}, which the rest of the file cannot hold", what, count));
    return count;
  }

 private:
  static bool is_space(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; }

  template <class T>
  T next_bytes(const char* what) {
    if (bytes_left() < sizeof(T)) refuse(fmt::format("the file ends within {}", what));
    T value;
    std::memcpy(&value, text_.data() + at_, sizeof(T));
    at_ += sizeof(T);
    return value;
  }

  std::string_view text_;
  const TextNames& names_;
  std::size_t at_ = 0;
  int line_ = 1;
};

}  // namespace percuss
