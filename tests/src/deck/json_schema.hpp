#pragma once
// A validator for JSON Schema (draft 2020-12), of the keywords that percuss writes and no others.

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace percuss {

/// What is wrong with a value, a line each with its place ("/time/end: ..."); empty if the schema takes it. Throws
/// std::invalid_argument for a keyword that it does not know.
std::vector<std::string> find_faults(const nlohmann::json& schema, const nlohmann::json& value);

/// The scalars of a deck as editors see them, by the core schema of YAML 1.2. Throws std::invalid_argument if the text
/// is no YAML that percuss takes.
nlohmann::json read_as_json(const std::string& yaml);

}  // namespace percuss
