#include "src/app/scene_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <variant>

#include "src/mesh/hex_geometry.hpp"

namespace percuss {
namespace {

std::size_t index(int i) { return static_cast<std::size_t>(i); }

std::string line(const std::string& label, const std::string& text) { return fmt::format("{:<10}{}\n", label, text); }

std::string count(std::size_t n, const std::string& what, const std::string& plural) {
  return fmt::format("{} {}", n, n == 1 ? what : plural);
}

std::string format_parts(const SceneReport& scene) {
  const Mesh& mesh = scene.mesh;
  std::vector<std::size_t> elements(mesh.parts.size());
  for (const int part : mesh.element_part) ++elements[index(part)];
  const std::vector<double> masses = sum_part_masses(mesh, scene.deck);
  std::size_t width = 4;
  for (const MeshPart& part : mesh.parts) width = std::max(width, part.name.size());
  std::string text = line(
      "parts", fmt::format("{:<{}}  {:>10}  {:>10}  {:>12}  material", "name", width, "elements", "nodes", "mass"));
  double total = 0;
  for (std::size_t i = 0; i < mesh.parts.size(); ++i) {
    const MeshPart& part = mesh.parts[i];
    text += line("", fmt::format("{:<{}}  {:>10}  {:>10}  {:>12.6g}  {}", part.name, width, elements[i],
                                 mesh.node_sets.at(part.name).size(), masses[i],
                                 scene.deck.materials.at(index(part.material)).name));
    total += masses[i];
  }
  const std::vector<int> bodies = find_bodies(mesh);
  const std::size_t body_count = bodies.empty() ? 0 : index(*std::max_element(bodies.begin(), bodies.end())) + 1;
  return text + line("total", fmt::format("{}, {}, {}, mass {:.6g}", count(mesh.elements.size(), "element", "elements"),
                                          count(mesh.nodes.size(), "node", "nodes"),
                                          count(body_count, "body", "bodies"), total));
}

std::string format_size(const Mesh& mesh) {
  Vec3 low = mesh.nodes.at(0), high = low;
  for (const Vec3& x : mesh.nodes) {
    for (std::size_t k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], x[k]);
      high[k] = std::max(high[k], x[k]);
    }
  }
  return line("extent", fmt::format("x {:.6g} to {:.6g}, y {:.6g} to {:.6g}, z {:.6g} to {:.6g}", low[0], high[0],
                                    low[1], high[1], low[2], high[2]));
}

std::string format_contact(const SceneReport& scene) {
  const ContactDeck& contact = scene.deck.contact;
  using Surfaces = ContactDeck::Surfaces;
  std::string text = "none (bodies pass through each other)";
  if (contact.surfaces != Surfaces::none) {
    text = contact.surfaces == Surfaces::all ? "all surfaces"
                                             : count(contact.pairs.size(), "pair of surfaces", "pairs of surfaces");
    text += fmt::format(", friction {:g}; {} contact nodes, {} contact faces", contact.friction, scene.contact_nodes,
                        scene.contact_faces);
  }
  if (!scene.deck.walls.empty()) text += "; " + count(scene.deck.walls.size(), "wall", "walls");
  std::string lines = line("contact", text);
  if (!scene.overlap.empty()) lines += line("", scene.overlap);
  return lines;
}

std::string format_loads(const Deck& deck) {
  std::string text;
  const auto add = [&](const std::string& item) { text += (text.empty() ? "" : ", ") + item; };
  if (!deck.initial.empty()) add(count(deck.initial.size(), "initial velocity", "initial velocities"));
  if (!deck.conditions.empty()) add(count(deck.conditions.size(), "condition", "conditions"));
  if (!deck.pressures.empty()) add(count(deck.pressures.size(), "pressure", "pressures"));
  if (deck.gravity != Vec3{}) add("gravity");
  return line("loads", text.empty() ? "none" : text);
}

std::string format_output(const Deck& deck) {
  const OutputDeck& output = deck.output;
  std::string text = "summary";
  if (output.history_every) {
    text +=
        *output.history_every > 0 ? fmt::format(", history every {:g}", *output.history_every) : ", history every step";
  }
  if (output.fields_every) {
    text +=
        fmt::format(", {:.0f} frames of fields", std::floor(deck.time.end / *output.fields_every * (1 + 1e-12)) + 1);
  }
  return line("output", text);
}

std::string format_step(const SceneReport& scene) {
  const auto e = index(scene.controlling_element);
  const std::string& part = scene.mesh.parts.at(index(scene.mesh.element_part.at(e))).name;
  const double end = scene.deck.time.end;
  return line(
      "time",
      fmt::format(
          "0 to {:g}; first step {:.4g} (element {} of part '{}' controls it), about {:.0f} steps if it stays so", end,
          scene.first_step, scene.mesh.element_ids.at(e), part, std::ceil(end / scene.first_step)));
}

}  // namespace

std::vector<double> sum_part_masses(const Mesh& mesh, const Deck& deck) {
  std::vector<double> volumes(mesh.parts.size());
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
    HexCorners corners;
    for (std::size_t i = 0; i < 8; ++i) corners[i] = mesh.nodes[index(mesh.elements[e][i])];
    volumes[index(mesh.element_part[e])] += find_hex_volume(corners);
  }
  for (std::size_t i = 0; i < volumes.size(); ++i) {
    const MaterialDeck& material = deck.materials.at(index(mesh.parts[i].material));
    volumes[i] *= std::visit([](const auto& model) { return model.density; }, material.model);
  }
  return volumes;
}

std::string format_scene(const SceneReport& scene) {
  const Deck& deck = scene.deck;
  std::string text = line("deck", deck.file + (deck.title.empty() ? "" : ": " + deck.title));
  if (!deck.units.empty()) text += line("units", deck.units);
  text += format_parts(scene) + format_size(scene.mesh) + format_contact(scene) + format_loads(deck) +
          format_output(deck) + format_step(scene);
  std::size_t warnings = 0;
  for (const auto& list : {deck.warnings, scene.mesh.warnings}) {
    for (const std::string& warning : list) text += warning + "\n";
    warnings += list.size();
  }
  return text + (warnings == 0 ? "The deck and its meshes are right.\n"
                               : fmt::format("The deck and its meshes can be run; {}.\n",
                                             count(warnings, "warning", "warnings")));
}

}  // namespace percuss
