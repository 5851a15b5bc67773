// Keys of `materials`: `model` says which law, whose own table of keys is in kernels/material.

#include <algorithm>
#include <string_view>
#include <type_traits>

#include "kernels/material/laws/materials.hpp"
#include "kernels/material/pressure/equations_of_state.hpp"
#include "src/deck/keys/foreign_names.hpp"
#include "src/deck/keys/table_value.hpp"
#include "src/deck/laws/law_code.hpp"
#include "src/deck/laws/law_traits.hpp"
#include "src/deck/laws/make_material.hpp"
#include "src/deck/laws/material_properties.hpp"
#include "src/deck/sections/deck_keys.hpp"

namespace percuss {
namespace {

/// A curve for a rate.
struct RateCurve {
  double rate = 0;
  TableValue::Rows rows;
};

/// One curve [rate, [[x, y], ...]].
struct RateCurveValue {
  TableValue table;

  bool read(const Reader& reader, const std::string& name, const Node& node, RateCurve& out) const {
    if (node.kind != Node::Kind::list || node.items.size() != 2) {
      reader.refuse(node, name, takes());
      return false;
    }
    RateCurve curve;
    if (!NumberValue{not_negative}.read(reader, name + ".0", node.items[0], curve.rate)) return false;
    if (!table.read_rows(reader, name + ".1", node.items[1], RateCurves::most_rows, curve.rows)) return false;
    out = std::move(curve);
    return true;
  }
  std::string takes() const {
    const std::string y = table.range.text;
    return "[rate, [[x, y], ...]], rate zero or positive" + (y.empty() ? y : ", y " + y);
  }
  Form form() const { return tuple_form({number_form(not_negative), table.form()}); }
};

/// Curves for several rates, the rates ascending.
struct RateCurvesValue {
  RateCurveValue curve;

  /// Into the tables and numbers of the law (name_curve()).
  bool read(const Reader& reader, const std::string& name, const Node& node, const std::string& key,
            LawDeck& law) const {
    std::vector<RateCurve> curves;
    if (!ListValue<RateCurveValue>{curve}.read(reader, name, node, curves)) return false;
    std::size_t rows = 0;
    for (const RateCurve& one : curves) rows += one.rows.size();
    if (curves.empty() || curves.size() > RateCurves::most_rates || rows > RateCurves::most_rows) {
      reader.error(node.spot,
                   fmt::format("{} has {} rates and {} rows{} (must have 1 to {} rates, and at most {} rows "
                               "in all)",
                               name, curves.size(), rows, reader.in(), RateCurves::most_rates, RateCurves::most_rows));
      return false;
    }
    for (std::size_t i = 1; i < curves.size(); ++i) {
      if (curves[i].rate > curves[i - 1].rate) continue;
      reader.error(node.items[i].spot, fmt::format("{}.{} begins with the rate {} after {}{} (rates must ascend)", name,
                                                   i, curves[i].rate, curves[i - 1].rate, reader.in()));
      return false;
    }
    for (std::size_t k = 0; k < curves.size(); ++k) {
      const std::string own = name_curve(key, static_cast<int>(k));
      law.numbers[own] = curves[k].rate;
      law.tables[own] = std::move(curves[k].rows);
    }
    return true;
  }
  std::string takes() const { return "a list, each " + curve.takes(); }
  Form form() const { return list_form(curve.form(), 1); }
};

/// Numbers without a name each.
struct MaterialNumbersValue {
  bool read(const Reader& reader, const std::string& name, const Node& node, std::vector<double>& out) const {
    if (!ListValue<NumberValue>{{any_number}}.read(reader, name, node, out)) return false;
    if (out.size() <= MaterialNumbers::most) return true;
    reader.error(node.spot, fmt::format("{} has {} numbers{} (at most {}): leave out what the code does not read", name,
                                        out.size(), reader.in(), MaterialNumbers::most));
    return false;
  }
  std::string takes() const { return "a list of numbers"; }
  Form form() const { return list_form(number_form(any_number), 1); }
};

/// Constants of a library's law, whose names and kinds only the library knows: numbers, words, vectors and tables.
struct LibraryConstantsValue {
  bool read(const Reader& reader, const std::string& name, const Node& node, LawDeck& out) const {
    if (!reader.expect(node, Node::Kind::map, name, takes())) return false;
    bool good = true;
    for (const Entry& entry : node.entries)
      good = read_one(reader, name + "." + entry.name, entry.value, name_library_constant(entry.name), out) && good;
    return good;
  }
  std::string takes() const { return "a map of names to numbers, words, vectors and tables"; }
  Form form() const {
    Form values(Form::Kind::named_maps);
    values.inner = {any_form({number_form(any_number), {Form::Kind::text}, vector3().form(), TableValue{}.form()})};
    return values;
  }

 private:
  static bool read_one(const Reader& reader, const std::string& full, const Node& node, const std::string& name,
                       LawDeck& out) {
    const bool is_list = node.kind == Node::Kind::list && !node.items.empty();
    if (is_list && node.items[0].kind == Node::Kind::list)
      return TableValue{}.read(reader, full, node, out.tables[name]);
    if (is_list) return vector3().read(reader, full, node, out.vectors[name]);
    if (node.kind == Node::Kind::scalar && is_name(node.text))
      return TextValue{}.read(reader, full, node, out.texts[name]);
    return NumberValue{}.read(reader, full, node, out.numbers[name]);
  }
};

/// An integer from 0 to `most`.
struct CountValue {
  int most = 0;
  bool read(const Reader& reader, const std::string& name, const Node& node, double& out) const {
    int value = 0;
    if (!IntegerValue{0, most}.read(reader, name, node, value)) return false;
    out = value;
    return true;
  }
  std::string takes() const { return fmt::format("an integer from 0 to {}", most); }
  Form form() const { return IntegerValue{0, most}.form(); }
};

/// A choice of true or false.
template <class C>
Key<LawDeck> make_switch(const MaterialKey<C>& key) {
  return make_key<LawDeck>(key.name, key.required, BooleanValue{},
                           [name = std::string(key.name)](const BooleanValue& value, const Reader& reader,
                                                          const std::string& full, const Node& node, LawDeck& law) {
                             bool is_on = false;
                             if (!value.read(reader, full, node, is_on)) return false;
                             law.numbers[name] = is_on ? 1 : 0;
                             return true;
                           });
}

/// A row of the deck's table from one of a law's.
template <class C>
Key<LawDeck> make_law_key(const MaterialKey<C>& key) {
  const auto into = [name = std::string(key.name)](auto LawDeck::*map) {
    return [name, map](const auto& value, const Reader& reader, const std::string& full, const Node& node,
                       LawDeck& law) { return value.read(reader, full, node, (law.*map)[name]); };
  };
  const Range& range = find_range(key.range);
  if (key.code != nullptr) return make_key<LawDeck>(key.name, key.required, FileValue{}, into(&LawDeck::texts));
  if (key.law != nullptr) return make_key<LawDeck>(key.name, key.required, FileValue{}, into(&LawDeck::texts));
  if (key.is_of_library)
    return make_key<LawDeck>(key.name, key.required, LibraryConstantsValue{},
                             [](const LibraryConstantsValue& value, const Reader& reader, const std::string& full,
                                const Node& node, LawDeck& law) { return value.read(reader, full, node, law); });
  if (key.word != nullptr) return make_key<LawDeck>(key.name, key.required, TextValue{}, into(&LawDeck::texts));
  if (key.list != nullptr)
    return make_key<LawDeck>(key.name, key.required, MaterialNumbersValue{}, into(&LawDeck::lists));
  if (key.integer != nullptr)
    return make_key<LawDeck>(key.name, key.required, CountValue{key.most}, into(&LawDeck::numbers));
  if (key.table != nullptr) return make_key<LawDeck>(key.name, key.required, TableValue{range}, into(&LawDeck::tables));
  if (key.curves != nullptr)
    return make_key<LawDeck>(key.name, key.required, RateCurvesValue{{{range}}},
                             [name = std::string(key.name)](const RateCurvesValue& value, const Reader& reader,
                                                            const std::string& full, const Node& node, LawDeck& law) {
                               return value.read(reader, full, node, name, law);
                             });
  if (key.choice != nullptr && std::string_view(key.words[1]) == "true") return make_switch(key);
  if (key.choice != nullptr) {
    const ChoiceValue<double> words{{{key.words[0], 0}, {key.words[1], 1}}};
    return make_key<LawDeck>(key.name, key.required, words, into(&LawDeck::numbers));
  }
  if (key.vector != nullptr) return make_key<LawDeck>(key.name, key.required, vector3(range), into(&LawDeck::vectors));
  return make_key<LawDeck>(key.name, key.required, NumberValue{range}, into(&LawDeck::numbers));
}

constexpr const char* state_key = "equation_of_state";

struct Model {
  enum class State { none, may, must };
  std::string name;
  State state;  // whether it has an equation of state
  Keys<LawDeck> keys;
  std::string (*find_fault)(const LawDeck&);             // what is wrong between several constants; empty: nothing
  std::string (*find_fault_with_state)(const LawDeck&);  // likewise, only with an equation of state
};

/// The constants of a law with code of a user, which is not loaded before the command has allowed it.
template <class Law>
typename Law::Constants find_constants_without_code(const LawDeck& law) {
  typename Law::Constants constants{};
  for (auto key : Law::keys()) {
    if (key.number != nullptr && law.numbers.count(key.name) == 1) constants.*key.number = law.numbers.at(key.name);
    if (key.vector != nullptr && law.vectors.count(key.name) == 1)
      std::copy_n(law.vectors.at(key.name).begin(), 3, constants.*key.vector);
    key.code = nullptr;
    set_user_constant(law, key, constants);
  }
  return constants;
}

/// What code of a user gets by other ways than its arguments in a step.
void add_keys_of_code(Keys<LawDeck>& keys) {
  keys.push_back(
      make_key<LawDeck>("parameter_tables", false, FileValue{},
                        [](const FileValue& value, const Reader& reader, const std::string& full, const Node& node,
                           LawDeck& law) { return value.read(reader, full, node, law.texts["parameter_tables"]); }));
  keys.push_back(make_key<LawDeck>(
      "length_constants", false, MaterialNumbersValue{},
      [](const MaterialNumbersValue& value, const Reader& reader, const std::string& full, const Node& node,
         LawDeck& law) { return value.read(reader, full, node, law.lists["length_constants"]); }));
}

template <class Law>
Model make_model() {
  constexpr Model::State state = needs_equation_of_state<Law>   ? Model::State::must
                                 : takes_equation_of_state<Law> ? Model::State::may
                                                                : Model::State::none;
  Model model{Law::name, state, {}, {}, {}};
  model.find_fault = [](const LawDeck& law) {
    if constexpr (requires(const typename Law::Constants& c) { c.find_fault(); }) {
      if constexpr (has_key<Law>(&MaterialKey<typename Law::Constants>::code))
        return std::string(find_constants_without_code<Law>(law).find_fault());
      else
        return std::string(find_constants<Law>(law).find_fault());
    }
    return std::string();
  };
  model.find_fault_with_state = [](const LawDeck& law) {
    if constexpr (requires(const typename Law::Constants& c) { c.find_fault_with_state(); }) {
      return std::string(find_constants<Law>(law).find_fault_with_state());
    }
    return std::string();
  };
  for (const auto& key : Law::keys()) model.keys.push_back(make_law_key(key));
  if constexpr (std::is_same_v<Law, UserLaw>) add_keys_of_code(model.keys);
  return model;
}

template <class... Law>
std::vector<Model> make_models(TypeList<Law...>) {
  return {make_model<Law>()...};
}

const std::vector<Model>& states() {
  static const std::vector<Model> all = make_models(EquationsOfState());
  return all;
}

const std::vector<Model>& models() {
  static const std::vector<Model> all = make_models(AllLaws());
  return all;
}

ChoiceValue<const Model*> choose_model(const std::vector<Model>& models) {
  ChoiceValue<const Model*> value;
  for (const Model& model : models) value.choices.emplace_back(model.name, &model);
  return value;
}

/// Adds a key of a model; one that several have is there once, in every form that one of them takes.
void add_key(const Key<LawDeck>& key, std::vector<FormKey>& all) {
  const auto known = std::find_if(all.begin(), all.end(), [&](const FormKey& k) { return k.name == key.name; });
  if (known == all.end())
    all.push_back({key.name, key.required, key.takes, key.form(), true});
  else if (known->takes != key.takes)
    known->form = any_form({std::move(known->form), key.form()});
}

/// A map that has the keys of `common` and those of the model that its key `chooser` names.
Form form_of_models(const std::vector<Model>& models, const char* chooser, Form common) {
  const auto choices = choose_model(models);
  common.keys.insert(common.keys.begin(), {chooser, true, choices.takes(), choices.form()});
  Form all = common;
  all.chooser = chooser;
  for (const Model& model : models) {
    FormCase& its = all.cases.emplace_back(FormCase{model.name, {}, {}});
    for (const FormKey& key : common.keys) {
      const bool is_state = key.name == state_key;
      if (!is_state || model.state != Model::State::none) its.keys.push_back(key.name);
      if (is_state && model.state == Model::State::must) its.required.push_back(key.name);
    }
    for (const Key<LawDeck>& key : model.keys) {
      add_key(key, all.keys);
      its.keys.push_back(key.name);
      if (key.required) its.required.push_back(key.name);
    }
  }
  return all;
}

// " (a key of model j2_plasticity, not of elastic)" for a key that another model has.
std::string find_other_model(const std::vector<Model>& models, const char* kind, const std::string& key,
                             const Model& own) {
  for (const Model& model : models) {
    for (const Key<LawDeck>& other : model.keys) {
      if (other.name == key) return fmt::format(" (a key of {} {}, not of {})", kind, model.name, own.name);
    }
  }
  return {};
}

/// Reads which model a map chooses with the key `kind`.
const Model* read_choice(const std::vector<Model>& models, const char* kind, const Reader& reader, const Node& node,
                         LawDeck& out) {
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
  const Model* model = nullptr;
  if (!choices.read(reader, reader.name_of(kind), *choice, model)) return nullptr;
  out.model = model->name;
  out.place = choice->spot.place;
  return model;
}

bool check_faults(const Model& model, const Reader& reader, const Node& node, const LawDeck& law) {
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
    const Model* model = read_choice(states(), "kind", inner, node, out);
    if (model == nullptr) return false;
    const OtherKeys others{{"kind"},
                           [model](const std::string& key) { return find_other_model(states(), "kind", key, *model); }};
    return read_keys(inner, node, model->keys, out, others) && check_faults(*model, inner, node, out);
  }
  std::string takes() const { return "a map"; }
  Form form() const { return form_of_models(states(), "kind", map_form({})); }
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

bool check_state(const Model& model, const Reader& reader, const Node& node) {
  const Node* const state = node.find(state_key);
  if (model.state == Model::State::must && state == nullptr) {
    refuse_missing(reader, node, state_key, "a map");
    return false;
  }
  if (model.state != Model::State::none || state == nullptr) return true;
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
  const Model* model = read_choice(models(), "model", reader, node, out.law);
  if (model == nullptr) return false;
  // One pass over the map finds unknown keys, in the order of the deck.
  Keys<MaterialDeck> keys = common_keys();
  for (const Key<LawDeck>& key : model->keys) keys.push_back(lift_key(key, &MaterialDeck::law));
  const OtherKeys others{{"model"},
                         [model](const std::string& key) { return find_other_model(models(), "model", key, *model); }};
  const bool is_read = read_keys(reader, node, keys, out, others);
  if (!find_code_file(out.law).empty()) out.law.numbers["density"] = out.density;  // which the code gets
  const bool good = is_read && check_rate(reader, node, out.law) && check_constants_in_vain(reader, node, out.law) &&
                    check_deletion(reader, node, out);
  return check_state(*model, reader, node) && good && check_faults(*model, reader, node, out.law);
}

Form MaterialValue::form() const { return form_of_models(models(), "model", form_of(common_keys())); }

}  // namespace percuss
