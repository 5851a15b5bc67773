#include "src/mesh/formats/nastran/nastran_names.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

#include "src/mesh/files/text_numbers.hpp"

namespace percuss {
namespace {

/// As a name of a block or a set.
std::string make_name(std::string_view text) {
  std::string name;
  for (const char c : strip_blanks(text)) name += c == '/' ? '_' : c >= 0 && c < ' ' ? ' ' : c;
  return name;
}

/// Takes a whole number off the beginning.
std::optional<std::int64_t> take_number(std::string_view& text) {
  text = strip_blanks(text);
  const std::size_t end = std::min(text.find_first_not_of("0123456789"), text.size());
  const auto number = parse_integer(text.substr(0, end));
  text.remove_prefix(end);
  return number;
}

/// Takes a text in quotes off the beginning; empty: there is none.
std::string take_quoted(std::string_view& text) {
  text = strip_blanks(text);
  const std::size_t end = text.starts_with('"') ? text.find('"', 1) : std::string_view::npos;
  if (end == std::string_view::npos) return {};
  const std::string name = make_name(text.substr(1, end - 1));
  text.remove_prefix(end + 1);
  return name;
}

bool take_word(std::string_view& text, std::string_view word) {
  text = strip_blanks(text);
  if (to_upper(text.substr(0, word.size())) != word) return false;
  text.remove_prefix(word.size());
  return true;
}

std::vector<std::string_view> cut_at(std::string_view text, char mark) {
  std::vector<std::string_view> fields;
  for (std::size_t first = 0; first <= text.size();) {
    const std::size_t end = std::min(text.find(mark, first), text.size());
    fields.push_back(strip_blanks(text.substr(first, end - first)));
    first = end + 1;
  }
  return fields;
}

}  // namespace

/// HMNAME PROP 7"door", HMNAME COMP 3"door" (which has the id of its property where it names none), HMSET 4 1 "tip"
/// with 1 for nodes and 2 for elements.
void NastranNames::take_hypermesh(std::string_view text) {
  const bool is_set = take_word(text, "HMSET ");
  if (!is_set && !take_word(text, "HMNAME ")) return;
  const bool is_component = !is_set && take_word(text, "COMP ");
  if (!is_set && !is_component && !take_word(text, "PROP ")) return;
  const auto id = take_number(text);
  const std::int64_t kind = is_set ? take_number(text).value_or(0) : 0;
  const std::string name = take_quoted(text);
  if (!id || name.empty()) return;
  if (is_set) {
    sets_[*id] = name;
    if (kind == 1) kinds_[*id] = NastranSetKind::nodes;
    if (kind == 2) kinds_[*id] = NastranSetKind::elements;
  } else if (!is_component) {
    properties_[*id] = name;
  } else if (!take_number(text)) {
    components_[*id] = name;
  }
}

/// ANSA_NAME_COMMENT;7;PSHELL;door; or, in two comments, ANSA_NAME;7;PSHELL;~ and door.
void NastranNames::take_ansa(std::string_view text) {
  const std::vector<std::string_view> fields = cut_at(text, ';');
  if (fields.size() < 4) return;
  const auto id = parse_integer(fields[1]);
  if (!id) return;
  if (fields[0] == "ANSA_NAME" && fields[2].starts_with('P')) ansa_property_ = *id;
  if (fields[0] != "ANSA_NAME_COMMENT" || fields[3].empty()) return;
  if (fields[2].starts_with('P')) properties_[*id] = make_name(fields[3]);
  if (fields[2].starts_with("SET")) sets_[*id] = make_name(fields[3]);
}

/// Femap Property 7 : door
void NastranNames::take_femap(std::string_view text) {
  constexpr std::string_view word = " PROPERTY ";
  const std::size_t at = to_upper(text).find(word);
  if (at == std::string::npos) return;
  text.remove_prefix(at + word.size());
  const auto id = take_number(text);
  if (id && take_word(text, ":") && !make_name(text).empty()) properties_[*id] = make_name(text);
}

void NastranNames::take_comment(std::string_view comment) {
  std::string_view text = strip_blanks(comment.substr(std::min<std::size_t>(comment.size(), 1)));
  if (ansa_property_ != 0) {
    if (!make_name(text).empty()) properties_[ansa_property_] = make_name(text);
    ansa_property_ = 0;
    return;
  }
  if (text.starts_with("HM")) take_hypermesh(text);
  if (text.starts_with("ANSA_NAME")) take_ansa(text);
  if (to_upper(text.substr(0, 5)) == "FEMAP") take_femap(text);
  for (const std::string_view before : {"ELEMENTS AND ELEMENT PROPERTIES FOR REGION :", "*  PROPERTY:", "* PROPERTY:"})
    if (take_word(text, before)) next_ = make_name(text);
}

void NastranNames::take_entry(std::int64_t property) {
  if (property != 0 && !next_.empty()) properties_[property] = next_;
  next_.clear();
}

std::map<std::int64_t, std::string> NastranNames::list_properties() const {
  std::map<std::int64_t, std::string> names = properties_;
  names.insert(components_.begin(), components_.end());
  return names;
}

std::string NastranNames::find_set(std::int64_t id) const {
  const auto found = sets_.find(id);
  return found == sets_.end() ? std::string() : found->second;
}

NastranSetKind NastranNames::find_kind(std::int64_t set) const {
  const auto found = kinds_.find(set);
  return found == kinds_.end() ? NastranSetKind::unknown : found->second;
}

}  // namespace percuss
