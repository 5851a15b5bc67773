#include "src/mesh/formats/keyword_cards.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "src/mesh/files/included_file.hpp"
#include "src/mesh/files/text_numbers.hpp"

namespace percuss {
namespace {

bool holds_word(const std::string& text, std::string_view word) { return text.find(word) != std::string::npos; }

}  // namespace

void KeywordCards::open(const std::string& path) {
  if (files_.empty()) folder_ = find_folder(path);
  files_.push_back({TextSource(path, names_), CardFormat::standard});
}

void KeywordCards::include(const std::vector<std::string>& names) {
  if (is_waiting_) files_.back().source.step_back();
  is_waiting_ = false;
  const TextPlace place = place_;
  for (auto name = names.rbegin(); name != names.rend(); ++name) {
    place_ = place;
    include(*name);
  }
  keyword_.clear();
}

void KeywordCards::include(const std::string& name) {
  const std::string path = find_included_file(folder_, name, names_, place_);
  if (files_.size() >= most_open_files || included_.size() >= most_included_files)
    refuse("files include each other too deeply, or without end");
  included_.push_back(path);
  open(path);
}

bool KeywordCards::read_line(bool may_leave_file) {
  while (!files_.empty()) {
    if (!files_.back().source.next_line(line_)) {
      if (!may_leave_file) return false;
      files_.pop_back();
      keyword_.clear();
      continue;
    }
    place_ = files_.back().source.place();
    if (!line_.starts_with('$')) return true;
  }
  return false;
}

bool KeywordCards::next_line() {
  if (is_waiting_ || files_.empty() || !read_line(false)) return false;
  is_waiting_ = line_.starts_with('*');
  return !is_waiting_;
}

/// Text behind the keyword is a remark, but on *KEYWORD.
void KeywordCards::set_formats() {
  std::string all = to_upper(line_);
  keyword_ = all.substr(1, all.find_first_of(" \t,") - 1);
  format_ = files_.empty() ? CardFormat::standard : files_.back().format;
  if (keyword_ == "KEYWORD" && !files_.empty()) {
    if (holds_word(all, "I10=Y")) files_.back().format = CardFormat::i10;
    if (holds_word(all, "LONG=Y")) files_.back().format = CardFormat::longer;
  }
  if (keyword_.empty()) return;
  const char last = keyword_.back();
  if (last == '%') format_ = CardFormat::i10;
  if (last == '+') format_ = CardFormat::longer;
  if (last == '-') format_ = CardFormat::standard;
  if (last == '%' || last == '+' || last == '-') keyword_.pop_back();
}

bool KeywordCards::next_keyword() {
  while (!is_waiting_) {
    if (!read_line(true)) return false;
    is_waiting_ = line_.starts_with('*');
    if (!is_waiting_ && keyword_.empty() && !strip_blanks(line_).empty())
      refuse(fmt::format("{} stands before any keyword", quote_field(line_)));
  }
  is_waiting_ = false;
  set_formats();
  if (keyword_ != "END") return true;
  files_.pop_back();  // what follows is no part of the file
  keyword_.clear();
  return next_keyword();
}

void KeywordCards::cut(std::span<const int> widths) {
  fields_.clear();
  if (line_.find(',') != std::string_view::npos) {
    for (std::size_t first = 0; first <= line_.size();) {
      const std::size_t end = std::min(line_.find(',', first), line_.size());
      fields_.push_back(strip_blanks(line_.substr(first, end - first)));
      first = end + 1;
    }
    return;
  }
  std::size_t first = 0;
  for (int width : widths) {
    if (format_ == CardFormat::i10) width = std::max(width, 10);
    if (format_ == CardFormat::longer) width = std::max(width, 20);
    if (first >= line_.size()) break;
    fields_.push_back(strip_blanks(line_.substr(first, static_cast<std::size_t>(width))));
    first += static_cast<std::size_t>(width);
  }
}

std::int64_t KeywordCards::integer(std::size_t i) const {
  const std::string_view text = field(i);
  if (text.empty()) return 0;
  const auto value = parse_integer(text);
  if (!value)
    refuse(fmt::format("field {} of *{} is {} (a whole number is expected{})", i + 1, keyword_, quote_field(text),
                       text.find('&') == std::string_view::npos ? "" : "; parameters are not read"));
  return *value;
}

double KeywordCards::real(std::size_t i) const {
  const std::string_view text = field(i);
  if (text.empty()) return 0;
  const auto value = parse_real(text);
  if (!value)
    refuse(fmt::format("field {} of *{} is {} (a number is expected{})", i + 1, keyword_, quote_field(text),
                       text.find('&') == std::string_view::npos ? "" : "; parameters are not read"));
  return *value;
}

}  // namespace percuss
