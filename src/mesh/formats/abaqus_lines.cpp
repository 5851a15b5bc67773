#include "src/mesh/formats/abaqus_lines.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "src/mesh/files/text_numbers.hpp"

namespace percuss {
namespace {

/// Cuts at commas.
std::vector<std::string_view> cut(std::string_view line) {
  std::vector<std::string_view> fields;
  for (std::size_t first = 0; first <= line.size();) {
    const std::size_t end = std::min(line.find(',', first), line.size());
    fields.push_back(strip_blanks(line.substr(first, end - first)));
    first = end + 1;
  }
  return fields;
}

/// The text in capitals, with one blank between words.
std::string join_words(std::string_view text) {
  std::string words;
  for (const char c : to_upper(strip_blanks(text))) {
    const bool is_blank = c == ' ' || c == '\t';
    if (!is_blank)
      words += c;
    else if (!words.ends_with(' '))
      words += ' ';
  }
  return words;
}

}  // namespace

bool AbaqusLines::read_line(std::string_view& line) {
  while (source_.next_line(line)) {
    line = strip_blanks(line);
    if (line.empty() || line.starts_with("**")) continue;
    place_ = source_.place();
    return true;
  }
  return false;
}

void AbaqusLines::read_keyword(std::string_view line) {
  parameters_.clear();
  keyword_.clear();
  while (true) {
    for (const std::string_view field : cut(line)) {
      if (keyword_.empty() && field.starts_with('*')) {
        keyword_ = join_words(field.substr(1));
        continue;
      }
      const std::size_t equals = std::min(field.find('='), field.size());
      const std::string name = join_words(field.substr(0, equals));
      std::string_view value = equals < field.size() ? strip_blanks(field.substr(equals + 1)) : std::string_view();
      if (value.size() >= 2 && value.front() == '"' && value.back() == '"') value = value.substr(1, value.size() - 2);
      if (!name.empty()) parameters_[name] = value;
    }
    const bool continues = line.ends_with(',');
    if (!continues || !read_line(line)) return;
  }
}

bool AbaqusLines::next_keyword() {
  std::string_view line;
  while (read_line(line)) {
    if (!line.starts_with('*')) {
      if (keyword_.empty()) refuse(fmt::format("{} stands before any keyword", quote_field(line)));
      continue;
    }
    read_keyword(line);
    return true;
  }
  return false;
}

bool AbaqusLines::next_data() {
  std::string_view line;
  if (!read_line(line)) return false;
  if (line.starts_with('*')) {
    source_.step_back();
    return false;
  }
  fields_ = cut(line);
  ends_with_comma_ = fields_.back().empty() && fields_.size() > 1;
  while (fields_.size() > 1 && fields_.back().empty()) fields_.pop_back();
  return true;
}

std::string AbaqusLines::parameter(const std::string& name) const {
  const auto found = parameters_.find(name);
  return found == parameters_.end() ? std::string() : found->second;
}

std::int64_t AbaqusLines::integer(std::size_t i) const {
  const auto value = parse_integer(field(i));
  if (!value)
    refuse(fmt::format("item {} of *{} is {} (a whole number is expected)", i + 1, keyword_, quote_field(field(i))));
  return *value;
}

double AbaqusLines::real(std::size_t i) const {
  if (field(i).empty()) return 0;
  const auto value = parse_real(field(i));
  if (!value)
    refuse(fmt::format("item {} of *{} is {} (a number is expected)", i + 1, keyword_, quote_field(field(i))));
  return *value;
}

}  // namespace percuss
