#include "src/mesh/files/text_source.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <limits>

#include "src/error.hpp"
#include "src/regular_file.hpp"

namespace percuss {

std::string TextNames::at(TextPlace place) const {
  return fmt::format("{}:{}: ", names_[static_cast<std::size_t>(place.file)], place.line);
}

void TextNames::refuse(TextPlace place, const std::string& text) const { throw InputError(at(place) + text); }

TextSource::TextSource(const std::string& path, TextNames& names) {
  if (const std::string kind = describe_irregular_file(path); !kind.empty())
    throw InputError(fmt::format("{} is {}", path, kind));
  std::ifstream stream(path, std::ios::binary);
  std::error_code unreadable;
  const std::uintmax_t bytes = std::filesystem::file_size(path, unreadable);
  if (!stream || unreadable) throw SystemError(fmt::format("{} cannot be opened", path));
  std::string text(bytes, '\0');
  stream.read(text.data(), static_cast<std::streamsize>(bytes));
  if (static_cast<std::uintmax_t>(stream.gcount()) != bytes) throw SystemError(fmt::format("{} cannot be read", path));
  text_ = std::make_shared<const std::string>(std::move(text));
  place_.file = names.add(path);
}

bool TextSource::next_line(std::string_view& line) {
  if (next_ >= text_->size() || place_.line == std::numeric_limits<int>::max()) return false;
  last_ = next_;
  const std::size_t end = std::min(text_->find('\n', next_), text_->size());
  line = std::string_view(*text_).substr(next_, end - next_);
  if (line.ends_with('\r')) line.remove_suffix(1);
  next_ = end + 1;
  ++place_.line;
  return true;
}

}  // namespace percuss
