#include "src/deck/laws/laminates.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "kernels/shell/thickness_points.hpp"
#include "src/deck/laws/law_traits.hpp"

namespace percuss {
namespace {

/// The deck's check has let the name through.
const MaterialDeck& find_by_name(const Deck& deck, const std::string& name) {
  return *std::find_if(deck.materials.begin(), deck.materials.end(),
                       [&](const MaterialDeck& material) { return material.name == name; });
}

MaterialDeck make_laminate(const Deck& deck, const PartDeck& part) {
  MaterialDeck laminate = find_by_name(deck, part.material);
  laminate.name = fmt::format("{} (plies of {})", part.material, part.name);
  laminate.density = 0;
  for (const PlyDeck& ply : part.plies) {
    const MaterialDeck& material = find_by_name(deck, ply.material.empty() ? part.material : ply.material);
    if (material.equation_of_state) laminate.equation_of_state = material.equation_of_state;  // which shells refuse
    const double share = ply.thickness / *part.thickness;
    laminate.plies.push_back({material.name, material.law, material.density, share, ply.angle});
    laminate.density += share * material.density;
  }
  return laminate;
}

}  // namespace

void lay_up_plies(Deck& deck) {
  for (PartDeck& part : deck.parts) {
    if (part.plies.empty()) continue;
    MaterialDeck laminate = make_laminate(deck, part);
    part.material = laminate.name;
    deck.materials.push_back(std::move(laminate));
  }
}

bool is_laminate(const MaterialDeck& material) { return !material.plies.empty() || find_traits(material).has_axes; }

int count_points_of_ply(std::size_t plies, int asked, bool yields) {
  constexpr int usual = 2;  // exact for a linear law in bending
  if (asked > 0) return asked;
  if (plies == 1) return yields ? points_of_plastic_shells : points_of_elastic_shells;
  return plies * usual <= most_layers ? usual : 1;
}

std::vector<LaminatePly> list_plies(const MaterialDeck& material) {
  if (!material.plies.empty()) return material.plies;
  return {{material.name, material.law, material.density, 1, 0}};
}

}  // namespace percuss
