#include <algorithm>
#include <string_view>
#include <type_traits>

#include "kernels/material/laws/materials.hpp"
#include "kernels/material/pressure/equations_of_state.hpp"
#include "src/deck/keys/file_value.hpp"
#include "src/deck/keys/table_value.hpp"
#include "src/deck/laws/law_code.hpp"
#include "src/deck/laws/make_material.hpp"
#include "src/deck/laws/material_properties.hpp"
#include "src/deck/materials/law_models.hpp"

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

  /// Reads a curve into the tables and numbers of the law (name_curve()).
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

/// Constants of any law: a member of each kind that a key may name.
struct AnyConstants {
  double number;
  MaterialTable table;
  double vector[3];
  RateCurves curves;
  bool choice;
  int integer;
  MaterialNumbers list;
  MaterialText word;
  UserCode code;
  MadeLaw law;
};
using AnyLawKey = MaterialKey<AnyConstants>;

/// A key without the law that it belongs to, so that the rows of all laws are made by the same functions.
template <class C>
AnyLawKey forget_law(const MaterialKey<C>& key) {
  AnyLawKey any = name_key<AnyConstants>(key.name, key.required, key.meaning);
  any.range = key.range;
  std::copy_n(key.words, 2, any.words);
  any.most = key.most;
  any.is_of_library = key.is_of_library;
  if (key.number != nullptr) any.number = &AnyConstants::number;
  if (key.table != nullptr) any.table = &AnyConstants::table;
  if (key.vector != nullptr) any.vector = &AnyConstants::vector;
  if (key.curves != nullptr) any.curves = &AnyConstants::curves;
  if (key.choice != nullptr) any.choice = &AnyConstants::choice;
  if (key.integer != nullptr) any.integer = &AnyConstants::integer;
  if (key.list != nullptr) any.list = &AnyConstants::list;
  if (key.word != nullptr) any.word = &AnyConstants::word;
  if (key.code != nullptr) any.code = &AnyConstants::code;
  if (key.law != nullptr) any.law = &AnyConstants::law;
  return any;
}

/// A choice of true or false.
Key<LawDeck> make_switch(const AnyLawKey& key) {
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
Key<LawDeck> make_law_key(const AnyLawKey& key) {
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

/// Numbers that code of a user gets by other ways than its arguments in a step.
Key<LawDeck> make_list_key(const char* name) {
  return make_key<LawDeck>(
      name, false, MaterialNumbersValue{},
      [name](const MaterialNumbersValue& value, const Reader& reader, const std::string& full, const Node& node,
             LawDeck& law) { return value.read(reader, full, node, law.lists[name]); });
}

/// Adds further keys of the code of a VUMAT.
void add_keys_of_code(Keys<LawDeck>& keys) {
  keys.push_back(
      make_key<LawDeck>("parameter_tables", false, FileValue{},
                        [](const FileValue& value, const Reader& reader, const std::string& full, const Node& node,
                           LawDeck& law) { return value.read(reader, full, node, law.texts["parameter_tables"]); }));
  keys.push_back(make_list_key("length_constants"));
}

template <class Law>
LawModel make_model() {
  constexpr LawModel::State state = needs_equation_of_state<Law>   ? LawModel::State::must
                                    : takes_equation_of_state<Law> ? LawModel::State::may
                                                                   : LawModel::State::none;
  LawModel model{Law::name, state, {}, {}, {}};
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
  for (const auto& key : Law::keys()) model.keys.push_back(make_law_key(forget_law(key)));
  if constexpr (std::is_base_of_v<UserFields, Law>) model.keys.push_back(make_list_key("step_starts"));
  if constexpr (std::is_same_v<Law, UserLaw>) add_keys_of_code(model.keys);
  return model;
}

template <class... Law>
std::vector<LawModel> make_models(TypeList<Law...>) {
  return {make_model<Law>()...};
}

}  // namespace

const std::vector<LawModel>& state_models() {
  static const std::vector<LawModel> all = make_models(EquationsOfState());
  return all;
}

const std::vector<LawModel>& law_models() {
  static const std::vector<LawModel> all = make_models(AllLaws());
  return all;
}

}  // namespace percuss
