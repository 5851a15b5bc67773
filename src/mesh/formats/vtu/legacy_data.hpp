#pragma once
// Numbers of a legacy VTK file, as words or as big-endian bytes.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "src/mesh/files/text_source.hpp"

namespace percuss {

/// So many numbers where they stand in the file.
struct LegacyData {
  std::string type;  // "int", "double", ...
  bool is_binary = false;
  std::size_t count = 0;
  std::string_view bytes;
  TextPlace place;

  bool has_integers() const { return type != "float" && type != "double"; }

  /// The numbers. Throw InputError if they are others, or `expected` are requested.
  std::vector<std::int64_t> read_integers(std::size_t expected, const TextNames& names) const;
  std::vector<double> read_reals(std::size_t expected, const TextNames& names) const;
};

/// Lines and data of a legacy VTK file, one after the other.
class LegacyScanner {
 public:
  LegacyScanner(std::string_view text, const TextNames& names) : text_(text), names_(names) {}

  bool is_binary = false;

  TextPlace place() const { return {0, line_}; }
  [[noreturn]] void refuse(const std::string& what) const { names_.refuse(place(), what); }

  /// The next line, without blanks at its ends; false at the end of the file.
  bool next_line(std::string_view& line);
  /// The words of the next line that has any; empty at the end of the file.
  std::vector<std::string_view> next_words();
  /// Goes back, so that the last words are read again.
  void step_back() {
    at_ = last_;
    line_ = last_line_;
  }

  /// The numbers that stand here. what: of which, for messages.
  LegacyData take_data(std::string_view type, std::size_t count, const std::string& what);

 private:
  std::string_view take_words(std::size_t count, const std::string& what);

  std::string_view text_;
  const TextNames& names_;
  std::size_t at_ = 0, last_ = 0;
  int line_ = 0, last_line_ = 0;
};

}  // namespace percuss
