#pragma once
// Numbers and words as text formats of meshes write them.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace percuss {

/// The text without blanks at both ends.
std::string_view strip_blanks(std::string_view text);

/// The text in capitals.
std::string to_upper(std::string_view text);

/// Whether the first line that is neither empty nor a comment begins with a word, written in capitals. comment: what
/// comments begin with.
bool begins_with_word(std::string_view text, std::string_view word, std::string_view comment);

/// A whole number, also as "7." or "+7"; none: it is something else, or too large for 64 bits.
std::optional<std::int64_t> parse_integer(std::string_view text);

/// A finite number, also with a D for its exponent or with none ("1.5-10" is 1.5e-10).
std::optional<double> parse_real(std::string_view text);

/// The text as a message quotes it: short and printable.
std::string quote_field(std::string_view text);

}  // namespace percuss
