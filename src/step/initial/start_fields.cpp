#include "src/step/initial/start_fields.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <string_view>

#include "comm/agreement.hpp"
#include "comm/all_reduce.hpp"
#include "comm/first_finding.hpp"
#include "kernels/core/host_copy.hpp"
#include "kernels/core/view_copy.hpp"
#include "kernels/material/laws/johnson_cook.hpp"
#include "src/deck/laws/law_traits.hpp"
#include "src/deck/laws/make_law.hpp"
#include "src/deck/laws/material_properties.hpp"
#include "src/error.hpp"
#include "src/fail_together.hpp"
#include "src/index.hpp"
#include "src/mesh/reading/results_reader.hpp"
#include "src/step/fluids/hydrostatic.hpp"
#include "src/step/initial/start_mesh_tables.hpp"
#include "src/step/initial/start_records.hpp"
#include "src/step/model/whole_mesh.hpp"

namespace percuss {
namespace {

/// Share of the longest edge of the scene below which displacements are round-off.
constexpr double noted_displacement = 1e-6;

/// Content of a file for the start.
struct LoadedFile {
  std::vector<StartPiece> pieces;
  FileDisplacement unused = {};
};

/// Rank 0 reads, all have it. Of a mesh file what it has of one place, of a table all.
LoadedFile load_file(const Deck& deck, const Communicator& ranks, const StartFieldsDeck& fields, StartPlace place) {
  std::string text;
  LoadedFile loaded;
  std::vector<int> is_mesh{0};
  fail_together(ranks, [&] {
    if (ranks.rank() != 0) return;
    is_mesh.front() = has_results_format(fields.file) ? 1 : 0;
    if (is_mesh.front() != 0) return void(loaded.pieces = read_mesh_tables(deck, fields, place, loaded.unused));
    text = read_start_file(fields.file);
    if (fields.time || !fields.take.empty())
      throw InputError(fmt::format("{}: error: {} has no effect on a table (it is of mesh files): leave it out",
                                   fields.file, fields.time ? "time" : "take"));
  });
  broadcast_values(ranks, is_mesh, 0);
  if (is_mesh.front() == 0) return {{{fields.part, parse_start_table(broadcast_text(ranks, text, 0), fields.file)}}};
  share_pieces(ranks, loaded.pieces);
  share_displacement(ranks, loaded.unused);
  return loaded;
}

/// Displacements of a file that are no round-off.
std::vector<Warning> warn_of_displacement(const Deck& deck, const Mesh& mesh, const StartFieldsDeck& fields,
                                          const FileDisplacement& unused) {
  const double size = std::max({mesh.high[0] - mesh.low[0], mesh.high[1] - mesh.low[1], mesh.high[2] - mesh.low[2]});
  if (!(unused.largest > noted_displacement * size)) return {};
  return {{"unused_displacement",
           fmt::format("the displacements of {} are not used, '{}' reaches {:.6g} (stresses and velocities go onto the "
                       "mesh of the deck, which is not deformed): use a mesh of the deformed shape with its stresses, "
                       "or silence this rule if hardly anything has bent or turned",
                       fields.file, unused.name, unused.largest),
           deck.where(fields.place), 0, 1}};
}

/// The rows of an id.
struct TableRows {
  int first = 0, last = 0;
  bool any() const { return first < last; }
};

TableRows find_rows(const StartTable& table, std::int64_t id) {
  const auto [first, last] = std::equal_range(table.ids.begin(), table.ids.end(), id);
  return {static_cast<int>(first - table.ids.begin()), static_cast<int>(last - table.ids.begin())};
}

/// "s.csv:12" or, of a mesh file, its name.
std::string name_row(const StartFieldsDeck& fields, const StartTable& table, int row) {
  const int line = table.lines[at(row)];
  return line > 0 ? fmt::format("{}:{}", fields.file, line) : fields.file;
}

bool is_row_of_zeros(const StartTable& table, int row) {
  return std::all_of(table.row(row), table.row(row) + table.columns, [](double value) { return value == 0; });
}

/// Throws, on all ranks, unless each row is of one element or node. hits: [rows] those of this rank.
void require_each_once(const Communicator& ranks, const StartFieldsDeck& fields, const StartPiece& piece,
                       std::vector<int> hits) {
  all_reduce(ranks, Reduce::sum, hits);
  const auto other = std::find_if(hits.begin(), hits.end(), [](int count) { return count != 1; });
  if (other == hits.end()) return;
  const auto row = static_cast<int>(other - hits.begin());
  const std::string what = fmt::format("{} {}", piece.table.is_of_nodes ? "node" : "element", piece.table.ids[at(row)]);
  throw InputError(fmt::format(
      "{}: error: {} {}", name_row(fields, piece.table, row), *other == 0 ? "there is no " + what : what,
      *other == 0 ? (piece.part.empty() ? "in the mesh" : fmt::format("in part '{}'", piece.part))
                  : fmt::format("is there {} times (parts have ids of their own): give the key part", *other)));
}

bool is_of_part(const Deck& deck, const StartPiece& piece, int part) {
  return piece.part.empty() || deck.parts[at(part)].name == piece.part;
}

const MaterialDeck& find_material(const Deck& deck, const PartDeck& part) {
  return *std::find_if(deck.materials.begin(), deck.materials.end(),
                       [&](const MaterialDeck& material) { return material.name == part.material; });
}

/// Quantities that files have given an element, as bits.
int list_quantities(const StartTable& table) {
  return (table.stress != StartTable::absent ? 1 : 0) | (table.plastic_strain != StartTable::absent ? 2 : 0) |
         (table.temperature != StartTable::absent ? 4 : 0);
}

const char* name_quantity(int bits) {
  return (bits & 1) != 0 ? "stress" : (bits & 2) != 0 ? "plastic strain" : "temperature";
}

/// The first quantity of a table.
const char* name_quantity(const StartTable& table) { return name_quantity(list_quantities(table)); }

/// A temperature must be one that start_temperature of the deck could be.
std::string find_obstacle_to(double temperature, const MaterialDeck& material) {
  if (material.law.model != JohnsonCook::name) return "";
  JohnsonCook law = find_constants<JohnsonCook>(material.law);
  law.start_temperature = temperature;
  std::string_view fault = law.find_fault();
  if (fault.empty() && material.equation_of_state) fault = law.find_fault_with_state();
  if (fault.empty()) return "";
  return fmt::format("begins with the temperature {:g}, which gives its material '{}' {}", temperature, material.name,
                     fault);
}

/// Why an element cannot have what a file gives it; empty: its record tells.
std::string find_obstacle(const Deck& deck, const PartDeck& part, const StartTable& table, const StartRow& row) {
  if (part.rigid) return fmt::format("is rigid and has no {}", name_quantity(table));
  const MaterialDeck& material = find_material(deck, part);
  if (table.stress != StartTable::absent && !grows_in_increments(material))
    return fmt::format(
        "is of material '{}' (whose stress does not grow in increments): use elastic or a plastic law "
        "without an equation of state",
        material.name);
  return row.temperature == nullptr ? "" : find_obstacle_to(*row.temperature, material);
}

StartRow read_row(const StartTable& table, int row) {
  const auto value = [&](int first) { return first == StartTable::absent ? nullptr : table.row(row) + first; };
  return {table.layers[at(row)], value(table.stress), value(table.plastic_strain), value(table.temperature)};
}

/// Receivers of a state from files.
struct StartTarget {
  const Deck& deck;
  const ChunkedMesh& chunked;
  const Model& model;
  State& state;
  StartRecords records;
  decltype(to_host(std::declval<const WorkRows&>())) work;
  std::vector<int> given;             // [elements] list_quantities() of the files so far
  std::vector<LameConstants> moduli;  // by part
};

/// Sets what a table has of this rank's elements.
class TableSetter {
 public:
  TableSetter(const StartFieldsDeck& fields, const StartPiece& piece, StartTarget& target)
      : fields_(fields), piece_(piece), table_(piece.table), target_(target), hits_(table_.ids.size(), 0) {}

  void set_chunk(int c) {
    const Chunk& chunk = target_.chunked.chunks[at(c)];
    if (!is_of_part(target_.deck, piece_, chunk.part)) return;
    for (int e = chunk.first_element; e < chunk.first_element + chunk.element_count; ++e)
      set_element({c, e, target_.moduli[at(chunk.part)]}, target_.deck.parts[at(chunk.part)]);
  }

  /// Collective. Throws InputError, the same on all ranks.
  void finish() {
    const Communicator& ranks = target_.model.ranks;
    require_each_once(ranks, fields_, piece_, hits_);
    if (const auto refused = agree_on_first(ranks, obstacle_row_, obstacle_)) throw InputError(*refused);
  }

 private:
  void set_element(const StartElement& of, const PartDeck& part) {
    const TableRows rows = find_rows(table_, target_.chunked.mesh.element_ids[at(of.element)]);
    if (!rows.any()) return;
    int& given = target_.given[at(of.element)];
    const int twice = given & list_quantities(table_);
    given |= list_quantities(table_);
    for (int r = rows.first; r < rows.last; ++r) {
      hits_[at(r)] += 1;
      const StartRow row = read_row(table_, r);
      double energy = 0;
      std::string why = twice != 0 ? fmt::format("has a {} from another file", name_quantity(twice))
                                   : find_obstacle(target_.deck, part, table_, row);
      if (why.empty()) why = target_.records.write(of, row, energy);
      if (!why.empty() && table_.is_of_mesh && (part.rigid || is_row_of_zeros(table_, r))) continue;
      if (!why.empty() && r < obstacle_row_) {
        obstacle_row_ = r;
        obstacle_ = fmt::format("{}: error: element {} {}", name_row(fields_, table_, r), table_.ids[at(r)], why);
      }
      target_.work(at(of.chunk), 0) += energy;
    }
  }

  const StartFieldsDeck& fields_;
  const StartPiece& piece_;
  const StartTable& table_;
  StartTarget& target_;
  std::vector<int> hits_;
  std::int64_t obstacle_row_ = no_finding;
  std::string obstacle_;
};

/// Gives fluids at rest their pressure.
void press_fluids(StartTarget& target) {
  const ChunkedMesh& chunked = target.chunked;
  for (std::size_t c = 0; c < chunked.chunks.size(); ++c) {
    const int first = chunked.chunks[c].first_element, end = first + chunked.chunks[c].element_count;
    for (int e = first; e < end; ++e)
      if (const auto pressed = find_hydrostatic_state(target.deck, chunked.mesh, at(e)))
        target.work(c, 0) += target.records.press({static_cast<int>(c), e, {}}, *pressed);
  }
}

/// velocity, is_rigid: as of set_start_velocities().
void set_velocities_of(const Deck& deck, const ChunkedMesh& chunked, const StartFieldsDeck& fields,
                       const StartPiece& piece, const std::vector<char>& is_rigid, std::vector<Vec3>& velocity) {
  const Mesh& mesh = chunked.mesh;
  const Communicator ranks = find_ranks(mesh);
  const StartTable& table = piece.table;
  std::vector<int> hits(table.ids.size(), 0);
  int rigid = std::numeric_limits<int>::max();
  for (const int node : select_nodes(mesh, deck, {piece.part, {}, fields.place})) {
    const TableRows rows = find_rows(table, mesh.node_ids[at(node)]);
    if (!rows.any()) continue;
    const int row = rows.first;
    if (owns_node(chunked, node)) hits[at(row)] += 1;
    if (is_rigid[at(node)] != 0 && table.is_of_mesh && is_row_of_zeros(table, row)) continue;
    if (is_rigid[at(node)] != 0) rigid = std::min(rigid, row);
    for (std::size_t k = 0; k < 3; ++k) velocity[at(node)][k] = table.row(row)[k];
  }
  require_each_once(ranks, fields, piece, hits);
  all_reduce(ranks, Reduce::least, rigid);
  if (rigid != std::numeric_limits<int>::max())
    throw InputError(fmt::format("{}: error: node {} is of a rigid body (whose velocity initial gives)",
                                 name_row(fields, table, rigid), table.ids[at(rigid)]));
}

}  // namespace

void set_start_velocities(const Deck& deck, const ChunkedMesh& chunked, const std::vector<char>& is_rigid,
                          std::vector<Vec3>& velocity) {
  for (const StartFieldsDeck& fields : deck.start.fields) {
    for (const StartPiece& piece : load_file(deck, find_ranks(chunked.mesh), fields, StartPlace::nodes).pieces)
      if (piece.table.is_of_nodes) set_velocities_of(deck, chunked, fields, piece, is_rigid, velocity);
  }
}

std::vector<Warning> set_start_states(const Deck& deck, const ChunkedMesh& chunked, const Model& model, State& state) {
  std::vector<Warning> warnings;
  if (deck.start.fields.empty() && deck.start.hydrostatic.empty()) return warnings;
  StartTarget target{deck,
                     chunked,
                     model,
                     state,
                     StartRecords(chunked.mesh, model, state),
                     to_host(state.results.work),
                     std::vector<int>(chunked.mesh.element_ids.size(), 0),
                     {}};
  for (const PartDeck& part : deck.parts) target.moduli.push_back(find_moduli(find_material(deck, part)));
  for (const StartFieldsDeck& fields : deck.start.fields) {
    const LoadedFile loaded = load_file(deck, model.ranks, fields, StartPlace::elements);
    for (Warning& warning : warn_of_displacement(deck, chunked.mesh, fields, loaded.unused))
      warnings.push_back(std::move(warning));
    for (const StartPiece& piece : loaded.pieces) {
      if (piece.table.is_of_nodes) continue;
      TableSetter setter(fields, piece, target);
      for (std::size_t c = 0; c < chunked.chunks.size(); ++c) setter.set_chunk(static_cast<int>(c));
      setter.finish();
    }
  }
  press_fluids(target);
  target.records.give_back(state);
  copy_values(state.results.work, target.work);
  return warnings;
}

}  // namespace percuss
