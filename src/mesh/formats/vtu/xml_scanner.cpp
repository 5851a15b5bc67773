#include "src/mesh/formats/vtu/xml_scanner.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "src/mesh/files/text_numbers.hpp"

namespace percuss {
namespace {

constexpr std::size_t most_attributes = 100, deepest_tag = 100;

bool is_name_character(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-' ||
         c == '.' || c == ':';
}

bool is_xml_space(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; }

std::string replace_entities(std::string_view text) {
  constexpr std::array<std::pair<std::string_view, char>, 5> entities{
      {{"&lt;", '<'}, {"&gt;", '>'}, {"&amp;", '&'}, {"&quot;", '"'}, {"&apos;", '\''}}};
  std::string plain;
  while (!text.empty()) {
    const auto entity =
        std::find_if(entities.begin(), entities.end(), [&](const auto& pair) { return text.starts_with(pair.first); });
    plain += entity == entities.end() ? text.front() : entity->second;
    text.remove_prefix(entity == entities.end() ? 1 : entity->first.size());
  }
  return plain;
}

}  // namespace

void XmlScanner::skip_to(std::size_t at) {
  at = std::min(at, text_.size());
  const std::string_view between = text_.substr(at_, at - at_);
  place_.line += static_cast<int>(std::count(between.begin(), between.end(), '\n'));
  at_ = at;
}

/// Goes behind a comment or an instruction that begins here.
bool XmlScanner::skip_remarks() {
  const std::string_view rest = text_.substr(at_);
  const bool is_comment = rest.starts_with("<!--"), is_instruction = rest.starts_with("<?");
  if (rest.starts_with("<!") && !is_comment) refuse(fmt::format("{} is not read", quote_field(rest.substr(0, 12))));
  if (!is_comment && !is_instruction) return false;
  const std::string_view end = is_comment ? "-->" : "?>";
  const std::size_t found = text_.find(end, at_ + 2);
  if (found == std::string_view::npos) refuse("a comment or an instruction has no end");
  skip_to(found + end.size());
  return true;
}

void XmlScanner::skip_blanks() {
  std::size_t end = at_;
  while (end < text_.size() && is_xml_space(text_[end])) ++end;
  skip_to(end);
}

std::string_view XmlScanner::take_name() {
  const std::size_t first = at_;
  while (at_ < text_.size() && is_name_character(text_[at_])) ++at_;
  return text_.substr(first, at_ - first);
}

void XmlScanner::read_attributes(XmlTag& tag) {
  while (true) {
    skip_blanks();
    const std::string name(take_name());
    if (name.empty()) return;
    skip_blanks();
    if (at_ >= text_.size() || text_[at_] != '=') refuse(fmt::format("attribute {} has no value", quote_field(name)));
    skip_to(at_ + 1);
    skip_blanks();
    const char quote = at_ < text_.size() ? text_[at_] : ' ';
    const std::size_t end = quote == '"' || quote == '\'' ? text_.find(quote, at_ + 1) : std::string_view::npos;
    if (end == std::string_view::npos)
      refuse(fmt::format("the value of attribute {} is not in quotes", quote_field(name)));
    tag.attributes[name] = replace_entities(text_.substr(at_ + 1, end - at_ - 1));
    if (tag.attributes.size() > most_attributes) refuse("a tag has too many attributes");
    skip_to(end + 1);
  }
}

/// Updates the open tags.
void XmlScanner::keep_open(XmlTag& tag) {
  if (tag.closes) {
    if (open_.empty() || open_.back() != tag.name)
      refuse(fmt::format("</{}> closes {}", tag.name,
                         open_.empty() ? std::string("nothing") : fmt::format("<{}>", open_.back())));
    open_.pop_back();
    return;
  }
  if (open_.size() >= deepest_tag) refuse("tags are too deep in each other");
  open_.push_back(tag.name);
}

void XmlScanner::read_tag(XmlTag& tag) {
  tag = XmlTag{};
  tag.place = place_;
  ++at_;
  if (at_ < text_.size() && text_[at_] == '/') {
    tag.closes = true;
    ++at_;
  }
  tag.name = take_name();
  if (tag.name.empty()) refuse("a tag has no name");
  read_attributes(tag);
  has_closed_itself_ = !tag.closes && at_ < text_.size() && text_[at_] == '/';
  if (has_closed_itself_) ++at_;
  if (at_ >= text_.size() || text_[at_] != '>') refuse(fmt::format("tag <{}> has no end", tag.name));
  skip_to(at_ + 1);
  keep_open(tag);
  is_done_ = tag.name == "AppendedData" && !tag.closes;
  tag.text = text_.substr(at_);
  if (!is_done_) tag.text = tag.text.substr(0, tag.text.find('<'));
}

bool XmlScanner::next(XmlTag& tag) {
  if (is_done_) return false;
  if (has_closed_itself_) open_.pop_back();
  has_closed_itself_ = false;
  do {
    const std::size_t found = text_.find('<', at_);
    if (found == std::string_view::npos) {
      if (!open_.empty()) refuse(fmt::format("the file ends within <{}>", open_.back()));
      return false;
    }
    skip_to(found);
  } while (skip_remarks());
  read_tag(tag);
  return true;
}

bool XmlScanner::is_within(std::string_view name) const {
  return std::find(open_.begin(), open_.end(), name) != open_.end();
}

}  // namespace percuss
