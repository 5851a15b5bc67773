#include "src/deck/reading/read_deck.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <utility>

#include "src/deck/laws/laminates.hpp"
#include "src/deck/laws/law_traits.hpp"
#include "src/deck/parts/part_image_keys.hpp"
#include "src/deck/reading/check_deck.hpp"
#include "src/deck/reading/deck_keys.hpp"
#include "src/deck/text/deck_text.hpp"
#include "src/deck/yaml/deck_json.hpp"
#include "src/deck/yaml/deck_values.hpp"
#include "src/deck/yaml/overrides.hpp"

namespace percuss {
namespace {

Node parse_tree(std::string text, const std::string& file, const std::vector<std::string>& overrides,
                DeckErrors& errors) {
  if (std::string other = describe_other_model(text, file); !other.empty()) {
    errors.add({}, std::move(other));
    errors.throw_if_any();
  }
  if (!check_deck_text(text, errors)) errors.throw_if_any();
  std::optional<Node> root = parse_yaml(text, errors);
  if (!root) errors.throw_if_any();
  if (root->kind == Node::Kind::null && !root->broken && overrides.empty()) {
    errors.add({{1, 1}, -1}, "the deck is empty (it needs at least time, parts and materials)");
    errors.throw_if_any();
  }
  if (root->kind == Node::Kind::null) root->kind = Node::Kind::map;
  if (root->kind != Node::Kind::map) {
    errors.add(root->spot, fmt::format("the deck is {} (must be a map of keys such as time, parts and materials)",
                                       describe(*root)));
    errors.throw_if_any();
  }
  root->spot = root->key = {{1, 1}, -1};  // where a missing section is reported
  for (std::size_t i = 0; i < overrides.size(); ++i) apply_override(overrides[i], static_cast<int>(i), *root, errors);
  return *std::move(root);
}

/// Sets the elements of fluids where the deck does not: viscous hourglass control with a coefficient of their own, for
/// any other holds them in their shape. Before check_deck(), which judges what stands beside it.
void settle_fluid_elements(const Node& root, Deck& deck) {
  // With 40 elements a wave, waves of real water lose 3 % of their height in each period with 0.05, a twentieth of that
  // with this.
  constexpr double fluid_coefficient = 0.002;
  const Node* const elements = root.find("elements");
  if (elements != nullptr && (elements->find("hourglass") != nullptr || elements->find("integration") != nullptr))
    return;
  for (PartDeck& part : deck.parts) {
    PartElementDeck& own = part.own_elements;
    if (own.hourglass || own.integration) continue;
    const auto material = std::find_if(deck.materials.begin(), deck.materials.end(),
                                       [&](const MaterialDeck& of) { return of.name == part.material; });
    if (material == deck.materials.end() || !find_traits(*material).needs_equation_of_state) continue;
    own.hourglass = ElementDeck::Hourglass::viscous;
    if (!own.hourglass_coefficient) own.hourglass_coefficient = fluid_coefficient;
  }
}

}  // namespace

Deck::Deck() = default;
Deck::Deck(const Deck&) = default;
Deck::Deck(Deck&&) noexcept = default;
Deck& Deck::operator=(const Deck&) = default;
Deck& Deck::operator=(Deck&&) noexcept = default;
Deck::~Deck() = default;

Deck parse_deck(const std::string& text, const std::string& file, const std::vector<std::string>& overrides) {
  std::vector<std::string> paths;
  paths.reserve(overrides.size());
  for (const std::string& argument : overrides) paths.push_back(override_path(argument));
  Deck deck;
  deck.file = file;
  deck.text = text;
  deck.settings = overrides;
  deck.overrides = paths;
  Reading reading{DeckErrors(file, std::move(paths)), std::filesystem::path(file).parent_path().string()};
  const Node root = parse_tree(text, file, overrides, reading.errors);
  read_keys(Reader(reading), root, deck_keys(), deck);
  add_part_images(deck, reading);
  settle_fluid_elements(root, deck);
  check_deck(deck, root, reading);
  reading.errors.throw_if_any();
  deck.motion_values = list_motion_values(root);
  for (std::string& value : list_free_values(root)) deck.motion_values.push_back(std::move(value));
  deck.resolved = write_deck_json(root);
  deck.places = KeyPlaces(root);
  deck.selectors = std::move(reading.used_selectors);
  deck.warnings = reading.errors.warnings();
  lay_up_plies(deck);
  return deck;
}

Deck read_deck(const std::string& file, const std::vector<std::string>& overrides) {
  return parse_deck(load_deck_text(file), file, overrides);
}

const MassScalingDeck* Deck::find_mass_scaling(std::size_t part) const {
  if (parts[part].rigid) return nullptr;
  const auto& own = parts[part].mass_scaling;
  if (own) return &*own;
  return time.mass_scaling ? &*time.mass_scaling : nullptr;
}

bool Deck::scales_mass_in_run() const {
  for (std::size_t p = 0; p < parts.size(); ++p) {
    const MassScalingDeck* scaling = find_mass_scaling(p);
    if (scaling != nullptr && scaling->every) return true;
  }
  return false;
}

std::string Deck::where(Place place) const {
  if (place.line < 0) return "--set " + overrides.at(static_cast<std::size_t>(-place.line - 1));
  return place.line > 0 ? fmt::format("{}:{}:{}", file, place.line, place.column) : file;
}

}  // namespace percuss
