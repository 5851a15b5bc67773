#include "src/step/results/fields/frame_values.hpp"

#include <stdexcept>
#include <utility>

#include "kernels/core/host_copy.hpp"
#include "kernels/core/small_space.hpp"
#include "src/deck/deck.hpp"
#include "src/index.hpp"

namespace percuss {
namespace {

/// Some rows of a view, in their order; only these leave the memory that the kernels use.
std::vector<double> list_some_rows(const Rows3<double>& rows, const std::vector<int>& nodes) {
  const Array<int> list = to_view("percuss::wanted_nodes", nodes);
  const Array<double> out("percuss::node_rows", 3 * nodes.size());
  parallel_for(
      "percuss::read_some_nodes", RangeOf(ExecSpace(), 0, static_cast<int>(nodes.size())), KOKKOS_LAMBDA(const int i) {
        for (int k = 0; k < 3; ++k)
          out(3 * static_cast<std::size_t>(i) + static_cast<std::size_t>(k)) = rows(list(i), k);
      });
  const auto host = to_host(out);
  return {host.data(), host.data() + host.extent(0)};
}

std::vector<double> find_contact_forces(const FrameSource& of) {
  std::vector<double> force = list_rows(of.state.impulse, of.nodes());
  for (double& f : force) f = of.state.dt > 0 ? f / of.state.dt : 0;
  return force;
}

std::vector<double> find_masses(const FrameSource& of) {
  const auto mass = to_host(of.state.mass);
  if (of.region == nullptr) return {mass.data(), mass.data() + mass.extent(0)};
  std::vector<double> chosen;
  for (const int node : of.region->nodes) chosen.push_back(mass(at(node)));
  return chosen;
}

std::vector<double> find_fe_ranks(const FrameSource& of) {
  return std::vector<double>(of.element_count(), of.model.ranks.rank());
}

/// A field by its name, and how to find it.
struct FrameField {
  const char* name;
  FieldPlace place;
  int components;
  std::vector<double> (*find)(const FrameSource& of);
  FieldNumber number = FieldNumber::real;
};

constexpr FrameField frame_fields[] = {
    {"velocity", FieldPlace::node, 3, [](const FrameSource& of) { return list_rows(of.state.v, of.nodes()); }},
    {"contact_force", FieldPlace::node, 3, [](const FrameSource& of) { return find_contact_forces(of); }},
    {"contact_pressure", FieldPlace::node, 1,
     [](const FrameSource& of) { return of.choose_nodes(of.contact.find_pressures(of.state.x, of.state.dt)); }},
    {"mass", FieldPlace::node, 1, [](const FrameSource& of) { return find_masses(of); }},
    {"stress", FieldPlace::element, 6, [](const FrameSource& of) { return of.stresses; }},
    {"pressure", FieldPlace::element, 1, [](const FrameSource& of) { return find_pressures(of.stresses); }},
    {"von_mises", FieldPlace::element, 1, [](const FrameSource& of) { return find_von_mises(of.stresses); }},
    {"equivalent_plastic_strain", FieldPlace::element, 1,
     [](const FrameSource& of) { return find_plastic_strains(of.model, of.state, of.elements()); }},
    {"temperature", FieldPlace::element, 1,
     [](const FrameSource& of) { return find_history(of.model, of.state, HistoryScalar::temperature, of.elements()); }},
    {"internal_energy", FieldPlace::element, 1,
     [](const FrameSource& of) {
       return find_history(of.model, of.state, HistoryScalar::internal_energy, of.elements());
     }},
    {"void_fraction", FieldPlace::element, 1,
     [](const FrameSource& of) {
       return find_history(of.model, of.state, HistoryScalar::void_fraction, of.elements());
     }},
    {"alive", FieldPlace::element, 1,
     [](const FrameSource& of) { return find_alive(of.model, of.state, of.elements()); }, FieldNumber::byte},
    {"damage", FieldPlace::element, 1,
     [](const FrameSource& of) { return find_damage(of.model, of.state, of.elements()); }},
    {"stress_bottom", FieldPlace::element, 6,
     [](const FrameSource& of) { return find_point_stresses(of.model, of.state, ShellPoint::lowest, of.elements()); }},
    {"stress_top", FieldPlace::element, 6,
     [](const FrameSource& of) { return find_point_stresses(of.model, of.state, ShellPoint::highest, of.elements()); }},
    {"thickness", FieldPlace::element, 1,
     [](const FrameSource& of) { return find_thicknesses(of.model, of.state, of.elements()); }},
    {"fibre_damage", FieldPlace::element, 1,
     [](const FrameSource& of) {
       return find_history(of.model, of.state, HistoryScalar::fibre_damage, of.elements());
     }},
    {"matrix_damage", FieldPlace::element, 1,
     [](const FrameSource& of) {
       return find_history(of.model, of.state, HistoryScalar::matrix_damage, of.elements());
     }},
    {"axial_force", FieldPlace::element, 1,
     [](const FrameSource& of) { return find_axial_forces(of.model, of.state, of.elements()); }},
    {"section_force", FieldPlace::element, 3,
     [](const FrameSource& of) { return find_section_forces(of.model, of.state, of.elements()); }},
    {"section_moment", FieldPlace::element, 3,
     [](const FrameSource& of) { return find_section_moments(of.model, of.state, of.elements()); }},
    {"body", FieldPlace::element, 1, [](const FrameSource& of) { return of.body; }},
    {"chunk", FieldPlace::element, 1, [](const FrameSource& of) { return of.chunk; }},
    {"fe_rank", FieldPlace::element, 1, [](const FrameSource& of) { return find_fe_ranks(of); }},
    {"contact_rank", FieldPlace::node, 1,
     [](const FrameSource& of) { return of.choose_nodes(of.contact.contact_ranks()); }},
};

}  // namespace

std::vector<double> FrameSource::choose_nodes(std::vector<double> values) const {
  if (region == nullptr) return values;
  std::vector<double> chosen;
  for (const int node : region->nodes) chosen.push_back(values[at(node)]);
  return chosen;
}

std::vector<double> list_rows(const Rows3<double>& rows, const std::vector<int>* nodes) {
  if (nodes != nullptr) return list_some_rows(rows, *nodes);
  const auto host = to_host(rows);
  return {host.data(), host.data() + host.extent(0) * 3};
}

std::vector<double> find_field(const std::string& name, const FrameSource& of, FieldData& field) {
  for (const FrameField& known : frame_fields) {
    if (name != known.name) continue;
    field = {name, known.place, known.components, {}, known.number};
    return known.find(of);
  }
  field = {name, FieldPlace::element, 6, {}};
  if (const auto stress = find_field_number(name, stress_points))
    return find_point_stresses(of.model, of.state, *stress - 1, of.elements());
  field.components = 1;
  if (const auto strain = find_field_number(name, plastic_strain_points))
    return find_point_plastic_strains(of.model, of.state, *strain - 1, of.elements());
  for (const auto& [quantity, scalar] : {std::pair(fibre_damage_points, HistoryScalar::fibre_damage),
                                         std::pair(matrix_damage_points, HistoryScalar::matrix_damage)}) {
    if (const auto point = find_field_number(name, quantity))
      return find_history(of.model, of.state, scalar, of.elements(), *point - 1);
  }
  if (const auto number = find_field_number(name, state_variables))
    return find_state_variables(of.model, of.state, *number - 1, of.elements());
  throw std::logic_error("no field is called '" + name + "' (the deck reader lets it through)");
}

}  // namespace percuss
