#include "src/deck/text/deck_errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <tuple>
#include <utility>

#include "src/error.hpp"

namespace percuss {
namespace {

// Past this, the file is no deck; stopping keeps the work bounded.
constexpr std::size_t most_errors = 500;

// A message that occurs at more places than this is said once more with a count.
constexpr int most_repeats = 3;

auto sort_key(Spot spot) { return std::tuple(spot.override, spot.place.line, spot.place.column); }

}  // namespace

DeckErrors::DeckErrors(std::string file, std::vector<std::string> override_paths)
    : file_(std::move(file)), override_paths_(std::move(override_paths)) {}

void DeckErrors::add(Spot spot, std::string message) {
  if (spot.place.line < 0) spot.override = -spot.place.line - 1;  // of a value that is read: see Deck::where()
  errors_.push_back({spot, "", std::move(message)});
  if (errors_.size() >= most_errors) throw_if_any();
}

void DeckErrors::warn(Spot spot, std::string rule, std::string message) {
  if (warnings_.size() < most_errors) warnings_.push_back({spot, std::move(rule), std::move(message)});
}

void DeckErrors::throw_if_any() const {
  if (errors_.empty()) return;
  std::string text;
  const auto [shown, others] = collapse(errors_);
  const auto add_line = [&](const std::string& line) { text += (text.empty() ? "" : "\n") + line; };
  for (const Warning& error : shown) add_line(fmt::format("{}: error: {}", error.place, error.text));
  for (const Warning& error : others)
    add_line(fmt::format("{}: error: {} more times: {}", error.place, error.count, error.text));
  if (errors_.size() >= most_errors)
    text += fmt::format("\n{}: error: too many errors (stopped at {})", file_, most_errors);
  throw InputError(text);
}

std::vector<Warning> DeckErrors::warnings() const {
  auto [all, others] = collapse(warnings_);
  all.insert(all.end(), others.begin(), others.end());
  return all;
}

std::string DeckErrors::name(Spot spot) const {
  if (spot.override >= 0) return "--set " + override_paths_.at(static_cast<std::size_t>(spot.override));
  if (spot.place.line == 0) return file_;
  return fmt::format("{}:{}:{}", file_, spot.place.line, spot.place.column);
}

DeckErrors::Collapsed DeckErrors::collapse(std::vector<Message> messages) const {
  std::stable_sort(messages.begin(), messages.end(),
                   [](const Message& a, const Message& b) { return sort_key(a.spot) < sort_key(b.spot); });
  Collapsed found;
  std::map<std::string, Warning> others;  // by text
  std::set<std::pair<std::string, std::string>> printed;
  std::map<std::string, int> times;
  for (const Message& m : messages) {
    std::string place = name(m.spot);
    if (!printed.emplace(place, m.text).second) continue;
    if (++times[m.text] <= most_repeats) {
      found.shown.push_back({m.rule, m.text, std::move(place), 0, 1});
    } else {
      others.try_emplace(m.text, Warning{m.rule, m.text, file_, 0, 0}).first->second.count += 1;
    }
  }
  for (const auto& [text, other] : others) found.others.push_back(other);
  return found;
}

}  // namespace percuss
