#pragma once
// Warnings as JSON, in summary.json and in checkpoints: one form for both.

#include <nlohmann/json.hpp>
#include <optional>
#include <vector>

#include "src/warning.hpp"

namespace percuss {

/// [{"rule": ..., "text": ..., "place": ..., "time": ..., "count": ...}, ...]
nlohmann::ordered_json to_json(const std::vector<Warning>& warnings);

/// Nothing if a key is missing or has another type.
std::optional<std::vector<Warning>> from_json(const nlohmann::ordered_json& json);

}  // namespace percuss
