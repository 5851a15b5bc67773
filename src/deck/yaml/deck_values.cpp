#include "src/deck/yaml/deck_values.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <string_view>
#include <utility>

#include "src/deck/text/number_text.hpp"

namespace percuss {
namespace {

constexpr std::array<const char*, 10> free_to_change{"title",
                                                     "units",
                                                     "silence",
                                                     "output",
                                                     "audit",
                                                     "time.end",
                                                     "time.max_steps",
                                                     "time.until",
                                                     "time.collapse_ratio",
                                                     "contact.rebalance"};

/// Whether sensors may read the value: what they read is part of the motion.
bool is_watched(const std::string& path) { return path == "output" || path.starts_with("output.history"); }

bool is_free(const std::string& path, bool has_sensors) {
  if (has_sensors && is_watched(path)) return false;
  if (has_sensors && path.starts_with("output.")) return true;
  if (path.starts_with("parts.") && (path.ends_with(".exodus.file") || path.ends_with(".mesh.file"))) return true;
  return std::find(free_to_change.begin(), free_to_change.end(), path) != free_to_change.end();
}

std::string describe_value(const Node& node) {
  const auto number = read_number(node.text);
  if (!node.quoted && std::holds_alternative<double>(number)) return fmt::format("{}", std::get<double>(number));
  return node.text;
}

/// Selects the values that are listed: those on which the motion depends, or the others.
struct Listing {
  bool has_sensors, is_of_free;
};

void list_values(const std::string& path, const Node& node, const Listing& listing, bool is_free_above,
                 std::vector<std::string>& out) {
  const bool is_free_here = is_free_above || is_free(path, listing.has_sensors);
  if (is_free_here && !listing.is_of_free) return;
  const auto below = [&](const std::string& name) { return path.empty() ? name : path + "." + name; };
  switch (node.kind) {
    case Node::Kind::null:
      return;
    case Node::Kind::scalar:
      if (is_free_here == listing.is_of_free) out.push_back(path + " = " + describe_value(node));
      return;
    case Node::Kind::list:
      for (std::size_t i = 0; i < node.items.size(); ++i)
        list_values(below(std::to_string(i)), node.items[i], listing, is_free_here, out);
      return;
    case Node::Kind::map:
      for (const Entry& entry : node.entries) list_values(below(entry.name), entry.value, listing, is_free_here, out);
      return;
  }
}

/// Ascending, a line each.
std::vector<std::string> sort_lines(std::vector<std::string> values) {
  for (std::string& value : values) std::replace(value.begin(), value.end(), '\n', ' ');
  std::sort(values.begin(), values.end());
  return values;
}

constexpr std::string_view free_mark = "? ";

/// The lines with the mark, without it; or those without one.
std::vector<std::string> choose_lines(const std::vector<std::string>& lines, bool is_of_free) {
  std::vector<std::string> chosen;
  for (const std::string& line : lines) {
    if (line.starts_with(free_mark) != is_of_free) continue;
    chosen.push_back(is_of_free ? line.substr(free_mark.size()) : line);
  }
  return chosen;
}

std::map<std::string, std::string> split_values(const std::vector<std::string>& lines) {
  std::map<std::string, std::string> values;
  for (const std::string& line : lines) {
    const auto end = line.find(" = ");
    values[line.substr(0, end)] = end == std::string::npos ? "" : line.substr(end + 3);
  }
  return values;
}

}  // namespace

std::vector<std::string> list_motion_values(const Node& deck) {
  std::vector<std::string> values;
  list_values("", deck, {deck.find("sensors") != nullptr, false}, false, values);
  return sort_lines(std::move(values));
}

std::vector<std::string> list_free_values(const Node& deck) {
  std::vector<std::string> values;
  list_values("", deck, {deck.find("sensors") != nullptr, true}, false, values);
  for (std::string& value : values) value.insert(0, free_mark);
  return sort_lines(std::move(values));
}

namespace {

std::vector<std::string> compare_values(const std::vector<std::string>& now,
                                        const std::vector<std::string>& checkpoint) {
  const auto here = split_values(now), there = split_values(checkpoint);
  std::vector<std::string> differences;
  for (const auto& [path, value] : here) {
    const auto found = there.find(path);
    if (found == there.end()) {
      differences.push_back(fmt::format("{} is {} (not given in the checkpoint)", path, value));
    } else if (found->second != value) {
      differences.push_back(fmt::format("{} is {} ({} in the checkpoint)", path, value, found->second));
    }
  }
  for (const auto& [path, value] : there) {
    if (!here.contains(path)) differences.push_back(fmt::format("{} is not given ({} in the checkpoint)", path, value));
  }
  return differences;
}

}  // namespace

std::vector<std::string> compare_motion_values(const std::vector<std::string>& now,
                                               const std::vector<std::string>& checkpoint) {
  return compare_values(choose_lines(now, false), choose_lines(checkpoint, false));
}

std::vector<std::string> compare_free_values(const std::vector<std::string>& now,
                                             const std::vector<std::string>& checkpoint) {
  const std::vector<std::string> before = choose_lines(checkpoint, true);
  return before.empty() ? before : compare_values(choose_lines(now, true), before);
}

}  // namespace percuss
