#include "src/deck/yaml/deck_values.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>

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

/// What sensors look at is part of the motion.
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

void list_values(const std::string& path, const Node& node, bool has_sensors, std::vector<std::string>& out) {
  if (is_free(path, has_sensors)) return;
  const auto below = [&](const std::string& name) { return path.empty() ? name : path + "." + name; };
  switch (node.kind) {
    case Node::Kind::null:
      return;
    case Node::Kind::scalar:
      out.push_back(path + " = " + describe_value(node));
      return;
    case Node::Kind::list:
      for (std::size_t i = 0; i < node.items.size(); ++i)
        list_values(below(std::to_string(i)), node.items[i], has_sensors, out);
      return;
    case Node::Kind::map:
      for (const Entry& entry : node.entries) list_values(below(entry.name), entry.value, has_sensors, out);
      return;
  }
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
  list_values("", deck, deck.find("sensors") != nullptr, values);
  for (std::string& value : values) std::replace(value.begin(), value.end(), '\n', ' ');  // a line each
  std::sort(values.begin(), values.end());
  return values;
}

std::vector<std::string> compare_motion_values(const std::vector<std::string>& now,
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

}  // namespace percuss
