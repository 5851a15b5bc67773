#include "src/step/elements/build_beams.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>

#include "kernels/core/host_copy.hpp"
#include "src/deck/laws/law_traits.hpp"
#include "src/deck/laws/make_material.hpp"
#include "src/deck/laws/material_properties.hpp"
#include "src/error.hpp"
#include "src/fail_together.hpp"
#include "src/mesh/hex_geometry.hpp"
#include "src/step/model/element_blocks.hpp"
#include "src/step/model/whole_mesh.hpp"

namespace percuss {
namespace {

bool is_of_beams(const ElementBlock& block) { return find_topology(block.topology).is_line(); }

const PartDeck& find_part(const Deck& deck, const ElementBlock& block) {
  return deck.parts[static_cast<std::size_t>(block.part)];
}

const MaterialDeck& find_material(const Deck& deck, const ElementBlock& block) {
  return deck.materials[static_cast<std::size_t>(block.material)];
}

[[noreturn]] void refuse_beams(const Deck& deck, const ElementBlock& block, const std::string& what) {
  const PartDeck& part = find_part(deck, block);
  throw InputError(fmt::format("{}: error: part '{}' has beams {}", deck.where(part.place), part.name, what));
}

bool has_other_criteria(const FailureDeck& failure) {
  return failure.principal_stress || failure.principal_strain || failure.thinning || failure.mean_thinning ||
         failure.pressure || failure.johnson_cook || !failure.triaxiality.empty() || failure.shear ||
         failure.evolution || failure.coupling || failure.yield_time || failure.volume_below || failure.volume_above ||
         failure.step || failure.inverted;
}

/// Throws on all ranks alike: they know all blocks.
void check_blocks(const Deck& deck, const Mesh& mesh) {
  for (const ElementBlock& block : mesh.elements.blocks) {
    if (!is_of_beams(block)) continue;
    const MaterialDeck& material = find_material(deck, block);
    const LawTraits& law = find_traits(material);
    if (!law.is_of_beams || material.equation_of_state)
      refuse_beams(
          deck, block,
          fmt::format("of material '{}' (beams support {}, without an equation of state): give it one of these",
                      material.name, name_laws(&LawTraits::is_of_beams)));
    if (material.failure && has_other_criteria(*material.failure))
      refuse_beams(
          deck, block,
          fmt::format("of material '{}', which fails by a criterion of other elements (those of beams are "
                      "resultants, time and plastic_strain): give them a material with these alone, or without failure",
                      material.name));
    if (!law.has_plastic_strain && material.failure && material.failure->plastic_strain)
      refuse_beams(deck, block,
                   fmt::format("of material '{}', which fails by plastic_strain and never yields: use a law that "
                               "yields, or resultants",
                               material.name));
    if (law.has_plastic_strain && std::holds_alternative<BeamSection>(*find_part(deck, block).section))
      refuse_beams(
          deck, block,
          "with a general section of a material that yields (plasticity needs the shape of the section): use round, "
          "tube, rectangle, box or i_shape, or an elastic material");
  }
}

BeamFibres list_fibres(const BeamSectionDeck& section) {
  struct List {
    BeamFibres operator()(const TrussSection& s) const {
      BeamFibres one;
      one.add(0, 0, s.area);
      return one;
    }
    BeamFibres operator()(const RoundSection& s) const { return list_ring_fibres<3>(s.radius, 0); }
    BeamFibres operator()(const TubeSection& s) const { return list_ring_fibres<2>(s.outer_radius, s.inner_radius); }
    BeamFibres operator()(const RectangleSection& s) const { return list_rectangle_fibres(s.size[0], s.size[1]); }
    BeamFibres operator()(const BoxSection& s) const { return list_box_fibres(s.size[0], s.size[1], s.wall); }
    BeamFibres operator()(const IShapeSection& s) const {
      return list_i_shape_fibres(s.size[0], s.size[1], s.flange, s.web);
    }
    BeamFibres operator()(const BeamSection&) const { return {}; }
  };
  return std::visit(List{}, section);
}

BeamLimits make_limits(const FailureDeck& failure) {
  constexpr double none = BeamLimits::none;
  const BeamFailureDeck deck = failure.resultants.value_or(BeamFailureDeck{});
  return {deck.axial.value_or(none),  deck.shear_y.value_or(none),  deck.shear_z.value_or(none),
          deck.torque.value_or(none), deck.moment_y.value_or(none), deck.moment_z.value_or(none),
          failure.time.value_or(none)};
}

/// The law of fibres that yield.
void set_fibre_law(const MaterialDeck& material, BeamParameters& parameters) {
  visit_law(material, [&](const auto& law) {
    using Law = std::decay_t<decltype(law)>;
    if constexpr (std::is_same_v<Law, J2Plasticity>)
      parameters.law = {find_youngs_modulus(law.moduli()), law.yield_stress, law.hardening_modulus};
    else if constexpr (FlowLaw<Law>) {
      parameters.law.youngs_modulus = find_youngs_modulus(law.moduli());
      parameters.called = CalledFibreLaw::make(law, material.density);
    }
  });
}

BeamParameters make_parameters(const Deck& deck, const ElementBlock& block) {
  const BeamSectionDeck& section = *find_part(deck, block).section;
  BeamParameters parameters;
  const BeamSection form = make_beam_section(section);
  const LameConstants c = find_moduli(find_material(deck, block));
  parameters.stiffness = find_beam_stiffness(form, find_youngs_modulus(c), c.mu);
  parameters.area = form.area;
  parameters.polar_square = find_polar_moment(form) / form.area;
  parameters.bends = bends(section);
  if (const auto& failure = find_material(deck, block).failure) parameters.limits = make_limits(*failure);
  if (find_traits(find_material(deck, block)).has_plastic_strain) {
    set_fibre_law(find_material(deck, block), parameters);
    parameters.fibres = list_fibres(section);
  }
  return parameters;
}

void describe_records(std::size_t c, const BeamParameters& parameters, const BeamRecords& records) {
  records.record_size[c] = BeamRecord::find_size(parameters.fibres.count, count_more_history(parameters));
  records.points[c] = parameters.fibres.count;
  records.history[c] = -1;
  for (std::size_t k = 0; k < history_scalars; ++k) records.scalars[c * history_scalars + k] = -1;
}

void build_block(const Deck& deck, const ChunkedMesh& chunked, const BeamRecords& records, Model& model) {
  std::vector<int> chunks;
  std::vector<BeamParameters> rows;
  std::map<int, int> row_of_part;
  for (std::size_t c = 0; c < chunked.chunks.size(); ++c) {
    const ElementBlock& block = find_block(chunked, chunked.chunks[c]);
    if (!is_of_beams(block)) continue;
    const auto [row, is_new] = row_of_part.emplace(block.part, static_cast<int>(rows.size()));
    if (is_new) rows.push_back(make_parameters(deck, block));
    if (!find_part(deck, block).rigid) chunks.push_back(static_cast<int>(c));
    records.parameters[c] = row->second;
    describe_records(c, rows[static_cast<std::size_t>(row->second)], records);
  }
  model.others->beams.chunks = to_view("percuss::chunks_of_beams", chunks);
  model.others->beams.parameters = to_view("percuss::beam_parameters", rows);
}

/// The axis of the scene that lies most across a line.
Vec3 find_axis_across(const Vec3& line) {
  std::size_t least = 0;
  for (std::size_t k = 1; k < 3; ++k)
    if (std::abs(line[k]) < std::abs(line[least])) least = k;
  Vec3 axis{};
  axis[least] = 1;
  return axis;
}

/// y of the section of an element at the start.
Vec3 find_start_axis(const Deck& deck, const Mesh& mesh, std::size_t element) {
  constexpr double least_sine = 1e-6;
  const PartDeck& part = find_part(deck, mesh.block_of(element));
  const ElementCorners x = gather_corners(mesh.elements, element, mesh.nodes);
  const Vec3 line = subtract(x[1], x[0]), toward = part.toward.value_or(find_axis_across(line));
  const Vec3 across = cross(line, toward);
  if (!(std::sqrt(dot(across, across)) > least_sine * std::sqrt(dot(line, line))))
    throw InputError(
        fmt::format("{}: error: toward of part '{}' lies along {} (it sets the direction of the section's y axis, "
                    "which cannot be along the beam): give another direction, or split the part",
                    deck.where(part.place), part.name, name_element(mesh, static_cast<int>(element))));
  const auto frame =
      find_beam_frame<double>({{0, 0, 0}, {line[0], line[1], line[2]}}, {toward[0], toward[1], toward[2]});
  return {frame.e2.x, frame.e2.y, frame.e2.z};
}

void build_start_axes(const Deck& deck, const ChunkedMesh& chunked, Model& model) {
  const Mesh& mesh = chunked.mesh;
  std::vector<Vec3> axes(mesh.elements.size(), Vec3{});
  fail_together(model.ranks, [&] {
    for (std::size_t e = 0; e < axes.size(); ++e)
      if (is_of_beams(mesh.block_of(e))) axes[e] = find_start_axis(deck, mesh, e);
  });
  model.start_beam_axes = to_rows("percuss::start_beam_axes", axes);
}

double find_length(const Mesh& mesh, std::size_t element) {
  const ElementCorners x = gather_corners(mesh.elements, element, mesh.nodes);
  return find_distance(x[0], x[1]);
}

double find_gyration_square(const BeamParameters& parameters, double length) {
  return parameters.bends ? 2 * find_beam_inertia(parameters.stiffness, 1, length) : 0;
}

/// Calls visit(element, parameters of its block, its length) for all beams.
template <class Visit>
void visit_beams(const Deck& deck, const Mesh& mesh, const Visit& visit) {
  std::map<int, BeamParameters> of_block;
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
    const ElementBlock& block = mesh.block_of(e);
    if (!is_of_beams(block)) continue;
    const auto [of, is_new] = of_block.emplace(mesh.elements.block_index(e), BeamParameters{});
    if (is_new) of->second = make_parameters(deck, block);
    visit(e, of->second, find_length(mesh, e));
  }
}

}  // namespace

bool has_bending_beams(const Deck& deck, const Mesh& mesh) {
  return std::any_of(mesh.elements.blocks.begin(), mesh.elements.blocks.end(), [&](const ElementBlock& block) {
    return is_of_beams(block) && bends(*find_part(deck, block).section);
  });
}

void build_beam_block(const Deck& deck, const ChunkedMesh& chunked, const BeamRecords& records, Model& model) {
  model.has_beams = has_beams(chunked.mesh);
  if (!model.has_beams) return;
  check_blocks(deck, chunked.mesh);
  build_block(deck, chunked, records, model);
  build_start_axes(deck, chunked, model);
}

void set_beam_gyrations(const Deck& deck, const Mesh& mesh, std::vector<double>& squares) {
  visit_beams(deck, mesh, [&](std::size_t e, const BeamParameters& parameters, double length) {
    squares[e] = find_gyration_square(parameters, length);
  });
}

std::vector<std::array<double, 6>> find_beam_tensors(const Deck& deck, const Mesh& mesh,
                                                     const std::vector<double>& element_mass) {
  std::vector<std::array<double, 6>> tensors(mesh.elements.size(), std::array<double, 6>{});
  visit_beams(deck, mesh, [&](std::size_t e, const BeamParameters& parameters, double length) {
    if (!parameters.bends) return;
    const double excess = element_mass[e] * (parameters.polar_square - find_gyration_square(parameters, length));
    const ElementCorners x = gather_corners(mesh.elements, e, mesh.nodes);
    const Vec3 line = subtract(x[1], x[0]);
    const double share = excess / (length * length);
    tensors[e] = {share * line[0] * line[0], share * line[1] * line[1], share * line[2] * line[2],
                  share * line[0] * line[1], share * line[1] * line[2], share * line[2] * line[0]};
  });
  return tensors;
}

void set_beam_bounds(const Deck& deck, const Mesh& mesh, const std::vector<double>& element_mass,
                     std::vector<double>& bounds) {
  visit_beams(deck, mesh, [&](std::size_t e, const BeamParameters& parameters, double length) {
    BeamState state;
    state.mass = element_mass[e];
    state.gyration_square = find_gyration_square(parameters, length);
    bounds[e] = find_beam_step(parameters, state, length);
  });
}

}  // namespace percuss
