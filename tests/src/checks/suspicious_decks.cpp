#include "tests/src/checks/suspicious_decks.hpp"

#include <stdexcept>

namespace percuss {

const std::string sound_deck =
    R"(units: m, kg, s
time: {end: 2.0e-4}
parts:
  block: {box: {size: [0.02, 0.02, 0.02], cells: [2, 2, 2]}, at: [0.04, 0.04, 0.0111], material: steel}
  plate: {box: {size: [0.1, 0.1, 0.01], cells: [6, 6, 3]}, material: aluminium}
  sheet: {shell_plate: {size: [0.1, 0.1], cells: [5, 5]}, at: [0, 0, -0.004], thickness: 0.002, material: aluminium}
materials:
  steel: {model: elastic, density: 7850, youngs_modulus: 210e9, poissons_ratio: 0.3}
  aluminium: {model: j2_plasticity, density: 2700, youngs_modulus: 70e9, poissons_ratio: 0.33, yield_stress: 120e6, hardening_modulus: 400e6}
initial: [{part: block, velocity: [0, 0, -20]}]
conditions:
  - {nodes: plate/x_min, fixed: [x, y, z]}
  - {nodes: sheet/x_min, fixed: [x, y, z, rx, ry, rz]}
loads: {gravity: [0, 0, -9.81]}
walls: [{point: [0, 0, -0.01], normal: z, friction: 0.2}]
contact: {surfaces: all, friction: 0.2}
output:
  fields: {every: 1e-5}
  history: {every: 1e-6, nodes: [{name: tip, near: [0.05, 0.05, 0.03], part: block}]}
  checkpoint: {every: 1e-4}
)";

std::string change(const Changes& changes) {
  std::string deck = sound_deck;
  for (const auto& [from, to] : changes) {
    const auto at = deck.find(from);
    if (at == std::string::npos) throw std::logic_error("the deck has no text '" + from + "'");
    deck.replace(at, from.size(), to);
  }
  return deck;
}

std::vector<SuspiciousDeck> suspicious_decks() {
  std::vector<SuspiciousDeck> all;
  for (const auto& decks :
       {suspicious_units(), suspicious_parts(), suspicious_contact(), suspicious_conditions(), suspicious_output()})
    all.insert(all.end(), decks.begin(), decks.end());
  return all;
}

}  // namespace percuss
