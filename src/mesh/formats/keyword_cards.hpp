#pragma once
// Keywords and fields of LS-DYNA decks, of a file and what it includes.

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "src/mesh/files/text_source.hpp"

namespace percuss {

/// How wide the fields of a keyword are.
enum class CardFormat : std::uint8_t { standard, i10, longer };

class KeywordCards {
 public:
  KeywordCards(const std::string& path, TextNames& names) : names_(names) { open(path); }

  /// Goes to the next keyword; false at the end of all files. What is left of the last one is passed over.
  bool next_keyword();
  /// The next line of data of this keyword; false if it has no more.
  bool next_line();

  const std::string& keyword() const { return keyword_; }  // in capitals, without the star and suffixes of width
  CardFormat format() const { return format_; }
  std::string_view line() const { return line_; }
  TextPlace place() const { return place_; }
  [[noreturn]] void refuse(const std::string& text) const { names_.refuse(place_, text); }

  /// Cuts the line into fields of these widths in the standard format, or at its commas. Fields of the widths 8 become
  /// 10 where ids are wide, those below 20 become 20 in the long format.
  void cut(std::span<const int> widths);
  /// A field after cut(); empty if the line ends before it.
  std::string_view field(std::size_t i) const { return i < fields_.size() ? fields_[i] : std::string_view(); }
  std::size_t field_count() const { return fields_.size(); }
  /// Value of a field; a blank field is 0.
  std::int64_t integer(std::size_t i) const;
  double real(std::size_t i) const;

  /// Reads on in files of these names, in the folder of the first file or below, then behind the lines of this keyword.
  void include(const std::vector<std::string>& names);

 private:
  struct Open {
    TextSource source;
    CardFormat format = CardFormat::standard;
  };

  void open(const std::string& path);
  void include(const std::string& name);
  void set_formats();
  bool read_line(bool may_leave_file);  // skips comments

  TextNames& names_;
  std::vector<Open> files_;  // the last is read
  std::string folder_, keyword_;
  CardFormat format_ = CardFormat::standard;
  std::string_view line_;
  std::vector<std::string_view> fields_;
  TextPlace place_;
  bool is_waiting_ = false;  // whether the line is a keyword that next_keyword() takes
  std::vector<std::string> included_;
};

}  // namespace percuss
