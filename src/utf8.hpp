#pragma once
// UTF-8, one character at a time.

#include <cstddef>
#include <string_view>

namespace percuss {

/// A character and how many bytes it takes. bytes 0: the text does not begin with UTF-8.
struct Character {
  char32_t code = 0;
  std::size_t bytes = 0;
};

/// The first character of a text (RFC 3629, section 4: overlong forms, surrogates and codes above U+10FFFF are none).
inline Character decode_utf8(std::string_view text) {
  const auto byte = [&](std::size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0U; };
  const unsigned lead = byte(0);
  if (text.empty()) return {};
  if (lead < 0x80) return {lead, 1};
  const std::size_t bytes = lead >= 0xC2 && lead <= 0xDF   ? 2
                            : (lead & 0xF0U) == 0xE0       ? 3
                            : lead >= 0xF0 && lead <= 0xF4 ? 4
                                                           : 0;
  if (bytes == 0) return {};
  char32_t code = lead & (0x7FU >> bytes);
  for (std::size_t i = 1; i < bytes; ++i) {
    if ((byte(i) & 0xC0U) != 0x80U) return {};
    code = code << 6U | (byte(i) & 0x3FU);
  }
  const bool is_surrogate = code >= 0xD800 && code <= 0xDFFF,
             is_overlong = bytes > 2 && code < (bytes == 3 ? 0x800 : 0x10000);
  if (is_surrogate || is_overlong || code > 0x10FFFF) return {};
  return {code, bytes};
}

}  // namespace percuss
