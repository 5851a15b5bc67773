#include "src/output/warning_json.hpp"

namespace percuss {
namespace {

using Json = nlohmann::ordered_json;

std::optional<Warning> read_warning(const Json& json) {
  if (!json.is_object()) return std::nullopt;
  const auto has = [&](const char* key, bool (Json::*is_type)() const noexcept) {
    const auto found = json.find(key);
    return found != json.end() && ((*found).*is_type)();
  };
  for (const char* key : {"rule", "text", "place"}) {
    if (!has(key, &Json::is_string)) return std::nullopt;
  }
  if (!has("time", &Json::is_number) || !has("count", &Json::is_number_integer)) return std::nullopt;
  return Warning{json["rule"], json["text"], json["place"], json["time"], json["count"]};
}

}  // namespace

Json to_json(const std::vector<Warning>& warnings) {
  Json list = Json::array();
  for (const Warning& w : warnings) {
    list.push_back({{"rule", w.rule}, {"text", w.text}, {"place", w.place}, {"time", w.time}, {"count", w.count}});
  }
  return list;
}

std::optional<std::vector<Warning>> from_json(const Json& json) {
  if (!json.is_array()) return std::nullopt;
  std::vector<Warning> warnings;
  for (const Json& item : json) {
    auto warning = read_warning(item);
    if (!warning) return std::nullopt;
    warnings.push_back(*std::move(warning));
  }
  return warnings;
}

}  // namespace percuss
