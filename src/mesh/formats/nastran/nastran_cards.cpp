#include "src/mesh/formats/nastran/nastran_cards.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "src/mesh/files/included_file.hpp"
#include "src/mesh/files/text_numbers.hpp"

namespace percuss {
namespace {

constexpr std::size_t name_width = 8, fields_of_line = 8, line_width = 80;

/// The first word in capitals, up to a blank, a comma or a quote.
std::string find_first_word(std::string_view line) {
  constexpr std::size_t longest = 8;
  const std::string_view text = strip_blanks(line);
  return to_upper(text.substr(0, std::min(text.find_first_of(" \t,*'\""), longest + 1)));
}

bool continues(std::string_view mark) { return mark.empty() || mark.front() == '+' || mark.front() == '*'; }

/// The mark without the sign that all marks begin with.
std::string_view strip_sign(std::string_view mark) {
  while (mark.starts_with('+') || mark.starts_with('*')) mark.remove_prefix(1);
  return strip_blanks(mark);
}

/// Whether the mark of a continuation, without its sign, is that at the end of the line before, of which the first
/// character does not count.
bool fits(std::string_view mark, std::string_view expected) {
  return mark.empty() || strip_sign(expected).empty() || mark == strip_sign(expected) || mark == expected.substr(1);
}

std::string expand_tabs(std::string_view line) {
  std::string text;
  for (const char c : line) {
    if (c != '\t')
      text += c;
    else
      text.resize(text.size() + name_width - text.size() % name_width, ' ');
  }
  return text;
}

}  // namespace

NastranCards::NastranCards(const std::string& path, TextNames& names) : names_(names), folder_(find_folder(path)) {
  open(path);
  skip_control();
}

void NastranCards::open(const std::string& path) { files_.emplace_back(path, names_); }

/// A file without BEGIN BULK is bulk data from its first line on.
void NastranCards::skip_control() {
  TextSource source = files_.back();
  std::string_view line;
  while (source.next_line(line)) {
    if (find_first_word(line) == "BEGIN") {
      files_.back() = source;
      files_.back().step_back();
      return;
    }
    control_.emplace_back(line, source.place());
  }
  control_.clear();
}

/// The next line that is neither empty nor a comment.
bool NastranCards::read_line(bool may_leave_file) {
  while (!files_.empty()) {
    if (!files_.back().next_line(line_)) {
      if (!may_leave_file) return false;
      closed_.push_back(files_.back());
      files_.pop_back();
      continue;
    }
    const std::string_view text = strip_blanks(line_);
    if (text.starts_with('$')) next_comments_.emplace_back(text);
    if (text.empty() || text.starts_with('$')) continue;
    place_ = files_.back().place();
    return true;
  }
  return false;
}

void NastranCards::cut_at_commas() {
  for (std::size_t first = 0; first <= line_.size();) {
    const std::size_t end = std::min(line_.find(',', first), line_.size());
    of_line_.push_back(strip_blanks(line_.substr(first, end - first)));
    first = end + 1;
  }
  mark_ = of_line_.front();
  of_line_.erase(of_line_.begin());
  is_large_ = mark_.find('*') != std::string_view::npos;
  const std::size_t most = is_large_ ? fields_of_line / 2 : fields_of_line;
  while (of_line_.size() > most + 1 && of_line_.back().empty()) of_line_.pop_back();
  if (of_line_.size() > most + 1) {
    note_fault(fmt::format("the line has {} fields (at most {} with commas, then the mark of a continuation)",
                           of_line_.size() + 1, most + 1));
    of_line_.resize(most + 1);
  }
  if (of_line_.size() > most) {
    end_mark_ = of_line_.back();
    of_line_.pop_back();
  }
}

void NastranCards::cut_at_columns() {
  line_ = line_.substr(0, line_width);
  mark_ = strip_blanks(line_.substr(0, name_width));
  is_large_ = mark_.find('*') != std::string_view::npos;
  const std::size_t width = is_large_ ? 2 * name_width : name_width, end = line_width - name_width;
  for (std::size_t first = name_width; first < std::min(line_.size(), end); first += width)
    of_line_.push_back(strip_blanks(line_.substr(first, std::min(width, end - first))));
  if (line_.size() > end) end_mark_ = strip_blanks(line_.substr(end));
}

void NastranCards::cut() {
  of_line_.clear();
  end_mark_ = {};
  line_ = line_.substr(0, line_.find('$'));
  const bool has_commas = line_.find(',') != std::string_view::npos;
  if (!has_commas && line_.find('\t') != std::string_view::npos) line_ = expanded_.emplace_back(expand_tabs(line_));
  has_commas ? cut_at_commas() : cut_at_columns();
}

/// Takes the fields of the line that is cut, behind those of the lines before it: eight or, of long ones, four.
void NastranCards::add_line() {
  if (!is_large_ && fields_.size() % fields_of_line != 0)
    note_fault("a line of short fields follows half a line of long ones");
  fields_.insert(fields_.end(), of_line_.begin(), of_line_.end());
  fields_.resize((fields_.size() + fields_of_line / 2 - 1) / (fields_of_line / 2) * (fields_of_line / 2));
  if (!is_large_) fields_.resize((fields_.size() + fields_of_line - 1) / fields_of_line * fields_of_line);
  places_.resize(fields_.size(), place_);
}

void NastranCards::read_continuations() {
  while (read_line(false)) {
    const char first = line_.front();
    const bool may_continue = first == '+' || first == '*' || first == ',' || first == ' ' || first == '\t';
    const std::string_view expected = end_mark_;
    if (may_continue) cut();
    if (!may_continue || !continues(mark_)) {
      files_.back().step_back();
      return;
    }
    const std::string_view mark = strip_sign(mark_);
    if (!fits(mark, expected))
      note_fault(fmt::format("the continuation {} stands where {} is expected (they are read in the order of the file)",
                             quote_field(mark), quote_field(strip_sign(expected))));
    add_line();
  }
}

/// INCLUDE 'name', in quotes also over further lines, or a name without blanks; what follows is a note.
void NastranCards::read_include() {
  const TextPlace place = place_;
  std::string name(strip_blanks(strip_blanks(line_).substr(std::string_view("INCLUDE").size())));
  if (!name.empty() && (name.front() == '\'' || name.front() == '"')) {
    while (name.find(name.front(), 1) == std::string::npos) {
      if (!files_.back().next_line(line_)) names_.refuse(place, "the name of the included file has no end");
      name += strip_blanks(line_);
    }
    name = name.substr(1, name.find(name.front(), 1) - 1);
  } else {
    name = name.substr(0, name.find_first_of(" \t$"));
  }
  const std::string path = find_included_file(folder_, name, names_, place);
  if (files_.size() >= most_open_files || ++included_ > most_included_files)
    names_.refuse(place, "files include each other too deeply, or without end");
  open(path);
}

bool NastranCards::next() {
  name_.clear();
  fields_.clear();
  places_.clear();
  expanded_.clear();
  fault_.clear();
  while (read_line(true)) {
    const std::string word = find_first_word(line_);
    if (word == "ENDDATA") {
      closed_.insert(closed_.end(), files_.begin(), files_.end());
      files_.clear();
    }
    if (word == "INCLUDE") read_include();
    if (word == "BEGIN") begin_bulk();
    if (word == "ENDDATA" || word == "INCLUDE" || word == "BEGIN") continue;
    comments_ = std::exchange(next_comments_, {});
    cut();
    if (continues(mark_)) refuse_line("the line continues no entry");
    if (mark_.front() == '=') refuse_line("fields that repeat those of the line before (=) are not read");
    name_ = to_upper(strip_blanks(mark_.substr(0, mark_.find('*'))));
    add_line();
    read_continuations();
    return true;
  }
  comments_ = std::exchange(next_comments_, {});
  return false;
}

void NastranCards::begin_bulk() {
  const std::string text = to_upper(strip_blanks(line_.substr(0, line_.find('$'))));
  const std::string_view rest = strip_blanks(std::string_view(text).substr(std::string_view("BEGIN").size()));
  if (has_begun_) refuse_line("BEGIN BULK comes again (superelements are not read)");
  if (!rest.empty() && rest != "BULK")
    refuse_line(fmt::format("BEGIN {} is not read (BEGIN BULK alone is)", quote_field(rest)));
  has_begun_ = true;
}

std::string NastranCards::describe_field(std::size_t i) const {
  const std::size_t number = i / fields_of_line * (fields_of_line + 2) + i % fields_of_line + 2;
  return fmt::format("field {} of {} is {}", number, name_, quote_field(field(i)));
}

std::int64_t NastranCards::integer(std::size_t i) const {
  if (is_blank(i)) return 0;
  const auto value = parse_integer(field(i));
  if (!value) names_.refuse(place_of(i), describe_field(i) + " (a whole number is expected)");
  return *value;
}

double NastranCards::real(std::size_t i) const {
  if (is_blank(i)) return 0;
  const auto value = parse_real(field(i));
  if (!value) names_.refuse(place_of(i), describe_field(i) + " (a number is expected)");
  return *value;
}

}  // namespace percuss
