#pragma once
// The text of a deck before YAML sees it: size, encoding, control characters.

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "src/deck/text/deck_errors.hpp"

namespace percuss {

/// The bytes of a file. Throws InputError if there is no such file, if it is a folder or larger than a deck can be
/// (largest_deck), SystemError if reading fails.
std::string load_deck_text(const std::string& file);

/// What a file is that other programs read, and how to get a deck from it: "this is an LS-DYNA model (...): percuss
/// import FILE --out DIR"; empty: something else.
std::string describe_other_model(std::string_view text, const std::string& file);

/// Checks that the text is UTF-8 without control characters and not larger than largest_deck; a byte order mark is
/// taken off. Adds one error, with its place, and returns false if not.
bool check_deck_text(std::string& text, DeckErrors& errors);

/// Turns lines and bytes counted from 0, as yaml-cpp marks them, into lines and characters counted from 1.
class PlaceFinder {
 public:
  explicit PlaceFinder(std::string_view text);  // must outlive the finder
  Place place(int line, int byte_column);

  /// Whether the quoted scalar that begins there ends; true if no quote is there.
  bool is_quote_closed(int line, int byte_column) const;

 private:
  std::string_view text_;
  std::vector<std::size_t> line_starts_;
  // Where the last call ended: positions are requested in the order of the text, and a line may be megabytes long.
  std::size_t line_ = 0, byte_ = 0;
  int characters_ = 0;
};

/// Bytes; past this the file is taken for something else (a table of 100 000 rows fits).
inline constexpr std::size_t largest_deck = std::size_t{4} << 20;

}  // namespace percuss
