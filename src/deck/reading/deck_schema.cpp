#include "src/deck/reading/deck_schema.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "src/deck/keys/key_documentation.hpp"
#include "src/deck/laws/law_traits.hpp"
#include "src/deck/reading/deck_keys.hpp"

namespace percuss {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* text_types[] = {"string", "number", "boolean"};  // `title: 42` is a text to the reader

/// "A number, positive [time]; default: 0.9. What it means."
std::string describe_key(const std::string& path, const std::string& takes) {
  static const auto rows = read_key_documentation(deck_page);
  std::string text = takes;
  const auto row = rows.find(path);
  if (row != rows.end()) {
    const KeyDocumentation& key = row->second;
    if (key.unit != "-") text += " [" + key.unit + "]";
    if (key.otherwise != "-") text += key.otherwise == "required" ? "; required" : "; default: " + key.otherwise;
    if (!key.meaning.empty()) text += ". " + key.meaning;
  }
  return text;
}

Json write_form(const Form& form, const std::string& path);

Json write_bound(double bound) {
  if (bound == std::floor(bound) && std::abs(bound) < 1e15) return static_cast<long long>(bound);
  return bound;
}

Json write_number(const Form& form) {
  const Range& range = form.range;
  Json json{{"type", form.kind == Form::Kind::integer ? "integer" : "number"}};
  if (std::isfinite(range.low)) json[range.low_open ? "exclusiveMinimum" : "minimum"] = write_bound(range.low);
  if (std::isfinite(range.high)) json[range.high_open ? "exclusiveMaximum" : "maximum"] = write_bound(range.high);
  return json;
}

Json write_list(const Form& form, const std::string& path) {
  Json json{{"type", "array"}, {"items", write_form(form.inner.front(), path + ".N")}};
  if (form.least > 0) json["minItems"] = form.least;
  return json;
}

Json write_tuple(const Form& form, const std::string& path) {
  Json items = Json::array();
  for (const Form& item : form.inner) items.push_back(write_form(item, path));
  const bool are_alike = std::all_of(items.begin(), items.end(), [&](const Json& item) { return item == items[0]; });
  Json json{{"type", "array"}};
  if (are_alike)
    json["items"] = items[0];
  else
    json["prefixItems"] = items;
  json["minItems"] = json["maxItems"] = form.inner.size();
  return json;
}

/// Further rules of a map whose chooser has the word of this case.
Json write_case(const std::string& chooser, const FormCase& one) {
  Json then;
  then["propertyNames"] = {{"enum", one.keys}};
  if (!one.required.empty()) then["required"] = one.required;
  return {{"if", {{"properties", {{chooser, {{"const", one.word}}}}}, {"required", Json::array({chooser})}}},
          {"then", then}};
}

Json write_map(const Form& form, const std::string& above) {
  const std::string path = form.listed_as.value_or(above);
  Json properties = Json::object(), required = Json::array();
  for (const FormKey& key : form.keys) {
    const std::string full = path.empty() ? key.name : path + "." + key.name;
    Json value{{"description", describe_key(full, key.takes)}};
    value.update(write_form(key.form, full));
    properties[key.name] = std::move(value);
    if (key.required && !key.by_case) required.push_back(key.name);
  }
  Json json{{"type", "object"}, {"properties", std::move(properties)}};
  if (!required.empty()) json["required"] = std::move(required);
  if (form.least > 0) json["minProperties"] = form.least;
  json["additionalProperties"] = false;
  for (const std::string& key : form.exactly_one) json["oneOf"].push_back(Json{{"required", Json::array({key})}});
  for (const FormCase& one : form.cases) json["allOf"].push_back(write_case(form.chooser, one));
  return json;
}

Json write_named_maps(const Form& form, const std::string& path) {
  return {{"type", "object"},
          {"patternProperties", {{"^[A-Za-z_][A-Za-z0-9_-]*$", write_form(form.inner.front(), path + ".NAME")}}},
          {"minProperties", 1},
          {"additionalProperties", false}};
}

Json write_choices(const Form& form, const std::string& path) {
  Json json;
  for (const Form& choice : form.inner) json["anyOf"].push_back(write_form(choice, path));
  return json;
}

Json write_form(const Form& form, const std::string& path) {
  switch (form.kind) {
    case Form::Kind::text:
      return {{"type", text_types}};
    case Form::Kind::boolean:
      return {{"type", "boolean"}};
    case Form::Kind::word:
      return {{"enum", form.words}};
    case Form::Kind::number:
    case Form::Kind::integer:
      return write_number(form);
    case Form::Kind::list:
      return write_list(form, path);
    case Form::Kind::tuple:
      return write_tuple(form, path);
    case Form::Kind::map:
      return write_map(form, path);
    case Form::Kind::named_maps:
      return write_named_maps(form, path);
    case Form::Kind::any_of:
      break;
  }
  return write_choices(form, path);
}

/// Not of JSON Schema: what each law can do, for tools that write decks.
Json write_laws() {
  Json json = Json::object();
  for (const LawTraits& law : list_law_traits()) {
    json[law.name] = {{"takes_equation_of_state", law.takes_equation_of_state},
                      {"needs_equation_of_state", law.needs_equation_of_state},
                      {"grows_in_increments", law.grows_in_increments},
                      {"is_of_shells", law.is_of_shells},
                      {"is_of_membranes_alone", law.is_of_membranes_alone},
                      {"is_skin", law.is_skin},
                      {"is_of_beams", law.is_of_beams},
                      {"has_plastic_strain", law.has_plastic_strain},
                      {"has_temperature", law.has_temperature},
                      {"has_void_fraction", law.has_void_fraction},
                      {"has_axes", law.has_axes}};
  }
  return json;
}

}  // namespace

std::string write_deck_schema() {
  Json json{{"$schema", "https://json-schema.org/draft/2020-12/schema"}, {"title", "A deck of percuss"}};
  json.update(write_form(form_of(deck_keys()), ""));
  json["x-laws"] = write_laws();
  return json.dump(1) + "\n";
}

}  // namespace percuss
