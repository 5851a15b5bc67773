#include "src/mesh/files/text_numbers.hpp"

#include <array>
#include <cctype>
#include <charconv>
#include <cmath>

namespace percuss {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r'; }

}  // namespace

std::string_view strip_blanks(std::string_view text) {
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return text;
}

std::string to_upper(std::string_view text) {
  std::string upper(text);
  for (char& c : upper) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return upper;
}

std::optional<std::int64_t> parse_integer(std::string_view text) {
  text = strip_blanks(text);
  if (text.size() > 1 && text.front() == '+' && is_digit(text[1])) text.remove_prefix(1);
  std::int64_t value = 0;
  const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (fault != std::errc() || text.empty()) return {};
  std::string_view rest = text.substr(static_cast<std::size_t>(end - text.data()));
  if (rest.starts_with('.')) rest.remove_prefix(1);
  return rest.find_first_not_of('0') == std::string_view::npos ? std::optional(value) : std::nullopt;
}

std::optional<double> parse_real(std::string_view text) {
  text = strip_blanks(text);
  if (text.size() > 1 && text.front() == '+') text.remove_prefix(1);
  std::array<char, 64> digits{};
  std::size_t count = 0;
  bool has_exponent = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (count + 2 > digits.size()) return {};
    char c = text[i];
    if (!is_digit(c) && c != '.' && c != '+' && c != '-' && c != 'e' && c != 'E' && c != 'd' && c != 'D') return {};
    if (std::isalpha(static_cast<unsigned char>(c)) != 0) {
      c = 'e';
      has_exponent = true;
    } else if ((c == '+' || c == '-') && i > 0 && !has_exponent) {
      digits[count++] = 'e';
      has_exponent = true;
    }
    if (c == '+' && count > 0 && digits[count - 1] == 'e') continue;  // from_chars takes no plus
    digits[count++] = c;
  }
  double value = 0;
  const auto [end, fault] = std::from_chars(digits.data(), digits.data() + count, value);
  if (count == 0 || fault != std::errc() || end != digits.data() + count || !std::isfinite(value)) return {};
  return value;
}

std::string quote_field(std::string_view text) {
  constexpr std::size_t most = 40;
  std::string quoted = "'";
  for (const char c : strip_blanks(text).substr(0, most)) quoted += c >= ' ' && c <= '~' ? c : '?';
  return quoted + (strip_blanks(text).size() > most ? "...'" : "'");
}

bool begins_with_word(std::string_view text, std::string_view word, std::string_view comment) {
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string line = to_upper(strip_blanks(text.substr(0, end)));
    if (!line.empty() && !line.starts_with(comment)) return line.starts_with(word);
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return false;
}

}  // namespace percuss
