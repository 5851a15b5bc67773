#include "src/step/initial/start_mesh_tables.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <set>
#include <span>
#include <utility>

#include "comm/agreement.hpp"
#include "kernels/shell/thickness_points.hpp"
#include "src/error.hpp"
#include "src/index.hpp"
#include "src/mesh/reading/results_reader.hpp"

namespace percuss {
namespace {

/// Squares of more are no numbers.
constexpr double largest_value = 1e100;

/// A quantity that a file may have.
struct NamedQuantity {
  StartQuantity quantity;
  const char* name;
  int components;
  int StartTable::*column;  // of its first component; of nodes none
};
constexpr std::array<NamedQuantity, 4> named_quantities{
    {{StartQuantity::stress, "stress", 6, &StartTable::stress},
     {StartQuantity::plastic_strain, "equivalent_plastic_strain", 1, &StartTable::plastic_strain},
     {StartQuantity::temperature, "temperature", 1, &StartTable::temperature},
     {StartQuantity::velocity, "velocity", 3, nullptr}}};

bool is_of_nodes(const NamedQuantity& of) { return of.column == nullptr; }

std::vector<std::string> list_components(const NamedQuantity& of, int layer = 0) {
  return name_result_components(layer > 0 ? fmt::format("{}_point_{}", of.name, layer) : of.name, of.components);
}

bool contains_all(const std::vector<std::string>& names, const std::vector<std::string>& wanted) {
  return std::all_of(wanted.begin(), wanted.end(), [&](const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
  });
}

std::string list_or_none(const std::vector<std::string>& names) {
  constexpr std::size_t most = 40;
  if (names.empty()) return "none";
  const std::vector<std::string> shown(names.begin(),
                                       names.begin() + static_cast<std::ptrdiff_t>(std::min(names.size(), most)));
  return fmt::format("{}{}", fmt::join(shown, ", "), names.size() > most ? ", ..." : "");
}

/// Names that percuss and other programs give to the components of displacements.
std::vector<std::string> list_displacement_names() {
  std::vector<std::string> names;
  for (const char* stem : {"displacement", "Displacement", "disp", "Disp", "DISP", "displ", "DISPL", "U", "u"})
    for (const char* gap : {"_", ""})
      for (const char* axis : {"x", "y", "z", "X", "Y", "Z"}) names.push_back(fmt::format("{}{}{}", stem, gap, axis));
  return names;
}

class MeshTables {
 public:
  MeshTables(const Deck& deck, const StartFieldsDeck& fields, StartPlace place)
      : deck_(deck), fields_(fields), place_(place) {
    ResultsWish wish;
    wish.time = fields.time;
    for (const NamedQuantity& of : named_quantities) {
      if (!is_taken(of) || is_of_nodes(of) != (place == StartPlace::nodes)) continue;
      auto& names = is_of_nodes(of) ? wish.of_nodes : wish.of_elements;
      for (int layer = 0;
           layer <= (of.quantity == StartQuantity::temperature || is_of_nodes(of) ? 0 : most_thickness_points); ++layer)
        for (std::string& name : list_components(of, layer)) names.push_back(std::move(name));
    }
    if (place == StartPlace::elements) wish.of_nodes = list_displacement_names();
    results_ = read_file_results(fields.file, wish);
  }

  /// Displacements of the nodes; what is not a number says nothing.
  FileDisplacement find_displacement() const {
    FileDisplacement found;
    if (place_ != StartPlace::elements) return found;
    for (const auto& [name, column] : results_.of_nodes) {
      for (const double value : column.values) {
        if (!(std::abs(value) > found.largest)) continue;
        found = {name, std::abs(value)};
      }
    }
    return found;
  }

  std::vector<StartPiece> list() {
    require_quantities();
    std::vector<StartPiece> pieces;
    for (std::size_t b = 0; b < results_.blocks.size(); ++b) {
      const std::string named = find_part(results_.blocks[b].name);
      if (!named.empty() && !fields_.part.empty() && named != fields_.part) continue;
      if (results_.blocks[b].elements == 0 || (named.empty() && has_block_of_part())) continue;
      for (const NamedQuantity& of : named_quantities) {
        if (!is_taken(of) || is_of_nodes(of) != (place_ == StartPlace::nodes)) continue;
        StartTable table = is_of_nodes(of) ? make_node_table(b) : make_element_table(b, of);
        if (table.ids.empty()) continue;
        sort_rows(table);
        pieces.push_back({named.empty() ? fields_.part : named, std::move(table)});
      }
    }
    return pieces;
  }

 private:
  [[noreturn]] void refuse(const std::string& what) const {
    throw InputError(fmt::format("{}: error: {}", fields_.file, what));
  }

  bool is_taken(const NamedQuantity& of) const {
    return fields_.take.empty() ||
           std::find(fields_.take.begin(), fields_.take.end(), of.quantity) != fields_.take.end();
  }

  /// The part that a block is called by: "can", or "can quad4" of a part of several kinds.
  std::string find_part(const std::string& block) const {
    for (const PartDeck& part : deck_.parts)
      if (block == part.name || block.starts_with(part.name + " ")) return part.name;
    return "";
  }

  bool has_block_of_part() const {
    return !fields_.part.empty() &&
           std::any_of(results_.blocks.begin(), results_.blocks.end(),
                       [&](const FileBlock& block) { return find_part(block.name) == fields_.part; });
  }

  /// All components of each quantity that is requested, or of which there is one.
  void require_quantities() const {
    bool some = false;
    for (const NamedQuantity& of : named_quantities) {
      if (!is_taken(of)) continue;
      const std::vector<std::string> wanted = list_components(of);
      const std::vector<std::string>& names = is_of_nodes(of) ? results_.node_names : results_.element_names;
      std::vector<std::string> lacking;
      for (const std::string& name : wanted)
        if (!contains_all(names, {name})) lacking.push_back(name);
      some = some || lacking.empty();
      if (lacking.empty() || (fields_.take.empty() && lacking.size() == wanted.size())) continue;
      refuse(fmt::format("there is no variable '{}' of {} (there are: {})", lacking.front(),
                         is_of_nodes(of) ? "nodes" : "elements", list_or_none(names)));
    }
    if (!some)
      refuse(
          fmt::format("there is no stress, equivalent_plastic_strain or temperature of elements (there are: {}) and "
                      "no velocity of nodes (there are: {})",
                      list_or_none(results_.element_names), list_or_none(results_.node_names)));
  }

  /// Layers of shells, if the file has them; otherwise all of each element.
  StartTable make_element_table(std::size_t b, const NamedQuantity& of) const {
    const FileBlock& block = results_.blocks[b];
    StartTable table;
    table.is_of_mesh = true;
    table.columns = of.components;
    table.*of.column = 0;
    const bool is_shell = block.topology && find_topology(*block.topology).is_surface();
    int layers = 0;
    while (is_shell && layers < most_thickness_points && !find_columns(b, list_components(of, layers + 1)).empty())
      ++layers;
    table.has_layers = layers > 0;
    for (int layer = layers > 0 ? 1 : 0; layer <= layers; ++layer) {
      const auto columns = find_columns(b, list_components(of, layer));
      if (columns.empty()) continue;
      for (std::int64_t i = 0; i < block.elements; ++i) {
        const auto e = static_cast<std::size_t>(block.first_element - 1 + i);
        add_row(table, columns, e, results_.element_ids[e]);
        table.layers.back() = layer;
      }
    }
    return table;
  }

  StartTable make_node_table(std::size_t b) const {
    StartTable table;
    table.is_of_mesh = table.is_of_nodes = true;
    table.columns = 3;
    std::vector<const ResultsColumn*> columns;
    for (const std::string& name : list_components(named_quantities.back())) {
      const auto found = results_.of_nodes.find(name);
      if (found == results_.of_nodes.end()) return table;
      columns.push_back(&found->second);
    }
    const std::set<std::int64_t> nodes(results_.corners[b].begin(), results_.corners[b].end());
    for (const std::int64_t node : nodes) {
      if (node < 1 || node > static_cast<std::int64_t>(results_.node_ids.size()))
        refuse(
            fmt::format("the file is damaged (an element of block '{}' has node {})", results_.blocks[b].name, node));
      add_row(table, columns, static_cast<std::size_t>(node - 1),
              results_.node_ids[static_cast<std::size_t>(node - 1)]);
    }
    return table;
  }

  /// Columns of a block; empty: it does not have all.
  std::vector<const ResultsColumn*> find_columns(std::size_t b, const std::vector<std::string>& names) const {
    std::vector<const ResultsColumn*> columns;
    for (const std::string& name : names) {
      const auto found = results_.of_elements.find(name);
      if (found == results_.of_elements.end() || found->second.is_lacking[b] != 0) return {};
      columns.push_back(&found->second);
    }
    return columns;
  }

  void add_row(StartTable& table, const std::vector<const ResultsColumn*>& columns, std::size_t place,
               std::int64_t id) const {
    table.ids.push_back(id);
    table.layers.push_back(0);
    table.lines.push_back(0);
    for (const ResultsColumn* column : columns) {
      const double value = column->values[place];
      const bool is_strain = table.plastic_strain != StartTable::absent;
      if (!(std::abs(value) <= largest_value) || (is_strain && value < 0))
        refuse(fmt::format(
            "{} {} has the {} {:g} ({})", table.is_of_nodes ? "node" : "element", id, name_values(table), value,
            std::abs(value) <= largest_value ? "must be zero or positive" : "must be a number up to 1e100"));
      table.values.push_back(value);
    }
  }

  static const char* name_values(const StartTable& table) {
    if (table.is_of_nodes) return "velocity";
    if (table.stress != StartTable::absent) return "stress";
    return table.temperature != StartTable::absent ? "temperature" : "equivalent plastic strain";
  }

  void sort_rows(StartTable& table) const {
    std::vector<std::size_t> order(table.ids.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    const auto key = [&](std::size_t row) { return std::pair(table.ids[row], table.layers[row]); };
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return key(a) < key(b); });
    StartTable sorted = table;
    for (std::size_t i = 0; i < order.size(); ++i) {
      if (i > 0 && key(order[i - 1]) == key(order[i]))
        refuse(fmt::format("{} {} is there twice in a block", table.is_of_nodes ? "node" : "element",
                           table.ids[order[i]]));
      sorted.ids[i] = table.ids[order[i]];
      sorted.layers[i] = table.layers[order[i]];
      std::copy_n(table.row(static_cast<int>(order[i])), table.columns,
                  sorted.values.begin() + static_cast<std::ptrdiff_t>(i) * table.columns);
    }
    table = std::move(sorted);
  }

  const Deck& deck_;
  const StartFieldsDeck& fields_;
  StartPlace place_;
  FileResults results_;
};

}  // namespace

std::vector<StartPiece> read_mesh_tables(const Deck& deck, const StartFieldsDeck& fields, StartPlace place,
                                         FileDisplacement& unused) {
  MeshTables tables(deck, fields, place);
  unused = tables.find_displacement();
  return tables.list();
}

void share_displacement(const Communicator& ranks, FileDisplacement& displacement) {
  displacement.name = broadcast_text(ranks, displacement.name, 0);
  std::vector<double> largest{displacement.largest};
  broadcast_values(ranks, largest, 0);
  displacement.largest = largest.front();
}

void share_pieces(const Communicator& ranks, std::vector<StartPiece>& pieces) {
  std::vector<int> count{static_cast<int>(pieces.size())};
  broadcast_values(ranks, count, 0);
  pieces.resize(at(count.front()));
  for (StartPiece& piece : pieces) {
    StartTable& table = piece.table;
    piece.part = broadcast_text(ranks, piece.part, 0);
    std::vector<int> form{
        table.is_of_nodes ? 1 : 0, table.has_layers ? 1 : 0, table.is_of_mesh ? 1 : 0, table.columns, table.stress,
        table.plastic_strain,      table.temperature};
    broadcast_values(ranks, form, 0);
    table.is_of_nodes = form[0] != 0;
    table.has_layers = form[1] != 0;
    table.is_of_mesh = form[2] != 0;
    table.columns = form[3];
    table.stress = form[4];
    table.plastic_strain = form[5];
    table.temperature = form[6];
    broadcast_values(ranks, table.ids, 0);
    broadcast_values(ranks, table.layers, 0);
    broadcast_values(ranks, table.lines, 0);
    broadcast_values(ranks, table.values, 0);
  }
}

}  // namespace percuss
