#include "src/deck/deck_errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <tuple>
#include <utility>

#include "src/error.hpp"

namespace percuss {
namespace {

// Past this, the file is no deck; stopping keeps the work bounded.
constexpr std::size_t most_errors = 500;

// The same message at more places than this is said once more with a count.
constexpr int most_repeats = 3;

auto sort_key(Spot spot) { return std::tuple(spot.override, spot.place.line, spot.place.column); }

}  // namespace

DeckErrors::DeckErrors(std::string file, std::vector<std::string> override_paths)
    : file_(std::move(file)), override_paths_(std::move(override_paths)) {}

void DeckErrors::add(Spot spot, std::string message) {
  errors_.push_back({spot, std::move(message)});
  if (errors_.size() >= most_errors) throw_if_any();
}

void DeckErrors::warn(Spot spot, std::string message) {
  if (warnings_.size() < most_errors) warnings_.push_back({spot, std::move(message)});
}

void DeckErrors::throw_if_any() const {
  if (errors_.empty()) return;
  std::string text;
  for (const std::string& line : format(errors_, "error")) {
    if (!text.empty()) text += '\n';
    text += line;
  }
  if (errors_.size() >= most_errors)
    text += fmt::format("\n{}: error: too many errors (stopped at {})", file_, most_errors);
  throw InputError(text);
}

std::vector<std::string> DeckErrors::warnings() const { return format(warnings_, "warning"); }

std::string DeckErrors::name(Spot spot) const {
  if (spot.override >= 0) return "--set " + override_paths_.at(static_cast<std::size_t>(spot.override));
  if (spot.place.line == 0) return file_;
  return fmt::format("{}:{}:{}", file_, spot.place.line, spot.place.column);
}

std::vector<std::string> DeckErrors::format(std::vector<Message> messages, const char* severity) const {
  std::stable_sort(messages.begin(), messages.end(),
                   [](const Message& a, const Message& b) { return sort_key(a.spot) < sort_key(b.spot); });
  std::map<std::string, int> times;
  std::vector<std::string> lines;
  for (const Message& m : messages) {
    std::string line = fmt::format("{}: {}: {}", name(m.spot), severity, m.text);
    if (std::find(lines.begin(), lines.end(), line) != lines.end()) continue;
    if (++times[m.text] <= most_repeats) lines.push_back(std::move(line));
  }
  for (const auto& [text, count] : times) {
    if (count <= most_repeats) continue;
    lines.push_back(fmt::format("{}: {}: {} more times: {}", file_, severity, count - most_repeats, text));
  }
  return lines;
}

}  // namespace percuss
