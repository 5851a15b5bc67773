#include "src/deck/text/number_text.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <system_error>

namespace percuss {
namespace {

std::string_view without_sign(std::string_view text) {
  return !text.empty() && (text[0] == '+' || text[0] == '-') ? text.substr(1) : text;
}

// Length of the digits that the text begins with.
std::size_t count_digits(std::string_view text) {
  std::size_t n = 0;
  while (n < text.size() && is_digit(text[n])) ++n;
  return n;
}

// Length of the longest number that the text begins with: digits [. digits] [e [sign] digits], or . digits ...; 0 if
// none.
std::size_t match_number(std::string_view text) {
  const std::string_view body = without_sign(text);
  const std::size_t sign = text.size() - body.size();
  std::size_t n = count_digits(body);
  std::size_t digits = n;
  if (n < body.size() && body[n] == '.') {
    const std::size_t decimals = count_digits(body.substr(n + 1));
    digits += decimals;
    n += 1 + decimals;
  }
  if (digits == 0) return 0;
  if (n < body.size() && (body[n] == 'e' || body[n] == 'E')) {
    const std::string_view exponent = body.substr(n + 1);
    const std::string_view power = without_sign(exponent);
    const std::size_t length = count_digits(power);
    if (length > 0) n += 1 + (exponent.size() - power.size()) + length;
  }
  return sign + n;
}

bool has_leading_zero(std::string_view text) {
  const std::string_view body = without_sign(text);
  return body.size() > 1 && body[0] == '0' && is_digit(body[1]);
}

bool is_nan_or_infinity(std::string_view text) {
  std::string word;
  for (const char c : without_sign(text)) {
    if (c != '.') word += static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
  }
  return word == "nan" || word == "inf" || word == "infinity";
}

// The text with `from` replaced by `to` if that makes a number of it.
std::string mended(std::string_view text, std::string_view from, std::string_view to) {
  std::string copy;
  for (const char c : text) {
    if (from.find(c) == std::string_view::npos)
      copy += c;
    else
      copy += to;
  }
  return match_number(copy) == copy.size() && !copy.empty() ? copy : std::string{};
}

std::string advise(std::string_view text, const std::string& what) {
  if (is_boolean(text)) return what;
  if (is_nan_or_infinity(text)) return "finite";
  const std::string_view body = without_sign(text);
  if (body.size() > 2 && body[0] == '0' && std::string_view("xXoObB").find(body[1]) != std::string_view::npos) {
    return what + " in decimal digits";
  }
  if (const std::string s = mended(text, ",", "."); !s.empty())
    return fmt::format("{}; decimals take a point: {}", what, s);
  if (const std::string s = mended(text, "_' ", ""); !s.empty())
    return fmt::format("{} without separators: {}", what, s);
  if (const std::string s = mended(text, "dD", "e"); !s.empty())
    return fmt::format("{}; powers of ten take e: {}", what, s);
  if (match_number(text) > 0) return what + " without a unit or other text, in the units of the deck";
  return what;
}

}  // namespace

std::variant<double, NumberProblem> read_number(std::string_view text) {
  if (text.empty() || match_number(text) != text.size()) return NumberProblem{advise(text, "a number")};
  if (has_leading_zero(text)) return NumberProblem{"a number without leading zeros, which read as octal elsewhere"};
  const std::string_view unsigned_plus = text[0] == '+' ? text.substr(1) : text;  // from_chars knows no plus
  double value = 0;
  const auto end = unsigned_plus.data() + unsigned_plus.size();
  const auto [stopped, error] = std::from_chars(unsigned_plus.data(), end, value);
  if (error == std::errc::result_out_of_range)
    return NumberProblem{"within the range of double precision, 1e-308 to 1e308"};
  if (error != std::errc{} || stopped != end || !std::isfinite(value)) return NumberProblem{"a number"};
  return value;
}

std::variant<long long, NumberProblem> read_integer(std::string_view text) {
  const std::string_view body = without_sign(text);
  if (body.empty() || count_digits(body) != body.size()) {
    if (match_number(text) == text.size() && !text.empty()) return NumberProblem{"an integer: digits only"};
    return NumberProblem{advise(text, "an integer")};
  }
  if (has_leading_zero(text)) return NumberProblem{"an integer without leading zeros, which read as octal elsewhere"};
  const std::string_view unsigned_plus = text[0] == '+' ? text.substr(1) : text;
  long long value = 0;
  const auto [stopped, error] =
      std::from_chars(unsigned_plus.data(), unsigned_plus.data() + unsigned_plus.size(), value);
  if (error != std::errc{}) return NumberProblem{"an integer below 9e18"};
  return value;
}

bool is_boolean(std::string_view text) {
  for (const std::string_view word : {"true", "True", "TRUE", "false", "False", "FALSE"}) {
    if (text == word) return true;
  }
  return false;
}

}  // namespace percuss
