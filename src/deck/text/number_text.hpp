#pragma once
// Numbers as YAML 1.2's core schema writes them, and the advice for those who wrote them otherwise.

#include <string>
#include <string_view>
#include <variant>

namespace percuss {

/// Whether a character is a decimal digit, whatever the locale.
inline bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// Why a text is no number that can be taken: what it must be, e.g. "a number; decimals take a point: 1.5".
struct NumberProblem {
  std::string must_be;
};

/// The double that a text means: "2", "-0.5", "1e-3", "200e9", ".5"; never NaN, infinite, hexadecimal, with leading
/// zeros, a decimal comma or a unit. Does not depend on the locale.
std::variant<double, NumberProblem> read_number(std::string_view text);

/// The integer that a text means: decimal digits with an optional sign. "8.0" and "8e3" are refused, not truncated.
std::variant<long long, NumberProblem> read_integer(std::string_view text);

/// Whether a plain text is one of YAML's booleans: true, True, TRUE, false, False, FALSE.
bool is_boolean(std::string_view text);

}  // namespace percuss
