#include "src/step/start/start_fields.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "comm/agreement.hpp"
#include "comm/all_reduce.hpp"
#include "comm/first_finding.hpp"
#include "kernels/core/host_copy.hpp"
#include "src/deck/make_material.hpp"
#include "src/error.hpp"
#include "src/fail_together.hpp"
#include "src/index.hpp"
#include "src/mesh/hex_geometry.hpp"
#include "src/step/model/pack_width.hpp"
#include "src/step/model/whole_mesh.hpp"
#include "src/step/start/start_file.hpp"

namespace percuss {
namespace {

/// Rank 0 reads, all parse.
StartTable load_table(const Communicator& ranks, const std::string& path) {
  std::string text;
  fail_together(ranks, [&] {
    if (ranks.rank() == 0) text = read_start_file(path);
  });
  return parse_start_table(broadcast_text(ranks, text, 0), path);
}

/// The row of an id; -1: there is none.
int find_row(const StartTable& table, std::int64_t id) {
  const auto found = std::lower_bound(table.ids.begin(), table.ids.end(), id);
  return found != table.ids.end() && *found == id ? static_cast<int>(found - table.ids.begin()) : -1;
}

/// Throws, on all ranks, unless each row is of one element or node. hits: [rows] those of this rank.
void require_each_once(const Communicator& ranks, const StartFieldsDeck& fields, const StartTable& table,
                       std::vector<int> hits) {
  all_reduce(ranks, Reduce::sum, hits);
  const auto other = std::find_if(hits.begin(), hits.end(), [](int count) { return count != 1; });
  if (other == hits.end()) return;
  const auto row = static_cast<std::size_t>(other - hits.begin());
  const std::string what = fmt::format("{} {}", table.is_of_nodes ? "node" : "element", table.ids[row]);
  throw InputError(fmt::format(
      "{}:{}: error: {} {}", fields.file, table.lines[row], *other == 0 ? "there is no " + what : what,
      *other == 0 ? (fields.part.empty() ? "in the mesh" : fmt::format("in part '{}'", fields.part))
                  : fmt::format("is there {} times (parts have ids of their own): give the key part", *other)));
}

bool is_of_part(const Deck& deck, const StartFieldsDeck& fields, int part) {
  return fields.part.empty() || deck.parts[at(part)].name == fields.part;
}

const MaterialDeck& find_material(const Deck& deck, const PartDeck& part) {
  return *std::find_if(deck.materials.begin(), deck.materials.end(),
                       [&](const MaterialDeck& material) { return material.name == part.material; });
}

/// Why an element cannot have a stress; empty: it can.
std::string find_obstacle(const Deck& deck, const Mesh& mesh, std::size_t element) {
  if (mesh.topology_of(element).dimension != 3) return "is no solid (shells and beams begin without stress)";
  const PartDeck& part = deck.parts[at(mesh.part_of(element))];
  if (part.rigid) return "is rigid and has no stress";
  const MaterialDeck& material = find_material(deck, part);
  if (grows_in_increments(material)) return "";
  return fmt::format(
      "is of material '{}' (whose stress does not grow in increments): use elastic or a plastic law "
      "without an equation of state",
      material.name);
}

/// Elastic energy of a stress per volume: (s:s - lambda / (3 lambda + 2 mu) (tr s)^2) / 4 mu.
double find_energy(const LameConstants& moduli, const double* s) {
  const double trace = s[0] + s[1] + s[2];
  double square = 0;
  for (int k = 0; k < 6; ++k) square += (k < 3 ? 1 : 2) * s[k] * s[k];
  return (square - moduli.lambda / (3 * moduli.lambda + 2 * moduli.mu) * trace * trace) / (4 * moduli.mu);
}

/// The records of elements on the host, of which each has its place in a chunk.
class RecordWriter {
 public:
  RecordWriter(const Model& model, const State& state)
      : model_(model), first_element_(to_host(model.chunks.first_element)), records_(to_host(state.elements)) {}

  /// Lanes past the last element of a chunk repeat it. values: a row of the table. Returns whether there is a place for
  /// all of them.
  bool write(int chunk, int element, const double* values, bool has_plastic_strain) {
    const HexChunks& chunks = model_.chunks;
    const auto c = static_cast<std::size_t>(chunk);
    const int size = chunks.record_size(chunk), points = chunks.points(chunk);
    const int count = first_element_(c + 1) - first_element_(c), i = element - first_element_(c);
    const int lanes = (chunks.first_pack(chunk + 1) - chunks.first_pack(chunk)) * pack_width;
    const int strain = chunks.find_scalar(chunk, HistoryScalar::equivalent_plastic_strain);
    if (has_plastic_strain && values[6] > 0 && strain < 0) return false;
    for (int lane = i; lane < (i + 1 < count ? i + 1 : lanes); ++lane) {
      Real* const record =
          &records_(chunks.first_state(chunk)) + lane / pack_width * size * pack_width + lane % pack_width;
      for (int p = 0; p < points; ++p) {
        for (int k = 0; k < 6; ++k) record[(HexRecord::stress + 6 * p + k) * pack_width] = static_cast<Real>(values[k]);
        if (has_plastic_strain && strain >= 0) record[(strain + p) * pack_width] = static_cast<Real>(values[6]);
      }
    }
    return true;
  }

  void give_back(const State& state) const { Kokkos::deep_copy(state.elements, records_); }

 private:
  const Model& model_;
  decltype(to_host(std::declval<const Array<int>&>())) first_element_;
  decltype(to_host(std::declval<const Array<Real>&>())) records_;
};

/// What gets stresses from files.
struct StressTarget {
  const Deck& deck;
  const ChunkedMesh& chunked;
  const Model& model;
  State& state;
  std::vector<char> is_set;  // [elements] whether a file has given a stress
};

void set_stresses_of(const StartFieldsDeck& fields, const StartTable& table, StressTarget& target) {
  auto& [deck, chunked, model, state, is_set] = target;
  const Mesh& mesh = chunked.mesh;
  RecordWriter records(model, state);
  const auto work = to_host(state.results.work);
  std::vector<LameConstants> moduli;
  for (const PartDeck& part : deck.parts) moduli.push_back(find_moduli(find_material(deck, part)));
  std::vector<int> hits(table.ids.size(), 0);
  std::int64_t obstacle_row = no_finding;
  std::string obstacle;
  for (std::size_t c = 0; c < chunked.chunks.size(); ++c) {
    const Chunk& chunk = chunked.chunks[c];
    if (!is_of_part(deck, fields, chunk.part)) continue;
    for (int e = chunk.first_element; e < chunk.first_element + chunk.element_count; ++e) {
      const int row = find_row(table, mesh.element_ids[at(e)]);
      if (row < 0) continue;
      hits[at(row)] += 1;
      const double* const values = &table.values[at(row * table.columns())];
      std::string why = is_set[at(e)] != 0 ? "has a stress from another file" : find_obstacle(deck, mesh, at(e));
      is_set[at(e)] = 1;
      if (why.empty() && !records.write(static_cast<int>(c), e, values, table.has_plastic_strain))
        why = "has a plastic strain (its material has none)";
      if (!why.empty() && row < obstacle_row) {
        obstacle_row = row;
        obstacle =
            fmt::format("{}:{}: error: element {} {}", fields.file, table.lines[at(row)], table.ids[at(row)], why);
      }
      if (!why.empty()) continue;
      work(c, 0) += find_element_volume(mesh, at(e)) * find_energy(moduli[at(chunk.part)], values);
    }
  }
  require_each_once(model.ranks, fields, table, hits);
  if (const auto refused = agree_on_first(model.ranks, obstacle_row, obstacle)) throw InputError(*refused);
  records.give_back(state);
  Kokkos::deep_copy(state.results.work, work);
}

}  // namespace

void set_start_velocities(const Deck& deck, const ChunkedMesh& chunked, const std::vector<char>& is_rigid,
                          std::vector<Vec3>& velocity) {
  const Mesh& mesh = chunked.mesh;
  const Communicator ranks = find_ranks(mesh);
  for (const StartFieldsDeck& fields : deck.start.fields) {
    const StartTable table = load_table(ranks, fields.file);
    if (!table.is_of_nodes) continue;
    std::vector<int> hits(table.ids.size(), 0);
    int rigid = std::numeric_limits<int>::max();
    const std::vector<int> nodes = select_nodes(mesh, deck, {fields.part, {}, fields.place});
    for (const int node : nodes) {
      const int row = find_row(table, mesh.node_ids[at(node)]);
      if (row < 0) continue;
      if (owns_node(chunked, node)) hits[at(row)] += 1;
      if (is_rigid[at(node)] != 0) rigid = std::min(rigid, row);
      for (std::size_t k = 0; k < 3; ++k) velocity[at(node)][k] = table.values[at(3 * row) + k];
    }
    require_each_once(ranks, fields, table, hits);
    all_reduce(ranks, Reduce::least, rigid);
    if (rigid != std::numeric_limits<int>::max())
      throw InputError(fmt::format("{}:{}: error: node {} is of a rigid body (whose velocity initial gives)",
                                   fields.file, table.lines[at(rigid)], table.ids[at(rigid)]));
  }
}

void set_start_stresses(const Deck& deck, const ChunkedMesh& chunked, const Model& model, State& state) {
  StressTarget target{deck, chunked, model, state, std::vector<char>(chunked.mesh.element_ids.size(), 0)};
  for (const StartFieldsDeck& fields : deck.start.fields) {
    const StartTable table = load_table(model.ranks, fields.file);
    if (!table.is_of_nodes) set_stresses_of(fields, table, target);
  }
}

}  // namespace percuss
