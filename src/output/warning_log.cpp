#include "src/output/warning_log.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

#include "src/error.hpp"
#include "src/output/warning_json.hpp"

namespace percuss {

WarningLog::WarningLog(std::set<std::string> silenced, Report report)
    : silenced_(std::move(silenced)), report_(std::move(report)) {}

void WarningLog::append(const Warning& warning) {
  warnings_.push_back(warning);
  if (report_) report_(warning);
}

void WarningLog::add(const Warning& warning) {
  if (is_silenced(warning.rule)) return;
  const auto earlier = std::find_if(warnings_.begin(), warnings_.end(), [&](const Warning& other) {
    return other.rule == warning.rule && other.place == warning.place && other.text == warning.text;
  });
  if (earlier == warnings_.end()) return append(warning);
  earlier->count += warning.count;
}

void WarningLog::add(const std::vector<Warning>& warnings) {
  for (const Warning& warning : warnings) add(warning);
}

void WarningLog::renew(const Warning& warning) {
  if (is_silenced(warning.rule)) return;
  const auto earlier = std::find_if(warnings_.begin(), warnings_.end(), [&](const Warning& other) {
    return other.rule == warning.rule && other.place == warning.place;
  });
  if (earlier == warnings_.end()) return append(warning);
  earlier->text = warning.text;
  earlier->count += warning.count;
}

void WarningLog::restore(const std::vector<Warning>& warnings) {
  std::copy_if(warnings.begin(), warnings.end(), std::back_inserter(warnings_),
               [&](const Warning& warning) { return !is_silenced(warning.rule); });
}

std::string count_warnings(const std::vector<Warning>& warnings) {
  return std::to_string(warnings.size()) + (warnings.size() == 1 ? " warning" : " warnings");
}

std::string write_warnings(const std::vector<Warning>& warnings) {
  using Json = nlohmann::ordered_json;
  return to_json(warnings).dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::vector<Warning> read_warnings(const std::string& text) {
  const auto json = nlohmann::ordered_json::parse(text, nullptr, false);
  auto warnings = json.is_discarded() ? std::nullopt : from_json(json);
  if (!warnings) throw InputError("not a list of warnings");
  return *std::move(warnings);
}

}  // namespace percuss
