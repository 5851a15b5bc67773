#include "src/mesh/files/unread_words.hpp"

#include <fmt/format.h>

#include "src/mesh/files/text_numbers.hpp"

namespace percuss {

std::string describe_unread(const std::set<std::string>& words, std::string_view mark) {
  constexpr std::size_t most = 12;
  std::string text;
  std::size_t count = 0;
  for (const std::string& word : words) {
    if (++count > most) break;
    const std::string quoted = quote_field(word);
    text += fmt::format("{}{}{}", text.empty() ? "" : ", ", mark, quoted.substr(1, quoted.size() - 2));
  }
  if (words.size() > most) text += fmt::format(" and {} more", words.size() - most);
  return text + " of the file are not read (the mesh alone is)";
}

}  // namespace percuss
