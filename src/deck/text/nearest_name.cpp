#include "src/deck/text/nearest_name.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

namespace percuss {
namespace {

// No name that percuss knows is longer; a longer word is not a misspelling of one, and the work stays bounded.
constexpr std::size_t longest_name = 64;

// A list of more names than this hides what it should show.
constexpr std::size_t most_listed = 12;

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

bool begins_with(std::string_view word, std::string_view start) {
  return start.size() >= 3 && word.size() > start.size() && edit_distance(word.substr(0, start.size()), start) == 0;
}

}  // namespace

int edit_distance(std::string_view a, std::string_view b) {
  a = a.substr(0, longest_name);
  b = b.substr(0, longest_name);
  std::array<std::array<int, longest_name + 1>, 3> rows{};  // rows i - 2, i - 1 and i of the table, by i modulo 3
  for (std::size_t j = 0; j <= b.size(); ++j) rows[0][j] = static_cast<int>(j);
  for (std::size_t i = 1; i <= a.size(); ++i) {
    auto& row = rows[i % 3];
    const auto& above = rows[(i + 2) % 3];
    const auto& two_above = rows[(i + 1) % 3];
    row[0] = static_cast<int>(i);
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const bool same = lower(a[i - 1]) == lower(b[j - 1]);
      row[j] = std::min({above[j] + 1, row[j - 1] + 1, above[j - 1] + (same ? 0 : 1)});
      const bool swapped = i > 1 && j > 1 && lower(a[i - 1]) == lower(b[j - 2]) && lower(a[i - 2]) == lower(b[j - 1]);
      if (swapped) row[j] = std::min(row[j], two_above[j - 2] + 1);
    }
  }
  return rows[a.size() % 3][b.size()];
}

std::string nearest_name(std::string_view wanted, const std::vector<std::string>& known) {
  if (wanted.empty() || wanted.size() > longest_name) return {};
  const std::string* best = nullptr;
  int best_distance = 0;
  for (const std::string& name : known) {
    int distance = edit_distance(wanted, name);
    // A third of the letters wrong is still a typing error; more is another word.
    const int shorter = static_cast<int>(std::min(wanted.size(), name.size()));
    const int most = std::min(std::max(1, shorter / 3), shorter - 1);
    if (distance > most) {
      if (!begins_with(name, wanted) && !begins_with(wanted, name)) continue;
      distance = most + 1;
    }
    if (best == nullptr || distance < best_distance) {
      best = &name;
      best_distance = distance;
    }
  }
  return best == nullptr ? std::string{} : *best;
}

std::string name_hint(std::string_view wanted, const std::vector<std::string>& known) {
  if (const std::string near = nearest_name(wanted, known); !near.empty()) return " (did you mean '" + near + "'?)";
  if (known.empty()) return {};
  std::string text = " (known: ";
  for (std::size_t i = 0; i < std::min(known.size(), most_listed); ++i) text += (i > 0 ? ", " : "") + known[i];
  return text + (known.size() > most_listed ? ", ...)" : ")");
}

}  // namespace percuss
