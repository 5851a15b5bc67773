#include "src/step/elements/block_builder.hpp"

#include <algorithm>
#include <cmath>

#include "src/deck/laws/make_material.hpp"
#include "src/deck/laws/user_lengths.hpp"

namespace percuss {
namespace {

template <class Law, class Material>
std::array<int, history_scalars> find_named_history(const Law& law, const Material& material) {
  std::array<int, history_scalars> places;
  places.fill(-1);
  int place = 0;
  if constexpr (is_called<Material>) {
    place = CalledMaterial::law_place;
    places[static_cast<std::size_t>(HistoryScalar::internal_energy)] = material.find_state_place();
  }
  if constexpr (requires { Law::history_names; }) {
    for (const HistoryScalar name : Law::history_names) places[static_cast<std::size_t>(name)] = place++;
  }
  if constexpr (requires { law.find_scalar(HistoryScalar::none); }) {
    for (int i = 0; i < history_scalars; ++i) {
      const int found = law.find_scalar(static_cast<HistoryScalar>(i));
      if (found >= 0) places[static_cast<std::size_t>(i)] = CalledMaterial::law_place + found;
    }
  }
  if constexpr (requires { law.count_states(); }) {
    const int first = CalledMaterial::law_place + law.first_state();
    if (law.count_states() > 0) {
      places[static_cast<std::size_t>(HistoryScalar::first_state)] = first;
      places[static_cast<std::size_t>(HistoryScalar::after_states)] = first + law.count_states();
    }
  }
  if constexpr (requires { law.find_deletion(); }) {
    const int deletion = law.find_deletion();
    if (deletion >= 0) places[static_cast<std::size_t>(HistoryScalar::remains)] = CalledMaterial::law_place + deletion;
  }
  return places;
}

template <class Law, class Material>
KernelMaterial name_history(const Law& law, const Material& material) {
  return {material, find_named_history(law, material)};
}

/// The number of Abaqus for a shape.
int find_shape_kind(const Topology& topology) {
  switch (topology.family) {
    case ElementFamily::tetrahedra:
      return 4;
    case ElementFamily::wedges:
      return 5;
    case ElementFamily::pyramids:
      return 7;
    default:
      return 6;
  }
}

}  // namespace

UserElement describe_to_user(const Deck& deck, const Mesh& mesh, std::size_t element) {
  const LawDeck& law = deck.materials[static_cast<std::size_t>(mesh.block_of(element).material)].law;
  const Topology& topology = mesh.topology_of(element);
  const double length = std::cbrt(find_solid_volume(topology, gather_corners(mesh.elements, element, mesh.nodes)));
  UserShape shape{mesh.element_ids[element], find_shape_kind(topology), {}, length};
  for (const int node : mesh.elements.corners(element))
    shape.corners.push_back(mesh.nodes[static_cast<std::size_t>(node)]);
  UserElement user{static_cast<double>(mesh.element_ids[element]), length, {}, {}};
  for (const Vec3& x : shape.corners)
    for (std::size_t k = 0; k < 3; ++k) user.place[k] += x[k] / static_cast<double>(shape.corners.size());
  if (count_user_lengths(law) == 0) return user;
  const std::vector<double> lengths = find_user_lengths(law, shape);
  std::copy(lengths.begin(), lengths.end(), user.lengths);
  return user;
}

KernelMaterial make_kernel_material(const MaterialDeck& material) {
  KernelMaterial made;
  visit_law(material, [&]<class Law>(const Law& law) {
    if constexpr (takes_equation_of_state<Law>) {
      if (material.equation_of_state) {
        visit_state(*material.equation_of_state, [&](const auto& state) {
          made = name_history(law, make_called_material(law, material.density, state));
        });
        return;
      }
    }
    if constexpr (is_compiled_in<Law>) {
      made = name_history(law, law);
    } else if constexpr (is_of_solids<Law>) {
      made = name_history(law, make_called_material(law, material.density));
    }
  });
  return made;
}

}  // namespace percuss
