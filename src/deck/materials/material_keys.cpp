#include "src/deck/materials/material_keys.hpp"

#include <algorithm>
#include <string_view>

#include "src/deck/keys/foreign_names.hpp"
#include "src/deck/laws/law_traits.hpp"
#include "src/deck/laws/material_properties.hpp"
#include "src/deck/materials/failure_keys.hpp"
#include "src/deck/materials/law_models.hpp"

namespace percuss {
namespace {

constexpr const char* state_key = "equation_of_state";

ChoiceValue<const LawModel*> choose_model(const std::vector<LawModel>& models) {
  ChoiceValue<const LawModel*> value;
  for (const LawModel& model : models) value.choices.emplace_back(model.name, &model);
  return value;
}

/// Adds a key of a model; one that several have is there once, in every form that one of them takes.
void add_key(const AnyKey& key, std::vector<FormKey>& all) {
  const auto known = std::find_if(all.begin(), all.end(), [&](const FormKey& k) { return k.name == key.name; });
  if (known == all.end())
    all.push_back({key.name, key.required, key.takes, key.value->form(), true});
  else if (known->takes != key.takes)
    known->form = any_form({std::move(known->form), key.value->form()});
}

/// A map that has the keys of `common` and those of the model that its key `chooser` names.
Form form_of_models(const std::vector<LawModel>& models, const char* chooser, Form common) {
  const auto choices = choose_model(models);
  common.keys.insert(common.keys.begin(), {chooser, true, choices.takes(), choices.form()});
  Form all = common;
  all.chooser = chooser;
  for (const LawModel& model : models) {
    FormCase& its = all.cases.emplace_back(FormCase{model.name, {}, {}});
    for (const FormKey& key : common.keys) {
      const bool is_state = key.name == state_key;
      if (!is_state || model.state != LawModel::State::none) its.keys.push_back(key.name);
      if (is_state && model.state == LawModel::State::must) its.required.push_back(key.name);
    }
    for (const AnyKey& key : model.keys) {
      add_key(key, all.keys);
      its.keys.push_back(key.name);
      if (key.required) its.required.push_back(key.name);
    }
  }
  return all;
}

// " (a key of model j2_plasticity, not of elastic)" for a key that another model has.
std::string find_other_model(const std::vector<LawModel>& models, const char* kind, const std::string& key,
                             const LawModel& own) {
  for (const LawModel& model : models) {
    for (const AnyKey& other : model.keys) {
      if (other.name == key) return fmt::format(" (a key of {} {}, not of {})", kind, model.name, own.name);
    }
  }
  return {};
}

/// Reads which model a map chooses with the key `kind`.
const LawModel* read_choice(const std::vector<LawModel>& models, const char* kind, const Reader& reader,
                            const Node& node, LawDeck& out) {
  const auto choices = choose_model(models);
  const Node* choice = node.find(kind);
  if (choice == nullptr) {
    refuse_missing(reader, node, kind, choices.takes());
    return nullptr;
  }
  if (const std::string instead = find_foreign_model(choice->text); !instead.empty()) {
    reader.error(choice->spot,
                 fmt::format("{} is {}{} ({})", reader.name_of(kind), describe(*choice), reader.in(), instead));
    return nullptr;
  }
  const LawModel* model = nullptr;
  if (!choices.read(reader, reader.name_of(kind), *choice, model)) return nullptr;
  out.model = model->name;
  out.place = choice->spot.place;
  return model;
}

bool check_faults(const LawModel& model, const Reader& reader, const Node& node, const LawDeck& law) {
  std::string fault = model.find_fault(law);
  if (fault.empty() && node.find(state_key) != nullptr) fault = model.find_fault_with_state(law);
  if (!fault.empty()) reader.error(node.key, reader.self() + " has " + fault);
  return fault.empty();
}

/// equation_of_state: `kind` says which.
struct StateValue {
  bool read(const Reader& reader, const std::string& name, const Node& node, LawDeck& out) const {
    if (!reader.expect(node, Node::Kind::map, name, takes())) return false;
    const Reader inner = reader.inside(name);
    const LawModel* model = read_choice(state_models(), "kind", inner, node, out);
    if (model == nullptr) return false;
    const OtherKeys others{
        {"kind"}, [model](const std::string& key) { return find_other_model(state_models(), "kind", key, *model); }};
    return read_keys(inner, node, model->keys, out, others) && check_faults(*model, inner, node, out);
  }
  std::string takes() const { return "a map"; }
  Form form() const { return form_of_models(state_models(), "kind", map_form({})); }
};

/// The keys that materials have whatever their law.
const Keys<MaterialDeck>& common_keys() {
  static const Keys<MaterialDeck> keys = {
      need("density", &MaterialDeck::density, NumberValue{positive}),
      may(state_key, &MaterialDeck::equation_of_state, StateValue{}),
      may("failure", &MaterialDeck::failure, failure_value()),
  };
  return keys;
}

bool check_state(const LawModel& model, const Reader& reader, const Node& node) {
  const Node* const state = node.find(state_key);
  if (model.state == LawModel::State::must && state == nullptr) {
    refuse_missing(reader, node, state_key, "a map");
    return false;
  }
  if (model.state != LawModel::State::none || state == nullptr) return true;
  reader.error(state->key,
               fmt::format("{} has an equation_of_state, which model {} does not take", reader.self(), model.name));
  return false;
}

/// A rate alone would count with the default exponent 1, which no material has.
bool check_rate(const Reader& reader, const Node& node, const LawDeck& law) {
  const auto rate = law.numbers.find("cowper_symonds_rate");
  if (rate == law.numbers.end() || rate->second == 0 || law.numbers.contains("cowper_symonds_exponent")) return true;
  reader.error(
      node.find(rate->first)->key,
      fmt::format("cowper_symonds_rate has no cowper_symonds_exponent{} (1 + (rate / {:g})^(1/q) needs q: steel "
                  "has 40.4 / s and 5): give both",
                  reader.in(), rate->second));
  return false;
}

/// Whether the deck gives a constant, other than the number 0.
bool is_given(const Node& node, const LawDeck& law, const char* name) {
  const auto number = law.numbers.find(name);
  return node.find(name) != nullptr && (number == law.numbers.end() || number->second != 0);
}

/// Constants that would be passed over: those of which another one says the same, and those of what has no strength.
bool check_constants_in_vain(const Reader& reader, const Node& node, const LawDeck& law) {
  struct Pair {
    const char *key, *other;
  };
  constexpr Pair same[] = {{"r_values", "yield_ratios"}, {"r_values", "barlat"}};
  constexpr Pair needing[] = {
      {"shear_yield_ratios", "yield_ratios"},      {"transverse_shear", "matrix_compression"},
      {"fibre_tension_energy", "fibre_tension"},   {"fibre_compression_energy", "fibre_compression"},
      {"matrix_tension_energy", "matrix_tension"}, {"matrix_compression_energy", "matrix_compression"}};
  for (const auto& [key, other] : same) {
    if (!is_given(node, law, key) || !is_given(node, law, other)) continue;
    reader.error(node.find(key)->key, fmt::format("{} is given beside {}{} (which says how the material yields): "
                                                  "leave one of them out",
                                                  key, other, reader.in()));
    return false;
  }
  for (const auto& [key, other] : needing) {
    if (!is_given(node, law, key) || is_given(node, law, other)) continue;
    reader.error(node.find(key)->key, fmt::format("{} has no effect without {}{}: give both", key, other, reader.in()));
    return false;
  }
  return true;
}

/// A law that deletes points erodes their elements, with the defaults of `failure` if the deck has none.
bool check_deletion(const Reader& reader, const Node& node, MaterialDeck& out) {
  if (find_traits(out).deletes_points && !out.failure) out.failure.emplace();
  const auto deletes = out.law.numbers.find("delete_variable");
  if (deletes == out.law.numbers.end() || deletes->second == 0) return true;
  const auto states = out.law.numbers.find("state_variables");
  const double count = states == out.law.numbers.end() ? 0 : states->second;
  if (deletes->second > count) {
    reader.error(node.find(deletes->first)->key,
                 fmt::format("delete_variable is {:g}{} (there are {:g} state_variables): raise state_variables",
                             deletes->second, reader.in(), count));
    return false;
  }
  if (!out.failure) out.failure.emplace();
  return true;
}

}  // namespace

bool MaterialValue::read_inside(const Reader& reader, const Node& node, MaterialDeck& out) const {
  const LawModel* model = read_choice(law_models(), "model", reader, node, out.law);
  if (model == nullptr) return false;
  // One pass over the map finds unknown keys, in the order of the deck.
  Keys<MaterialDeck> keys = common_keys();
  for (const AnyKey& key : model->keys) keys.push_back(lift_key(key, &MaterialDeck::law));
  const OtherKeys others{
      {"model"}, [model](const std::string& key) { return find_other_model(law_models(), "model", key, *model); }};
  const bool is_read = read_keys(reader, node, keys, out, others);
  if (!find_code_file(out.law).empty()) out.law.numbers["density"] = out.density;  // which the code gets
  const bool good = is_read && check_rate(reader, node, out.law) && check_constants_in_vain(reader, node, out.law) &&
                    check_deletion(reader, node, out);
  return check_state(*model, reader, node) && good && check_faults(*model, reader, node, out.law);
}

Form MaterialValue::form() const { return form_of_models(law_models(), "model", form_of(common_keys())); }

}  // namespace percuss
