#include "src/step/initial/start_records.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "kernels/core/common_record.hpp"
#include "kernels/core/small_space.hpp"
#include "kernels/element/element_records.hpp"
#include "kernels/shell/shell_geometry.hpp"
#include "kernels/shell/shell_hourglass.hpp"
#include "kernels/shell/shell_record.hpp"
#include "kernels/tet/tet_chunks.hpp"
#include "src/index.hpp"
#include "src/mesh/hex_geometry.hpp"

namespace percuss {
namespace {

/// Stress across a shell that is round-off of its file, relative to the largest component, or of a turn that does not
/// matter, relative to the shear modulus.
constexpr double negligible_across = 1e-3, negligible_turned = 3e-6;
constexpr int shear_place = 3;  // ShellState::shear

/// Elastic energy of a stress per volume: (s:s - lambda / (3 lambda + 2 mu) (tr s)^2) / 4 mu.
double find_energy(const LameConstants& moduli, const double* s) {
  const double trace = s[0] + s[1] + s[2];
  double square = 0;
  for (int k = 0; k < 6; ++k) square += (k < 3 ? 1 : 2) * s[k] * s[k];
  return (square - moduli.lambda / (3 * moduli.lambda + 2 * moduli.mu) * trace * trace) / (4 * moduli.mu);
}

/// The mid-surface of a shell at time 0, and what it keeps of its stiffness in transverse shear.
struct ShellPlace {
  Matrix3<double> frame;
  double area, shear_modulus;
};

ShellPlace find_place(const Mesh& mesh, std::size_t element, double thickness, double shear_modulus) {
  const auto nodes = mesh.elements.kernel_nodes(element);
  Vector3<double> corners[4];
  for (std::size_t k = 0; k < 4; ++k) {
    const Vec3& x = mesh.nodes[at(nodes[k])];
    corners[k] = {x[0], x[1], x[2]};
  }
  const MixedShapes<bool> shapes{mesh.corners(element).size() == 3};
  const ShellGeometry<double> g = find_shell_geometry(find_differences(corners), shapes);
  return {g.frame, g.area, shell_shear_correction * find_shear_share(g, thickness, shapes) * shear_modulus};
}

double find_largest(const double* s) {
  double largest = 0;
  for (int k = 0; k < 6; ++k) largest = std::max(largest, std::abs(s[k]));
  return largest;
}

KOKKOS_INLINE_FUNCTION bool keeps_volume(ElementFamily family) {
  return family == ElementFamily::tetrahedra || family == ElementFamily::wedges || family == ElementFamily::pyramids;
}

Array<RecordLayout> find_layouts(const ElementChunks& chunks) {
  const Array<RecordLayout> layouts("percuss::record_layouts", at(chunks.count));
  parallel_for(
      "percuss::find_record_layouts", RangeOf(ExecSpace(), 0, chunks.count), KOKKOS_LAMBDA(const int c) {
        layouts(c) = {chunks.points(c),
                      is_shell(chunks, c) ? find_layer_size(chunks, c) : 0,
                      chunks.find_scalar(c, HistoryScalar::equivalent_plastic_strain),
                      chunks.find_scalar(c, HistoryScalar::temperature),
                      chunks.find_scalar(c, HistoryScalar::internal_energy),
                      keeps_volume(find_family(chunks, c)) ? TetRecord::log_volume : -1};
      });
  ExecSpace().fence();
  return layouts;
}

}  // namespace

StartRecords::StartRecords(const Mesh& mesh, const Model& model, const State& state)
    : mesh_(mesh),
      chunks_(model.chunks),
      layouts_(to_host(find_layouts(model.chunks))),
      records_(to_host(state.elements)) {}

StartRecords::Lanes StartRecords::find_lanes(const StartElement& of) const {
  const int i = of.element - chunks_.first_element(of.chunk);
  return {i, find_lane_end(chunks_, of.chunk, i)};
}

void StartRecords::set(const StartElement& of, int place, double value) {
  const auto [first, last] = find_lanes(of);
  for (int lane = first; lane < last; ++lane)
    find_record(chunks_, records_, of.chunk, lane)[place] = static_cast<Real>(value);
}

double StartRecords::get(const StartElement& of, int place) const {
  return find_record(chunks_, records_, of.chunk, find_lanes(of).first).get(place);
}

std::string StartRecords::find_obstacle(const StartElement& of, const StartRow& row) const {
  const std::int64_t layer = row.layer;
  const int dimension = mesh_.topology_of(at(of.element)).dimension, points = layout(of).points;
  if (dimension == 1)
    return fmt::format("is a beam (beams take no {} from files)", row.stress != nullptr           ? "stress"
                                                                  : row.plastic_strain != nullptr ? "plastic strain"
                                                                                                  : "temperature");
  if (dimension == 3 && layer > 0) return "is no shell and has no layers: leave out the column layer";
  if (layer > points) return fmt::format("has no layer {} (it has {})", layer, points);
  return "";
}

std::string StartRecords::set_history(const StartElement& of, HistoryScalar name, std::int64_t layer, double value) {
  const RecordLayout& of_chunk = layout(of);
  const int place = name == HistoryScalar::temperature ? of_chunk.temperature : of_chunk.plastic_strain;
  if (place < 0 && name == HistoryScalar::equivalent_plastic_strain && value == 0) return "";
  if (place < 0)
    return fmt::format("has a {} (its material has none)",
                       name == HistoryScalar::temperature ? "temperature" : "plastic strain");
  const int apart = std::max(1, of_chunk.layer_size);
  for (int p = 0; p < of_chunk.points; ++p)
    if (layer == 0 || layer == p + 1) set(of, place + p * apart, value);
  return "";
}

double StartRecords::set_solid_stress(const StartElement& of, const double* stress) {
  for (int p = 0; p < layout(of).points; ++p)
    for (int k = 0; k < 6; ++k) set(of, SolidRecord::stress + 6 * p + k, stress[k]);
  return find_element_volume(mesh_, at(of.element)) * find_energy(of.moduli, stress);
}

/// Sets stresses in the frame of the shell: each layer has its stress in the plane, the shear across is the mean of all
/// layers.
std::string StartRecords::set_shell_stress(const StartElement& of, const StartRow& row, double& energy) {
  const double thickness = get(of, ShellRecord::thickness);
  const ShellPlace place = find_place(mesh_, at(of.element), thickness, of.moduli.mu);
  const double* const g = row.stress;
  const Symmetric3<double> s = push_forward(place.frame, Symmetric3<double>{g[0], g[1], g[2], g[3], g[4], g[5]});
  if (std::abs(s.zz) > std::max(negligible_across * find_largest(g), negligible_turned * of.moduli.mu))
    return fmt::format(
        "has the stress {:.4g} across its surface (shells have none): is the file of a shape that has "
        "turned since time 0?",
        s.zz);
  const ThicknessPoints rule = find_thickness_points(layout(of).points);
  const int size = layout(of).layer_size;
  const double volume = place.area * thickness, in_plane[6] = {s.xx, s.yy, 0, s.xy, 0, 0};
  double weight = 0;
  for (int p = 0; p < rule.count; ++p) {
    if (row.layer > 0 && row.layer != p + 1) continue;
    const int layer = ShellRecord::layers + size * p;
    set(of, layer, s.xx);
    set(of, layer + 1, s.yy);
    set(of, layer + 2, s.xy);
    weight += rule.weight[p];
  }
  energy = weight * volume * find_energy(of.moduli, in_plane);
  const double across[2] = {s.zx, s.yz};
  for (int k = 0; k < 2; ++k) {
    const double before = get(of, shear_place + k), now = before + weight * across[k];
    set(of, shear_place + k, now);
    energy += volume * (now * now - before * before) / (2 * place.shear_modulus);
  }
  return "";
}

double StartRecords::press(const StartElement& of, const PressedFluid& pressed) {
  const int points = layout(of).points, energy = layout(of).internal_energy, log_volume = layout(of).log_volume;
  const double before = get(of, energy);
  for (int p = 0; p < points; ++p) {
    set(of, energy + p, pressed.energy);
    set(of, energy + points + p, pressed.j);  // start_state()
  }
  if (log_volume >= 0) set(of, log_volume, std::log(pressed.j));
  return (pressed.energy - before) * find_element_volume(mesh_, at(of.element)) / pressed.j;
}

std::string StartRecords::write(const StartElement& of, const StartRow& row, double& energy) {
  energy = 0;
  std::string why = find_obstacle(of, row);
  if (why.empty() && row.plastic_strain != nullptr)
    why = set_history(of, HistoryScalar::equivalent_plastic_strain, row.layer, *row.plastic_strain);
  if (why.empty() && row.temperature != nullptr)
    why = set_history(of, HistoryScalar::temperature, row.layer, *row.temperature);
  if (!why.empty() || row.stress == nullptr) return why;
  if (layout(of).layer_size > 0) return set_shell_stress(of, row, energy);
  energy = set_solid_stress(of, row.stress);
  return "";
}

}  // namespace percuss
