#pragma once
// Entries of Nastran bulk data, of a file and what it includes: fields of 8 columns, of 16 (name with a star) or
// between commas, with continuation lines, comments behind `$`, and the lines before BEGIN BULK.

#include <cstdint>
#include <list>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "src/mesh/files/text_source.hpp"

namespace percuss {

class NastranCards {
 public:
  NastranCards(const std::string& path, TextNames& names);

  /// Lines of the executive and case control, in the order of the file; comments too.
  const std::vector<std::pair<std::string_view, TextPlace>>& control() const { return control_; }

  /// Goes to the next entry; false at ENDDATA or at the end of the file.
  bool next();

  const std::string& name() const { return name_; }  // in capitals, without a star
  /// Comments between the entry before and this one.
  const std::vector<std::string>& comments() const { return comments_; }

  // Fields behind the name, from 0, over all lines of the entry.
  std::size_t field_count() const { return fields_.size(); }
  std::string_view field(std::size_t i) const { return i < fields_.size() ? fields_[i] : std::string_view(); }
  bool is_blank(std::size_t i) const { return field(i).empty(); }
  std::int64_t integer(std::size_t i) const;  // of a blank field 0
  double real(std::size_t i) const;           // likewise
  TextPlace place() const { return places_.empty() ? place_ : places_.front(); }
  TextPlace place_of(std::size_t i) const { return i < places_.size() ? places_[i] : place(); }
  [[noreturn]] void refuse(const std::string& text) const { names_.refuse(place(), text); }
  /// Throws InputError if the lines of the entry do not fit together. Those of entries that are passed over need not.
  void check_lines() const {
    if (!fault_.empty()) names_.refuse(fault_place_, fault_);
  }

 private:
  void open(const std::string& path);
  void skip_control();
  bool read_line(bool may_leave_file);
  void cut();
  void cut_at_commas();
  void cut_at_columns();
  void add_line();
  void read_continuations();
  void read_include();
  void begin_bulk();
  [[noreturn]] void refuse_line(const std::string& text) const { names_.refuse(place_, text); }
  void note_fault(const std::string& text) {
    if (fault_.empty()) fault_place_ = place_;
    if (fault_.empty()) fault_ = text;
  }
  std::string describe_field(std::size_t i) const;

  TextNames& names_;
  std::vector<TextSource> files_, closed_;  // the last of files_ is read; texts of the closed ones may still be named
  std::string folder_, name_;
  std::vector<std::pair<std::string_view, TextPlace>> control_;
  std::size_t included_ = 0;
  std::vector<std::string> comments_, next_comments_;

  // The line that is read, cut.
  std::string_view line_;
  TextPlace place_;
  std::list<std::string> expanded_;  // lines with tabs, of this entry
  std::string_view mark_, end_mark_;
  std::vector<std::string_view> of_line_;
  bool is_large_ = false, has_begun_ = false;

  std::vector<std::string_view> fields_;
  std::vector<TextPlace> places_;  // [fields]
  std::string fault_;              // the first of this entry; empty: none
  TextPlace fault_place_;
};

}  // namespace percuss
