// Keys of `materials`. A new model is a struct in deck.hpp, a table and a row in models() here.

#include "src/deck/deck_keys.hpp"

namespace percuss {
namespace {

// Outside this range the bulk or shear modulus is not positive.
const Range poissons_ratio_range{"between -1 and 0.5, both excluded", -1, 0.5, true, true};

/// The keys that every elastic-based model has.
template <class M>
Keys<M> elastic_constants() {
  return {
      need("density", &M::density, NumberValue{positive}),
      need("youngs_modulus", &M::youngs_modulus, NumberValue{positive}),
      need("poissons_ratio", &M::poissons_ratio, NumberValue{poissons_ratio_range}),
  };
}

const Keys<ElasticDeck>& elastic_keys() {
  static const Keys<ElasticDeck> keys = elastic_constants<ElasticDeck>();
  return keys;
}

const Keys<J2PlasticityDeck>& j2_plasticity_keys() {
  static const Keys<J2PlasticityDeck> keys = [] {
    auto all = elastic_constants<J2PlasticityDeck>();
    all.push_back(need("yield_stress", &J2PlasticityDeck::yield_stress, NumberValue{positive}));
    all.push_back(may("hardening_modulus", &J2PlasticityDeck::hardening_modulus, NumberValue{not_negative}));
    return all;
  }();
  return keys;
}

struct Model {
  std::string name;
  std::vector<DeckKey> keys;
  std::function<bool(const Reader&, const Node&, const OtherKeys&, MaterialDeck&)> read;
};

template <class M>
Model make_model(std::string name, const Keys<M>& keys) {
  Model model{std::move(name), {}, {}};
  list_keys(keys, "", model.keys);
  model.read = [&keys](const Reader& reader, const Node& node, const OtherKeys& others, MaterialDeck& out) {
    M constants{};
    const bool good = read_keys(reader, node, keys, constants, others);
    out.model = constants;
    return good;
  };
  return model;
}

const std::vector<Model>& models() {
  static const std::vector<Model> all = {
      make_model("elastic", elastic_keys()),
      make_model("j2_plasticity", j2_plasticity_keys()),
  };
  return all;
}

ChoiceValue<const Model*> model_value() {
  ChoiceValue<const Model*> value;
  for (const Model& model : models()) value.choices.emplace_back(model.name, &model);
  return value;
}

// " (a key of model j2_plasticity, not of elastic)" for a key that another model has.
std::string find_other_model(const std::string& key, const Model& own) {
  for (const Model& model : models()) {
    for (const DeckKey& other : model.keys) {
      if (other.path == key) return fmt::format(" (a key of model {}, not of {})", model.name, own.name);
    }
  }
  return {};
}

}  // namespace

bool MaterialValue::read_inside(const Reader& reader, const Node& node, MaterialDeck& out) const {
  const Node* choice = node.find("model");
  if (choice == nullptr) {
    refuse_missing(reader, node, "model", model_value().takes());
    return false;
  }
  const Model* model = nullptr;
  if (!model_value().read(reader, reader.name_of("model"), *choice, model)) return false;
  const OtherKeys others{{"model"}, [model](const std::string& key) { return find_other_model(key, *model); }};
  return model->read(reader, node, others, out);
}

void MaterialValue::list(const std::string& path, std::vector<DeckKey>& out) const {
  out.push_back({path + ".model", model_value().takes(), true});
  for (const Model& model : models()) {
    for (DeckKey key : model.keys) {
      key.path = path + "." + key.path;
      const bool listed =
          std::any_of(out.begin(), out.end(), [&](const DeckKey& known) { return known.path == key.path; });
      if (!listed) out.push_back(std::move(key));
    }
  }
}

}  // namespace percuss
