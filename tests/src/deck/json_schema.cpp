#include "tests/src/deck/json_schema.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <regex>
#include <stdexcept>
#include <variant>

#include "src/deck/text/number_text.hpp"
#include "src/deck/yaml/yaml_tree.hpp"

namespace percuss {
namespace {

using Json = nlohmann::json;

class Validator {
 public:
  std::vector<std::string> faults;

  void check(const Json& schema, const Json& value, const std::string& place) {
    if (schema.is_boolean()) {
      if (!schema.get<bool>()) add(place, "there must be nothing");
      return;
    }
    for (const auto& [keyword, rule] : schema.items()) check_keyword(schema, keyword, rule, value, place);
  }

 private:
  void add(const std::string& place, const std::string& what) { faults.push_back(place + ": " + what); }
  void expect(bool good, const std::string& place, const std::string& what) {
    if (!good) add(place, what);
  }

  void check_keyword(const Json& schema, const std::string& keyword, const Json& rule, const Json& value,
                     const std::string& place) {
    static const std::vector<std::string> notes = {"$schema", "title", "description", "then"};
    if (keyword.starts_with("x-") || std::find(notes.begin(), notes.end(), keyword) != notes.end()) return;
    const bool known = check_any(schema, keyword, rule, value, place) || check_number(keyword, rule, value, place) ||
                       check_array(keyword, rule, value, place) || check_object(schema, keyword, rule, value, place);
    if (!known) throw std::invalid_argument("unknown keyword " + keyword);
  }

  static bool is_type(const Json& value, const std::string& type) {
    if (type == "string") return value.is_string();
    if (type == "boolean") return value.is_boolean();
    if (type == "number") return value.is_number();
    if (type == "integer") return value.is_number_integer() || (value.is_number() && is_whole(value.get<double>()));
    if (type == "array") return value.is_array();
    if (type == "object") return value.is_object();
    throw std::invalid_argument("unknown type " + type);
  }
  static bool is_whole(double x) { return x == std::floor(x); }

  static bool takes(const Json& schema, const Json& value) { return find_faults(schema, value).empty(); }

  bool check_any(const Json& schema, const std::string& keyword, const Json& rule, const Json& value,
                 const std::string& place) {
    if (keyword == "type") {
      const Json types = rule.is_array() ? rule : Json::array({rule});
      expect(std::any_of(types.begin(), types.end(), [&](const Json& type) { return is_type(value, type); }), place,
             "must be of type " + rule.dump());
    } else if (keyword == "enum") {
      expect(std::find(rule.begin(), rule.end(), value) != rule.end(), place, "must be one of " + rule.dump());
    } else if (keyword == "const") {
      expect(value == rule, place, "must be " + rule.dump());
    } else if (keyword == "anyOf" || keyword == "oneOf") {
      const auto n = std::count_if(rule.begin(), rule.end(), [&](const Json& one) { return takes(one, value); });
      expect(keyword == "anyOf" ? n > 0 : n == 1, place, std::to_string(n) + " of " + keyword + " hold");
    } else if (keyword == "allOf") {
      for (const Json& one : rule) check(one, value, place);
    } else if (keyword == "if") {
      if (takes(rule, value)) check(schema.at("then"), value, place);
    } else {
      return false;
    }
    return true;
  }

  bool check_number(const std::string& keyword, const Json& rule, const Json& value, const std::string& place) {
    using Holds = bool (*)(double, double);
    static const std::map<std::string, Holds> bounds = {
        {"minimum", [](double x, double bound) { return x >= bound; }},
        {"maximum", [](double x, double bound) { return x <= bound; }},
        {"exclusiveMinimum", [](double x, double bound) { return x > bound; }},
        {"exclusiveMaximum", [](double x, double bound) { return x < bound; }}};
    const auto found = bounds.find(keyword);
    if (found == bounds.end()) return false;
    if (value.is_number()) expect(found->second(value, rule), place, "breaks " + keyword + " " + rule.dump());
    return true;
  }

  bool check_array(const std::string& keyword, const Json& rule, const Json& value, const std::string& place) {
    if (keyword == "items" || keyword == "prefixItems") {
      for (std::size_t i = 0; value.is_array() && i < value.size(); ++i) {
        if (keyword == "items") check(rule, value[i], place + "/" + std::to_string(i));
        if (keyword == "prefixItems" && i < rule.size()) check(rule[i], value[i], place + "/" + std::to_string(i));
      }
    } else if (keyword == "minItems" || keyword == "maxItems") {
      const bool good = !value.is_array() || (keyword == "minItems" ? value.size() >= rule.get<std::size_t>()
                                                                    : value.size() <= rule.get<std::size_t>());
      expect(good, place, "breaks " + keyword + " " + rule.dump());
    } else {
      return false;
    }
    return true;
  }

  bool check_object(const Json& schema, const std::string& keyword, const Json& rule, const Json& value,
                    const std::string& place) {
    if (keyword == "properties" || keyword == "patternProperties" || keyword == "propertyNames" ||
        keyword == "additionalProperties") {
      if (!value.is_object()) return true;
      for (const auto& [key, inner] : value.items()) check_entry(schema, keyword, rule, key, inner, place + "/" + key);
    } else if (keyword == "required") {
      for (const std::string& key : rule.get<std::vector<std::string>>())
        expect(!value.is_object() || value.contains(key), place, "must have the key " + key);
    } else if (keyword == "minProperties") {
      expect(!value.is_object() || value.size() >= rule.get<std::size_t>(), place, "has too few keys");
    } else {
      return false;
    }
    return true;
  }

  void check_entry(const Json& schema, const std::string& keyword, const Json& rule, const std::string& key,
                   const Json& value, const std::string& place) {
    if (keyword == "propertyNames") return check(rule, key, place);
    if (keyword == "properties" && rule.contains(key)) return check(rule.at(key), value, place);
    const auto matches = [&](const Json& patterns) {
      for (const auto& [pattern, inner] : patterns.items())
        if (std::regex_search(key, std::regex(pattern))) return true;
      return false;
    };
    if (keyword == "patternProperties") {
      for (const auto& [pattern, inner] : rule.items())
        if (std::regex_search(key, std::regex(pattern))) check(inner, value, place);
    }
    if (keyword != "additionalProperties") return;
    const bool is_named = schema.contains("properties") && schema.at("properties").contains(key);
    const bool is_matched = schema.contains("patternProperties") && matches(schema.at("patternProperties"));
    if (!is_named && !is_matched) check(rule, value, place);
  }
};

Json as_json(const Node& node) {
  Json json;
  switch (node.kind) {
    case Node::Kind::null:
      break;
    case Node::Kind::list:
      json = Json::array();
      for (const Node& item : node.items) json.push_back(as_json(item));
      break;
    case Node::Kind::map:
      json = Json::object();
      for (const Entry& entry : node.entries) json[entry.name] = as_json(entry.value);
      break;
    case Node::Kind::scalar:
      const auto integer = read_integer(node.text);
      const auto number = read_number(node.text);
      if (node.quoted)
        json = node.text;
      else if (is_boolean(node.text))
        json = node.text[0] == 't' || node.text[0] == 'T';
      else if (const auto* whole = std::get_if<long long>(&integer))
        json = *whole;
      else if (const auto* real = std::get_if<double>(&number))
        json = *real;
      else
        json = node.text;
  }
  return json;
}

}  // namespace

std::vector<std::string> find_faults(const Json& schema, const Json& value) {
  Validator validator;
  validator.check(schema, value, "");
  return validator.faults;
}

Json read_as_json(const std::string& yaml) {
  DeckErrors errors("deck.yaml", {});
  const std::optional<Node> root = parse_yaml(yaml, errors);
  if (!root) throw std::invalid_argument("not YAML");
  return as_json(*root);
}

}  // namespace percuss
