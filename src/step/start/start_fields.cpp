#include "src/step/start/start_fields.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <string_view>

#include "comm/agreement.hpp"
#include "comm/all_reduce.hpp"
#include "comm/first_finding.hpp"
#include "kernels/core/host_copy.hpp"
#include "src/deck/make_material.hpp"
#include "src/error.hpp"
#include "src/fail_together.hpp"
#include "src/index.hpp"
#include "src/step/model/whole_mesh.hpp"
#include "src/step/start/start_file.hpp"
#include "src/step/start/start_records.hpp"

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

/// The rows of an id.
struct Rows {
  int first = 0, last = 0;
  bool any() const { return first < last; }
};

Rows find_rows(const StartTable& table, std::int64_t id) {
  const auto [first, last] = std::equal_range(table.ids.begin(), table.ids.end(), id);
  return {static_cast<int>(first - table.ids.begin()), static_cast<int>(last - table.ids.begin())};
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

/// What gets its state from files.
struct StartTarget {
  const Deck& deck;
  const ChunkedMesh& chunked;
  const Model& model;
  State& state;
  std::vector<int> given;             // [elements] list_quantities() of the files so far
  std::vector<LameConstants> moduli;  // by part
};

/// Sets what a table has of this rank's elements.
class TableSetter {
 public:
  TableSetter(const StartFieldsDeck& fields, const StartTable& table, StartTarget& target)
      : fields_(fields),
        table_(table),
        target_(target),
        records_(target.chunked.mesh, target.model, target.state),
        work_(to_host(target.state.results.work)),
        hits_(table.ids.size(), 0) {}

  void set_chunk(int c) {
    const Chunk& chunk = target_.chunked.chunks[at(c)];
    if (!is_of_part(target_.deck, fields_, chunk.part)) return;
    for (int e = chunk.first_element; e < chunk.first_element + chunk.element_count; ++e)
      set_element({c, e, target_.moduli[at(chunk.part)]}, target_.deck.parts[at(chunk.part)]);
  }

  /// Collective. Throws InputError, the same on all ranks.
  void finish() {
    const Communicator& ranks = target_.model.ranks;
    require_each_once(ranks, fields_, table_, hits_);
    if (const auto refused = agree_on_first(ranks, obstacle_row_, obstacle_)) throw InputError(*refused);
    records_.give_back(target_.state);
    Kokkos::deep_copy(target_.state.results.work, work_);
  }

 private:
  void set_element(const StartElement& of, const PartDeck& part) {
    const Rows rows = find_rows(table_, target_.chunked.mesh.element_ids[at(of.element)]);
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
      if (why.empty()) why = records_.write(of, row, energy);
      if (!why.empty() && r < obstacle_row_) {
        obstacle_row_ = r;
        obstacle_ =
            fmt::format("{}:{}: error: element {} {}", fields_.file, table_.lines[at(r)], table_.ids[at(r)], why);
      }
      work_(at(of.chunk), 0) += energy;
    }
  }

  const StartFieldsDeck& fields_;
  const StartTable& table_;
  StartTarget& target_;
  StartRecords records_;
  decltype(to_host(std::declval<const WorkRows&>())) work_;
  std::vector<int> hits_;
  std::int64_t obstacle_row_ = no_finding;
  std::string obstacle_;
};

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
      const Rows rows = find_rows(table, mesh.node_ids[at(node)]);
      if (!rows.any()) continue;
      const int row = rows.first;
      if (owns_node(chunked, node)) hits[at(row)] += 1;
      if (is_rigid[at(node)] != 0) rigid = std::min(rigid, row);
      for (std::size_t k = 0; k < 3; ++k) velocity[at(node)][k] = table.row(row)[k];
    }
    require_each_once(ranks, fields, table, hits);
    all_reduce(ranks, Reduce::least, rigid);
    if (rigid != std::numeric_limits<int>::max())
      throw InputError(fmt::format("{}:{}: error: node {} is of a rigid body (whose velocity initial gives)",
                                   fields.file, table.lines[at(rigid)], table.ids[at(rigid)]));
  }
}

void set_start_states(const Deck& deck, const ChunkedMesh& chunked, const Model& model, State& state) {
  if (deck.start.fields.empty()) return;
  StartTarget target{deck, chunked, model, state, std::vector<int>(chunked.mesh.element_ids.size(), 0), {}};
  for (const PartDeck& part : deck.parts) target.moduli.push_back(find_moduli(find_material(deck, part)));
  for (const StartFieldsDeck& fields : deck.start.fields) {
    const StartTable table = load_table(model.ranks, fields.file);
    if (table.is_of_nodes) continue;
    TableSetter setter(fields, table, target);
    for (std::size_t c = 0; c < chunked.chunks.size(); ++c) setter.set_chunk(static_cast<int>(c));
    setter.finish();
  }
}

}  // namespace percuss
