#pragma once
// Text from decks, files and libraries on its way to a terminal or into XML, where some characters are orders.

#include <cstdio>
#include <string>
#include <string_view>

namespace percuss {

/// The text as it may be printed. Characters that a terminal obeys instead of showing them (C0 but tabs and line ends,
/// DEL, C1) and marks that turn the direction of writing become "\x1b" or "\u202e", as do bytes that are no UTF-8.
std::string make_printable(std::string_view text);

/// The text as the value of an attribute of XML 1.0: marks of XML escaped, C0 as spaces, and U+FFFD for what XML does
/// not allow or a terminal would obey.
std::string escape_xml(std::string_view text);

/// Prints make_printable(text). Throws std::system_error if the stream takes it not.
void print_text(std::FILE* stream, std::string_view text);

}  // namespace percuss
