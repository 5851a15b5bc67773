#include "src/output/files/safe_text.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "src/utf8.hpp"

namespace percuss {
namespace {

struct CodeRange {
  char32_t first, last;
};

// C0, DEL and C1; marks and overrides of direction, and separators (Unicode Standard Annex 9, table 2); what is no
// character at all.
constexpr CodeRange orders[] = {{0x00, 0x1F},     {0x7F, 0x9F},     {0x61C, 0x61C},   {0x200E, 0x200F},
                                {0x2028, 0x202E}, {0x2066, 0x2069}, {0xFFF9, 0xFFFB}, {0xFFFE, 0xFFFF}};

bool is_order(char32_t code) {
  return std::any_of(std::begin(orders), std::end(orders),
                     [&](const CodeRange& range) { return code >= range.first && code <= range.last; });
}

/// Calls take(character, its bytes) for one after the other.
template <class Take>
void visit_characters(std::string_view text, const Take& take) {
  while (!text.empty()) {
    const Character character = decode_utf8(text);
    const std::size_t bytes = std::max<std::size_t>(character.bytes, 1);
    take(character, text.substr(0, bytes));
    text.remove_prefix(bytes);
  }
}

std::string escape_for_xml(const Character& character, std::string_view bytes) {
  switch (character.code) {
    case '&':
      return "&amp;";
    case '<':
      return "&lt;";
    case '>':
      return "&gt;";
    case '"':
      return "&quot;";
    default:
      break;
  }
  if (character.bytes == 0 || (character.code >= 0x20 && is_order(character.code))) return "\xEF\xBF\xBD";
  return character.code < 0x20 ? " " : std::string(bytes);
}

}  // namespace

std::string make_printable(std::string_view text) {
  std::string safe;
  safe.reserve(text.size());
  visit_characters(text, [&](const Character& character, std::string_view bytes) {
    const bool is_layout = character.code == '\n' || character.code == '\t';
    if (character.bytes == 0)
      safe += fmt::format("\\x{:02x}", static_cast<unsigned char>(bytes[0]));
    else if (is_layout || !is_order(character.code))
      safe += bytes;
    else if (character.code < 0x80)
      safe += fmt::format("\\x{:02x}", static_cast<unsigned>(character.code));
    else
      safe += fmt::format("\\u{:04x}", static_cast<unsigned>(character.code));
  });
  return safe;
}

std::string escape_xml(std::string_view text) {
  std::string escaped;
  visit_characters(
      text, [&](const Character& character, std::string_view bytes) { escaped += escape_for_xml(character, bytes); });
  return escaped;
}

void print_text(std::FILE* stream, std::string_view text) { fmt::print(stream, "{}", make_printable(text)); }

}  // namespace percuss
