#pragma once
// Keywords, parameters and data lines of an Abaqus input file.

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "src/mesh/files/text_source.hpp"

namespace percuss {

class AbaqusLines {
 public:
  AbaqusLines(const std::string& path, TextNames& names) : names_(names), source_(path, names) {}

  /// Goes to the next keyword; false at the end of the file.
  bool next_keyword();
  /// The next line of data of this keyword; false if it has no more.
  bool next_data();

  const std::string& keyword() const { return keyword_; }  // in capitals, with one blank between words: "END PART"
  /// Value of a parameter; empty if it is not given or has none.
  std::string parameter(const std::string& name) const;
  bool has_parameter(const std::string& name) const { return parameters_.contains(name); }

  std::string_view field(std::size_t i) const { return i < fields_.size() ? fields_[i] : std::string_view(); }
  std::size_t field_count() const { return fields_.size(); }  // without an empty one behind the last comma
  bool ends_with_comma() const { return ends_with_comma_; }
  std::int64_t integer(std::size_t i) const;
  double real(std::size_t i) const;  // of an empty field 0
  TextPlace place() const { return place_; }
  [[noreturn]] void refuse(const std::string& text) const { names_.refuse(place_, text); }

 private:
  bool read_line(std::string_view& line);  // skips comments and blank lines
  void read_keyword(std::string_view line);

  TextNames& names_;
  TextSource source_;
  std::string keyword_;
  std::map<std::string, std::string> parameters_;
  std::vector<std::string_view> fields_;
  bool ends_with_comma_ = false;
  TextPlace place_;
};

}  // namespace percuss
