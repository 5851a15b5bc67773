#include "src/deck/text/deck_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>

#include "src/deck/text/table_text.hpp"
#include "src/error.hpp"
#include "src/regular_file.hpp"
#include "src/utf8.hpp"

namespace percuss {
namespace {

bool is_continuation(char c) { return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U; }

// Fault of the character at i; empty if there is none. `length` is its length in bytes.
std::string find_fault(std::string_view text, std::size_t i, std::size_t& length) {
  const auto c = static_cast<unsigned char>(text[i]);
  length = decode_utf8(text.substr(i)).bytes;
  if (c == 0) return "the file is not text (it holds a NUL byte): save the deck as UTF-8 text";
  if (length == 0)
    return fmt::format("the file is not UTF-8 text (byte 0x{:02x} does not belong): save the deck as UTF-8", c);
  if (c == '\r' && (i + 1 == text.size() || text[i + 1] != '\n')) {
    return "a carriage return stands alone (lines end with LF or CR LF)";
  }
  const bool control = (c < 0x20 && c != '\t' && c != '\n' && c != '\r') || c == 0x7F;
  if (control) return fmt::format("the file is not text (it holds the control character 0x{:02x})", c);
  return {};
}

}  // namespace

std::string load_deck_text(const std::string& file) {
  std::error_code ignored;
  const auto status = std::filesystem::status(file, ignored);
  if (!std::filesystem::exists(status)) throw InputError(file + ": error: no such file");
  if (std::filesystem::is_directory(status)) {
    throw InputError(file + ": error: a folder, not a deck (perhaps " +
                     (std::filesystem::path(file) / "deck.yaml").string() + ")");
  }
  if (const std::string kind = describe_irregular_file(file); !kind.empty())
    throw InputError(fmt::format("{}: error: the deck is {}", file, kind));
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> stream(std::fopen(file.c_str(), "rb"), &std::fclose);
  if (!stream) throw SystemError(fmt::format("{}: cannot be opened ({})", file, std::strerror(errno)));
  std::string text(largest_deck + 1, '\0');  // one more byte tells that there is more
  text.resize(std::fread(text.data(), 1, text.size(), stream.get()));
  if (std::ferror(stream.get()) != 0)
    throw SystemError(fmt::format("{}: reading failed ({})", file, std::strerror(errno)));
  return text;
}

std::string describe_other_model(std::string_view text, const std::string& file) {
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    const bool is_comment = line.starts_with('$') || line.starts_with("**");
    if (is_comment || line.find_first_not_of(" \t\r") == std::string_view::npos) continue;
    if (line.size() < 2 || line[0] != '*' || std::isalpha(static_cast<unsigned char>(line[1])) == 0) return {};
    const std::string extension = std::filesystem::path(file).extension().string();
    const char* program = extension == ".inp"                                               ? "an Abaqus"
                          : extension == ".k" || extension == ".key" || extension == ".dyn" ? "an LS-DYNA"
                                                                                            : "an LS-DYNA or Abaqus";
    return fmt::format("this is {} model (percuss runs decks in YAML): percuss import {} --out DIR", program, file);
  }
  return {};
}

bool check_deck_text(std::string& text, DeckErrors& errors) {
  if (text.size() > largest_deck) {
    errors.add({}, fmt::format("the file is larger than {} MiB (the largest size of a deck): is this a deck?",
                               largest_deck >> 20U));
    return false;
  }
  if (text.starts_with(byte_order_mark)) text.erase(0, byte_order_mark.size());
  if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF")) {
    errors.add({{1, 1}, -1}, "the file is UTF-16 text (must be UTF-8): save the deck as UTF-8");
    return false;
  }
  Place place{1, 1};
  for (std::size_t i = 0, length = 1; i < text.size(); i += length) {
    if (std::string fault = find_fault(text, i, length); !fault.empty()) {
      errors.add({place, -1}, std::move(fault));
      return false;
    }
    place = text[i] == '\n' ? Place{place.line + 1, 1} : Place{place.line, place.column + 1};
  }
  return true;
}

PlaceFinder::PlaceFinder(std::string_view text) : text_(text), line_starts_{0} {
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '\n') line_starts_.push_back(i + 1);
  }
}

Place PlaceFinder::place(int line, int byte_column) {
  const auto index = std::min(static_cast<std::size_t>(std::max(line, 0)), line_starts_.size() - 1);
  const auto end = static_cast<std::size_t>(std::max(byte_column, 0));
  if (index != line_ || end < byte_) {
    line_ = index;
    byte_ = 0;
    characters_ = 0;
  }
  const std::string_view rest = text_.substr(line_starts_[index]);
  for (; byte_ < std::min(end, rest.size()); ++byte_) characters_ += is_continuation(rest[byte_]) ? 0 : 1;
  return {static_cast<int>(index) + 1, characters_ + 1};
}

bool PlaceFinder::is_quote_closed(int line, int byte_column) const {
  if (line < 0 || byte_column < 0 || static_cast<std::size_t>(line) >= line_starts_.size()) return true;
  std::size_t i = line_starts_[static_cast<std::size_t>(line)] + static_cast<std::size_t>(byte_column);
  if (i >= text_.size() || (text_[i] != '"' && text_[i] != '\'')) return true;
  const char quote = text_[i];
  for (++i; i < text_.size(); ++i) {
    const bool is_doubled = quote == '\'' && text_[i] == quote && i + 1 < text_.size() && text_[i + 1] == quote;
    if (is_doubled || (quote == '"' && text_[i] == '\\'))
      ++i;  // '' and \" are quotes within the quoted text
    else if (text_[i] == quote)
      return true;
  }
  return false;
}

}  // namespace percuss
