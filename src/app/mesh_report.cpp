#include "src/app/mesh_report.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "src/mesh/hex_geometry.hpp"
#include "src/mesh/mesh.hpp"

namespace percuss {
namespace {

// The name that the mesh's part has while it is looked at; no message shows it.
constexpr const char* part_name = "mesh";

Mesh read_mesh(const std::string& file) {
  Deck deck;
  deck.file = file;
  PartDeck part;
  part.name = part_name;
  part.shape = ExodusMesh{file, {}, 1};
  part.material = "any";
  deck.parts.push_back(std::move(part));
  deck.materials.push_back({"any", ElasticDeck{1, 1, 0}, {}});
  return build_mesh(deck);
}

double sum_volume(const Mesh& mesh) {
  double volume = 0;
  for (const auto& element : mesh.elements) {
    HexCorners corners;
    for (std::size_t i = 0; i < 8; ++i) corners[i] = mesh.nodes[static_cast<std::size_t>(element[i])];
    volume += find_hex_volume(corners);
  }
  return volume;
}

std::string format_extent(const Mesh& mesh) {
  std::string text;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto [low, high] = std::minmax_element(mesh.nodes.begin(), mesh.nodes.end(),
                                                 [k](const Vec3& a, const Vec3& b) { return a[k] < b[k]; });
    text += fmt::format("{}{} {:.6g} to {:.6g}", k > 0 ? ", " : "", "xyz"[k], (*low)[k], (*high)[k]);
  }
  return text;
}

// The sets of the file: those of the part itself are left out.
template <class Sets>
std::string format_sets(const Sets& sets, const char* label, const char* what) {
  std::string text;
  const std::string prefix = std::string(part_name) + "/";
  for (const auto& [name, members] : sets) {
    if (!name.starts_with(prefix)) continue;
    text +=
        fmt::format("{:<12}{}: {} {}\n", text.empty() ? label : "", name.substr(prefix.size()), members.size(), what);
  }
  return text;
}

}  // namespace

std::string describe_exodus_mesh(const std::string& file) {
  const Mesh mesh = read_mesh(file);
  std::string text = fmt::format("{:<12}{}: Exodus II\n", "mesh", file);
  text += fmt::format("{:<12}{} elements, {} nodes, volume {:.6g}\n", "size", mesh.elements.size(), mesh.nodes.size(),
                      sum_volume(mesh));
  text += fmt::format("{:<12}{}\n", "extent", format_extent(mesh));
  text += format_sets(mesh.node_sets, "node sets", "nodes");
  text += format_sets(mesh.side_sets, "side sets", "faces");
  for (const std::string& warning : mesh.warnings) text += warning + "\n";
  return text;
}

}  // namespace percuss
