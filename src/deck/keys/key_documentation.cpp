#include "src/deck/keys/key_documentation.hpp"

#include <sstream>
#include <vector>

namespace percuss {
namespace {

std::string trim(const std::string& text) {
  const auto first = text.find_first_not_of(' ');
  return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(' ') - first + 1);
}

/// The cells of "| a | b \| c |".
std::vector<std::string> split_row(const std::string& line) {
  std::vector<std::string> cells;
  std::string cell;
  for (std::size_t i = 1; i < line.size(); ++i) {
    if (line.compare(i, 2, "\\|") == 0) {
      cell += line[++i];
    } else if (line[i] == '|') {
      cells.push_back(trim(cell));
      cell.clear();
    } else {
      cell += line[i];
    }
  }
  return cells;
}

/// The text with "words" in place of "[words](address)", whose address means nothing elsewhere.
std::string without_links(std::string text) {
  for (auto middle = text.find("]("); middle != std::string::npos; middle = text.find("](")) {
    const auto open = text.rfind('[', middle), close = text.find(')', middle);
    if (open == std::string::npos || close == std::string::npos) break;
    text = text.substr(0, open) + text.substr(open + 1, middle - open - 1) + text.substr(close + 1);
  }
  return text;
}

}  // namespace

std::map<std::string, KeyDocumentation> read_key_documentation(const std::string& page) {
  std::map<std::string, KeyDocumentation> all;
  std::istringstream stream(page);
  for (std::string line; std::getline(stream, line);) {
    if (!line.starts_with("| `")) continue;
    const std::vector<std::string> cells = split_row(line);
    if (cells.size() != 5) continue;  // the forms of a curve
    const std::string path = cells[0].substr(1, cells[0].size() - 2);
    all[path] = {cells[1], without_links(cells[2]), cells[3], without_links(cells[4])};
  }
  return all;
}

}  // namespace percuss
