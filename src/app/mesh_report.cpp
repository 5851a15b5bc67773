#include "src/app/mesh_report.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "src/error.hpp"
#include "src/mesh/check_mesh.hpp"
#include "src/mesh/exodus_mesh.hpp"
#include "src/mesh/hex_geometry.hpp"

namespace percuss {
namespace {

PartMesh read_mesh(const std::string& file) {
  try {
    PartMesh mesh = read_exodus_mesh({file, {}, 1});
    const GeometryFindings findings = check_geometry(mesh);
    if (!findings.problems().empty()) throw InputError(findings.problems().join(""));
    findings.warn(mesh.warnings);
    add_side_nodes(mesh);
    return mesh;
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}: error: {}", file, error.what()));
  } catch (const SystemError& error) {
    throw SystemError(fmt::format("{}: error: {}", file, error.what()));
  }
}

double sum_volume(const PartMesh& mesh) {
  double volume = 0;
  for (const auto& element : mesh.elements) {
    HexCorners corners;
    for (std::size_t i = 0; i < 8; ++i) corners[i] = mesh.nodes[static_cast<std::size_t>(element[i])];
    if (!is_shell(element)) volume += find_hex_volume(corners);
  }
  return volume;
}

std::string format_extent(const PartMesh& mesh) {
  std::string text;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto [low, high] = std::minmax_element(mesh.nodes.begin(), mesh.nodes.end(),
                                                 [k](const Vec3& a, const Vec3& b) { return a[k] < b[k]; });
    text += fmt::format("{}{} {:.6g} to {:.6g}", k > 0 ? ", " : "", "xyz"[k], (*low)[k], (*high)[k]);
  }
  return text;
}

template <class Sets>
std::string format_sets(const Sets& sets, const char* label, const char* what) {
  std::string text;
  for (const auto& [name, members] : sets) {
    text += fmt::format("{:<12}{}: {} {}\n", text.empty() ? label : "", name, members.size(), what);
  }
  return text;
}

}  // namespace

std::string describe_exodus_mesh(const std::string& file) {
  const PartMesh mesh = read_mesh(file);
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
