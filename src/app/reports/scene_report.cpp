#include "src/app/reports/scene_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <variant>

#include "comm/agreement.hpp"
#include "comm/all_reduce.hpp"
#include "comm/exact_reduction.hpp"
#include "src/app/reports/report_lines.hpp"
#include "src/deck/units.hpp"
#include "src/index.hpp"
#include "src/mesh/describe_joints.hpp"
#include "src/mesh/hex_geometry.hpp"
#include "src/output/warning_log.hpp"
#include "src/step/elements/element_mass.hpp"
#include "src/step/model/whole_mesh.hpp"

namespace percuss {
namespace {

constexpr double round_off = 1e-12;  // relative difference below which two masses are the same

std::string format_parts(const SceneReport& scene) {
  std::size_t width = 4;
  for (const PartReport& part : scene.parts) width = std::max(width, part.name.size());
  const std::string unit = unit_suffix(scene.deck.units, dimensions::mass);
  std::string text =
      format_line("parts", fmt::format("{:<{}}  {:>10}  {:>10}  {:>12}  material", "name", width, "elements", "nodes",
                                       unit.empty() ? "mass" : "mass [" + unit.substr(1) + "]"));
  double total = 0;
  for (const PartReport& part : scene.parts) {
    text += format_line("", fmt::format("{:<{}}  {:>10}  {:>10}  {:>12.6g}  {}", part.name, width, part.elements,
                                        part.nodes, part.mass, part.material));
    total += part.mass;
  }
  std::string mass = fmt::format("mass {:.6g}{}", total, unit);
  if (std::abs(scene.total_mass - total) > round_off * total)
    mass = fmt::format("mass {:.6g}{} ({:.6g}{} of elements; the rest is added or given by the deck)", scene.total_mass,
                       unit, total, unit);
  return text + format_line("total", fmt::format("{}, {}, {}, {}", format_count(scene.elements, "element", "elements"),
                                                 format_count(scene.nodes, "node", "nodes"),
                                                 format_count(scene.bodies, "body", "bodies"), mass));
}

/// Changes of the mesh by the deck.
std::string format_changes(const SceneReport& scene) {
  std::string text;
  for (const std::string& note : scene.mesh_notes) text += format_line(text.empty() ? "changed" : "", note);
  return text;
}

std::string format_springs(const SceneReport& scene) {
  std::string text;
  for (const std::string& note : scene.spring_notes) text += format_line(text.empty() ? "springs" : "", note);
  return text;
}

std::string format_joints(const SceneReport& scene) {
  std::string text;
  for (const std::string& joint : scene.joints) text += format_line(text.empty() ? "joints" : "", joint);
  return text;
}

std::string format_size(const SceneReport& scene) {
  const Vec3 &low = scene.low, &high = scene.high;
  return format_line(
      "extent", fmt::format("x {:.6g} to {:.6g}, y {:.6g} to {:.6g}, z {:.6g} to {:.6g}{}", low[0], high[0], low[1],
                            high[1], low[2], high[2], unit_suffix(scene.deck.units, dimensions::length)));
}

/// "mm, kg, ms: force kN, stress GPa, energy J"
std::string format_units(const Units& units) {
  return format_line("units",
                     fmt::format("{}: force {}, stress {}, energy {}", units.text(), units.name_of(dimensions::force),
                                 units.name_of(dimensions::stress), units.name_of(dimensions::energy)));
}

/// "friction 0.1, 0.3 of 1 pair", or "friction 0.1 to 0.3 of 2 pairs" where all pairs have theirs.
std::string format_friction(const ContactDeck& contact) {
  std::vector<double> own;
  for (const PairFrictionDeck& pair : contact.frictions) own.push_back(pair.friction);
  for (const SurfacePairDeck& pair : contact.pairs)
    if (pair.friction) own.push_back(*pair.friction);
  const std::string all = fmt::format("friction {:g}", contact.friction);
  if (own.empty()) return all;
  const auto [least, most] = std::minmax_element(own.begin(), own.end());
  const std::string range = *least < *most ? fmt::format("{:g} to {:g}", *least, *most) : fmt::format("{:g}", *least);
  const std::string of = range + " of " + format_count(own.size(), "pair", "pairs");
  const bool is_of_all = contact.frictions.empty() && own.size() == contact.pairs.size();
  return is_of_all ? "friction " + of : all + ", " + of;
}

std::string format_contact(const SceneReport& scene) {
  const ContactDeck& contact = scene.deck.contact;
  using Surfaces = ContactDeck::Surfaces;
  std::string text = "none (bodies pass through each other)";
  if (contact.surfaces != Surfaces::none) {
    text = contact.surfaces == Surfaces::all
               ? "all surfaces"
               : format_count(contact.pairs.size(), "pair of surfaces", "pairs of surfaces");
    text += fmt::format(", {}; {} contact nodes, {} contact faces", format_friction(contact), scene.contact_nodes,
                        scene.contact_faces);
  }
  if (!scene.deck.walls.empty()) text += "; " + format_count(scene.deck.walls.size(), "wall", "walls");
  std::string lines = format_line("contact", text);
  for (const std::string& note : scene.contact_notes) lines += format_line("", note);
  return lines;
}

std::string format_loads(const Deck& deck) {
  std::string text;
  const auto add = [&](const std::string& item) { text += (text.empty() ? "" : ", ") + item; };
  if (!deck.initial.empty()) add(format_count(deck.initial.size(), "initial velocity", "initial velocities"));
  if (!deck.conditions.empty()) add(format_count(deck.conditions.size(), "condition", "conditions"));
  if (!deck.pressures.empty()) add(format_count(deck.pressures.size(), "pressure", "pressures"));
  if (!deck.nodal_loads.empty()) add(format_count(deck.nodal_loads.size(), "load on nodes", "loads on nodes"));
  if (deck.gravity.any()) add("gravity");
  if (!deck.dampings.empty()) add("damping");
  return format_line("loads", text.empty() ? "none" : text);
}

/// The first and the last state, and those between at multiples of `every`.
double count_frames(double end, double every) { return std::max(std::ceil(end / every * (1 - 1e-12)), 1.0) + 1; }

std::string format_output(const Deck& deck, const std::vector<FieldOutputSize>& sizes) {
  const OutputDeck& output = deck.output;
  std::string text = "summary";
  if (output.history_every) {
    text +=
        *output.history_every > 0 ? fmt::format(", history every {:g}", *output.history_every) : ", history every step";
  }
  for (const FieldsDeck* const fields : output.list_fields()) {
    const std::string what = fields->name.empty() ? "fields" : fmt::format("field output '{}'", fields->name);
    text += fmt::format(", {:.0f} frames of {}", count_frames(deck.time.end, *fields->every), what);
    const auto size = std::find_if(sizes.begin(), sizes.end(), [&](const auto& of) { return of.name == fields->name; });
    if (size != sizes.end()) text += fmt::format(" ({} elements, {} nodes)", size->elements, size->nodes);
  }
  if (output.checkpoint_every) text += fmt::format(", checkpoint every {:g}", *output.checkpoint_every);
  if (output.checkpoint_wall) text += fmt::format(", checkpoint every {:g} s by the clock", *output.checkpoint_wall);
  if (output.checkpoint_at_end) text += ", checkpoint at the end";
  return format_line("output", text);
}

std::string format_step(const SceneReport& scene) {
  const double end = scene.deck.time.end;
  const std::string unit = unit_suffix(scene.deck.units, dimensions::time);
  const bool is_damped = scene.undamped_step > 0;
  const std::string without =
      is_damped ? fmt::format("; without this damping {:.4g}{}", scene.undamped_step, unit) : std::string();
  return format_line(
      "time", fmt::format("0 to {:g}{}; first step {:.4g}{} ({}{} controls it{}), about {:.0f} steps of this size", end,
                          unit, scene.first_step, unit, is_damped ? "stiffness_damping of " : "",
                          scene.controlling_element, without, std::ceil(end / scene.first_step)));
}

std::vector<PartReport> describe_parts(const Deck& deck, const ChunkedMesh& chunked, const Communicator& ranks) {
  const Mesh& mesh = chunked.mesh;
  const std::size_t count = mesh.parts.size();
  std::vector<std::int64_t> counts(2 * count, 0);  // elements, then nodes
  std::vector<ExactSum> masses(count);
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
    const ElementBlock& block = mesh.block_of(e);
    masses[at(block.part)].add(find_element_mass(deck, mesh, e));
    ++counts[at(block.part)];
  }
  for (std::size_t p = 0; p < count; ++p) {
    const std::vector<int>& nodes = mesh.node_sets.at(mesh.parts[p].name);
    counts[count + p] = std::count_if(nodes.begin(), nodes.end(), [&](int n) { return owns_node(chunked, n); });
  }
  all_reduce(ranks, Reduce::sum, counts);
  sum_over_ranks(ranks, masses);
  std::vector<PartReport> parts;
  for (std::size_t p = 0; p < count; ++p) {
    const std::string rigid = deck.parts[p].rigid ? ", rigid" : "";
    parts.push_back(
        {mesh.parts[p].name, deck.parts[p].material + rigid, counts[p], counts[count + p], masses[p].round()});
  }
  return parts;
}

/// Mass of the elements, where the deck gives none to their rigid body, and all that it adds.
double find_total_mass(const Deck& deck, const std::vector<PartReport>& parts) {
  std::map<std::string, double> of_elements, given;  // by the body that parts belong to
  for (std::size_t p = 0; p < parts.size(); ++p) {
    const std::optional<RigidDeck>& rigid = deck.parts[p].rigid;
    const std::string& body = rigid && !rigid->body.empty() ? rigid->body : parts[p].name;
    of_elements[body] += parts[p].mass;
    if (rigid && rigid->mass) given[body] = *rigid->mass;
  }
  given.merge(of_elements);  // keeps what is given
  double total = 0;
  for (const auto& [body, mass] : given) total += mass;
  for (const AddedMassDeck& added : deck.added_masses) total += added.mass;
  for (const RigidSetDeck& set : deck.rigid_sets) total += set.mass;
  return total;
}

std::int64_t count_bodies(const Mesh& mesh, const Communicator& ranks) {
  int bodies = mesh.bodies.empty() ? 0 : *std::max_element(mesh.bodies.begin(), mesh.bodies.end()) + 1;
  all_reduce(ranks, Reduce::largest, bodies);
  return bodies;
}

}  // namespace

SceneReport describe_scene(const Deck& deck, const ChunkedMesh& chunked) {
  const Communicator ranks = find_ranks(chunked.mesh);
  SceneReport scene{deck, describe_parts(deck, chunked, ranks)};
  scene.elements = chunked.numbering.element_count();
  scene.nodes = chunked.numbering.node_count();
  scene.bodies = count_bodies(chunked.mesh, ranks);
  scene.total_mass = find_total_mass(deck, scene.parts);
  scene.joints = describe_joints(chunked.mesh);
  scene.low = chunked.mesh.low;
  scene.high = chunked.mesh.high;
  return scene;
}

std::string describe_element(const ChunkedMesh& chunked, std::int64_t number) {
  const Mesh& mesh = chunked.mesh;
  const int element = find_local_element(chunked, number);
  const std::string text = element >= 0 ? name_element(mesh, element) : "";
  return broadcast_text(find_ranks(mesh), text, chunked.numbering.find_element_owner(number));
}

std::string format_scene(const SceneReport& scene) {
  const Deck& deck = scene.deck;
  std::string text = format_line("deck", deck.file + (deck.title.empty() ? "" : ": " + deck.title));
  if (const auto units = find_units(deck.units)) text += format_units(*units);
  text += format_parts(scene) + format_joints(scene) + format_springs(scene) + format_changes(scene) +
          format_size(scene) + format_contact(scene) + format_loads(deck) + format_output(deck, scene.field_outputs) +
          format_step(scene);
  for (const Warning& warning : scene.warnings) text += format_warning(warning) + "\n";
  return text + (scene.warnings.empty()
                     ? "No errors in the deck or its meshes.\n"
                     : fmt::format("The deck and its meshes can be run; {}.\n", count_warnings(scene.warnings)));
}

}  // namespace percuss
