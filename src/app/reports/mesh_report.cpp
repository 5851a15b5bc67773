#include "src/app/reports/mesh_report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "src/app/reports/report_lines.hpp"
#include "src/error.hpp"
#include "src/mesh/hex_geometry.hpp"
#include "src/mesh/quality/check_mesh.hpp"
#include "src/mesh/quality/mesh_doubts.hpp"
#include "src/mesh/reading/mesh_reader.hpp"
#include "src/mesh/reading/part_reader.hpp"
#include "src/mesh/reading/results_reader.hpp"

namespace percuss {
namespace {

/// "mesh.e: error: it is damaged", or of a text with a line "mesh.k:12: error: there is no node 5".
std::string place_error(const std::string& file, const std::string& text) {
  const std::size_t end = text.starts_with(file + ":") ? text.find(": ", file.size()) : std::string::npos;
  if (end == std::string::npos) return fmt::format("{}: error: {}", file, text);
  return text.substr(0, end) + ": error" + text.substr(end);
}

/// Returns what `read` returns; its errors name the file.
template <class Read>
auto name_file(const std::string& file, const Read& read) {
  try {
    return read();
  } catch (const InputError& error) {
    throw InputError(place_error(file, error.what()));
  } catch (const SystemError& error) {
    throw SystemError(place_error(file, error.what()));
  }
}

PartMesh read_mesh(const std::string& file, const std::vector<std::string>& blocks) {
  PartMesh mesh = read_part_mesh({file, blocks, 1, false});
  const GeometryFindings findings = check_geometry(mesh);
  if (!findings.problems().empty()) throw InputError(findings.problems().join(""));
  findings.warn(mesh.warnings);
  warn_of_doubts(mesh, mesh.elements.size(), mesh.warnings);
  return mesh;
}

std::string mesh_line(const std::string& label, const std::string& text) { return format_line(label, text, 12); }

std::string count_of(std::int64_t n, const std::string& what) { return format_count(n, what, what + "s"); }

std::string format_extent(const std::vector<Vec3>& nodes) {
  if (nodes.empty()) return "none";
  std::string text;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto [low, high] =
        std::minmax_element(nodes.begin(), nodes.end(), [k](const Vec3& a, const Vec3& b) { return a[k] < b[k]; });
    text += fmt::format("{}{} {:.6g} to {:.6g}", k > 0 ? ", " : "", "xyz"[k], (*low)[k], (*high)[k]);
  }
  return text;
}

std::string format_blocks(const std::vector<FileBlock>& blocks) {
  std::string text;
  for (const FileBlock& block : blocks) {
    text += mesh_line(
        text.empty() ? "blocks" : "",
        fmt::format("{}, id {}: {} of kind {} with {}{}", block.name, block.id, count_of(block.elements, "element"),
                    block.kind, count_of(block.nodes_per_element, "node"),
                    block.elements == 0 || block.topology ? "" : ", which cannot be run"));
  }
  return text;
}

std::string format_sets(const std::vector<FileSet>& sets, const char* label, const char* what) {
  std::string text;
  for (const FileSet& set : sets)
    text += mesh_line(text.empty() ? label : "",
                      fmt::format("{}, id {}: {}", set.name, set.id, count_of(set.entries, what)));
  return text.empty() ? mesh_line(label, "none") : text;
}

/// Elements that percuss makes of the file, with their volume, area and length.
std::string format_elements(const PartMesh& mesh) {
  double volume = 0, area = 0, length = 0;
  std::int64_t shells = 0, triangles = 0, beams = 0;
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
    const ElementCorners corners = gather_corners(mesh.elements, e, mesh.nodes);
    const Topology& topology = mesh.elements.topology_of(e);
    if (topology.is_surface()) {
      area += find_shell_area_size(corners);
      ++shells;
      triangles += topology.corner_count == 3 ? 1 : 0;
    } else if (topology.is_line()) {
      length += find_distance(corners[0], corners[1]);
      ++beams;
    } else {
      volume += find_solid_volume(topology, corners);
    }
  }
  const std::int64_t solids = static_cast<std::int64_t>(mesh.elements.size()) - shells - beams;
  std::string text = count_of(static_cast<std::int64_t>(mesh.nodes.size()), "node");
  if (solids > 0) text += fmt::format(", {} solid elements of volume {:.6g}", solids, volume);
  if (shells > 0) text += fmt::format(", {} shells of area {:.6g} (the part needs a thickness)", shells, area);
  if (triangles > 0) text += fmt::format(", {} of them triangles", triangles);
  if (beams > 0) text += fmt::format(", {} beams of length {:.6g} (the part needs a section)", beams, length);
  return text;
}

std::string format_reading(const std::string& file, const MeshContents& contents) {
  std::vector<std::string> chosen;
  bool all = true;
  for (const FileBlock& block : contents.blocks) {
    if (block.elements == 0) continue;
    if (block.topology) chosen.push_back(block.name);
    all = all && block.topology.has_value();
  }
  if (contents.dimensions != 3)
    return mesh_line("percuss", fmt::format("runs meshes of 3 dimensions only, this has {}", contents.dimensions));
  if (chosen.empty())
    return mesh_line("percuss", fmt::format("runs none of this (of all kinds of elements only {})", contents.kinds));
  const PartMesh mesh = name_file(file, [&] { return read_mesh(file, all ? std::vector<std::string>{} : chosen); });
  std::string text = mesh_line("percuss", "reads " + format_elements(mesh));
  if (!all) text += mesh_line("", fmt::format("with blocks: [{}]", fmt::join(chosen, ", ")));
  for (const std::string& note : mesh.notes) text += mesh_line("", note);
  for (const Warning& warning : mesh.warnings) text += format_warning(warning) + "\n";
  return text;
}

/// "stress" of "stress_zx".
std::string find_field(const std::string& component) {
  static const std::array<std::string_view, 9> ends{"_x", "_y", "_z", "_xx", "_yy", "_zz", "_xy", "_yz", "_zx"};
  for (const std::string_view end : ends)
    if (component.size() > end.size() && component.ends_with(end))
      return component.substr(0, component.size() - end.size());
  return component;
}

/// A line a field, components together.
std::string format_fields(const std::vector<std::string>& names, const char* place, const char* label) {
  std::vector<std::pair<std::string, int>> fields;
  for (const std::string& name : names) {
    const std::string field = find_field(name);
    if (fields.empty() || fields.back().first != field) fields.emplace_back(field, 0);
    ++fields.back().second;
  }
  std::string text;
  for (const auto& [field, components] : fields)
    text += mesh_line(
        text.empty() ? label : "",
        fmt::format("{}, of {}{}", field, place, components == 1 ? "" : fmt::format(", {} components", components)));
  return text;
}

/// Times and names of the results, if the file has some.
std::string format_results(const std::string& file) {
  ResultsContents contents;
  try {
    contents = read_results_contents(file);
  } catch (const InputError& error) {
    return mesh_line("results", fmt::format("cannot be read: {}", error.what()));
  }
  std::string text;
  const std::vector<double>& times = contents.times;
  if (!times.empty())
    text = mesh_line("times",
                     fmt::format("{}, {:.6g} to {:.6g}", count_of(static_cast<std::int64_t>(times.size()), "step"),
                                 times.front(), times.back()));
  text += format_fields(contents.node_names, "nodes", "fields");
  return text + format_fields(contents.element_names, "elements", contents.node_names.empty() ? "fields" : "");
}

}  // namespace

bool is_mesh_file(const std::string& file) {
  try {
    find_mesh_reader(file);
    return true;
  } catch (const InputError&) {
    return false;
  }
}

std::string describe_mesh_file(const std::string& file) {
  const MeshContents contents = name_file(file, [&] { return read_mesh_contents(file); });
  std::string text = mesh_line("mesh", file + ": " + contents.format);
  text += mesh_line("size", fmt::format("{}, {}", count_of(contents.elements, "element"),
                                        count_of(static_cast<std::int64_t>(contents.nodes.size()), "node")));
  text += mesh_line("extent", format_extent(contents.nodes)) + format_blocks(contents.blocks);
  text += format_sets(contents.node_sets, "node sets", "node") + format_sets(contents.side_sets, "side sets", "face");
  if (!contents.element_sets.empty()) text += format_sets(contents.element_sets, "elem. sets", "element");
  text += format_results(file);
  try {
    return text + format_reading(file, contents);
  } catch (const InputError& error) {  // what is there helps to choose blocks without what is wrong
    throw InputError(text + error.what());
  }
}

}  // namespace percuss
