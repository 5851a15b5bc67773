#include "src/step/embedded/build_embedded.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>

#include "comm/all_reduce.hpp"
#include "comm/gather_items.hpp"
#include "src/error.hpp"
#include "src/index.hpp"
#include "src/mesh/hex_geometry.hpp"
#include "src/step/embedded/host_shapes.hpp"
#include "src/step/model/whole_mesh.hpp"
#include "src/step/springs/connected_nodes.hpp"
#include "src/step/springs/end_pairs.hpp"

namespace percuss {
namespace {

/// Every rank moves all of them.
constexpr std::size_t most_embedded_nodes = 100000;

/// A solid that may hold a node.
struct Host {
  int item = -1;  // the node, as a place in its list; -1: none
  int corner_count = 0;
  double outside = 0;  // 0 within
  std::int64_t element = 0;
  std::array<std::int64_t, most_corners> corners{};  // numbers in the whole mesh
  std::array<double, most_corners> weights{};
};

/// The least outside, then that of the lowest number.
bool is_before(const Host& a, const Host& b) {
  return std::tie(a.item, a.outside, a.element) < std::tie(b.item, b.outside, b.element);
}

/// Nodes by the cells of a grid, so that an element looks at those near it.
class Cells {
 public:
  Cells(const std::vector<Item>& items, double size) : size_(size) {
    for (std::size_t i = 0; i < items.size(); ++i) {
      const Cell cell = find_cell(items[i].place);
      for (std::size_t k = 0; k < 3; ++k) {
        low_[k] = i == 0 ? cell[k] : std::min(low_[k], cell[k]);
        high_[k] = i == 0 ? cell[k] : std::max(high_[k], cell[k]);
      }
      cells_[cell].push_back(static_cast<int>(i));
    }
  }

  /// visit(item) for all in a box, and some beside it. A solid far larger than the others looks at no empty cells
  /// beyond.
  template <class Visit>
  void visit(const Vec3& low, const Vec3& high, const Visit& visit_item) const {
    Cell first = find_cell(low), last = find_cell(high);
    for (std::size_t k = 0; k < 3; ++k) {
      first[k] = std::max(first[k], low_[k]);
      last[k] = std::min(last[k], high_[k]);
    }
    Cell cell = first;
    for (cell[0] = first[0]; cell[0] <= last[0]; ++cell[0])
      for (cell[1] = first[1]; cell[1] <= last[1]; ++cell[1])
        for (auto of = cells_.lower_bound({cell[0], cell[1], first[2]});
             of != cells_.end() && of->first <= Cell{cell[0], cell[1], last[2]}; ++of)
          for (const int item : of->second) visit_item(item);
  }

 private:
  using Cell = std::array<std::int64_t, 3>;
  Cell find_cell(const Vec3& place) const {
    Cell cell;
    for (std::size_t k = 0; k < 3; ++k) cell[k] = static_cast<std::int64_t>(std::floor(place[k] / size_));
    return cell;
  }

  double size_;
  Cell low_{}, high_{-1, -1, -1};  // of all nodes; without nodes no cell
  std::map<Cell, std::vector<int>> cells_;
};

/// The solids of an entry that this rank has.
std::vector<int> list_hosts(const Mesh& mesh, const EmbeddedDeck& embedded) {
  const std::vector<std::string>& names = embedded.hosts;
  std::vector<int> hosts;
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
    if (!mesh.topology_of(e).is_solid()) continue;
    const std::string& part = mesh.parts[at(mesh.part_of(e))].name;
    if (names.empty() || std::find(names.begin(), names.end(), part) != names.end())
      hosts.push_back(static_cast<int>(e));
  }
  return hosts;
}

std::vector<Vec3> list_places(const Mesh& mesh, int element) {
  std::vector<Vec3> places;
  for (const int n : mesh.corners(at(element))) places.push_back(mesh.nodes[at(n)]);
  return places;
}

/// The box of a solid with what lies outside within the tolerance.
std::array<Vec3, 2> find_box(const std::vector<Vec3>& corners, double tolerance) {
  std::array<Vec3, 2> box{corners[0], corners[0]};
  for (const Vec3& corner : corners)
    for (std::size_t k = 0; k < 3; ++k) {
      box[0][k] = std::min(box[0][k], corner[k]);
      box[1][k] = std::max(box[1][k], corner[k]);
    }
  const double beyond = (tolerance + 1e-6) * find_distance(box[0], box[1]);
  for (std::size_t k = 0; k < 3; ++k) {
    box[0][k] -= beyond;
    box[1][k] += beyond;
  }
  return box;
}

/// Mean edge of the boxes of the hosts of all ranks. Collective.
double find_cell_size(const ChunkedMesh& chunked, const std::vector<int>& hosts) {
  double sums[] = {0, static_cast<double>(hosts.size())};
  for (const int e : hosts) {
    const std::array<Vec3, 2> box = find_box(list_places(chunked.mesh, e), 0);
    sums[0] += find_distance(box[0], box[1]) / std::sqrt(3.0);
  }
  const Communicator ranks = find_ranks(chunked.mesh);
  for (double& sum : sums) all_reduce(ranks, Reduce::sum, sum);
  return sums[1] > 0 ? sums[0] / sums[1] : 0;
}

/// A node in an element, if it is there.
Host find_host(const ChunkedMesh& chunked, int element, const std::vector<Vec3>& corners, const Vec3& place,
               double tolerance) {
  const Mesh& mesh = chunked.mesh;
  const std::optional<HostPoint> point = find_host_point(mesh.block_of(at(element)).topology, corners, place);
  constexpr double on_face = 1e-9;
  Host host;
  if (!point || point->outside > std::max(tolerance, on_face)) return host;
  host.item = 0;
  host.corner_count = static_cast<int>(corners.size());
  host.outside = point->outside > on_face ? point->outside : 0;
  host.element = find_element_number(chunked, element);
  host.weights = point->weights;
  std::size_t i = 0;
  for (const int n : mesh.corners(at(element))) host.corners[i++] = mesh.node_numbers[at(n)];
  return host;
}

/// [items] the solid of each, the same on all ranks; `item` -1: none. Collective.
std::vector<Host> find_hosts(const ChunkedMesh& chunked, const std::vector<int>& elements,
                             const std::vector<Item>& items, double tolerance) {
  std::vector<Host> own(items.size());
  const double size = find_cell_size(chunked, elements);
  if (size > 0) {
    const Cells cells(items, size);
    for (const int e : elements) {
      const std::vector<Vec3> corners = list_places(chunked.mesh, e);
      const std::array<Vec3, 2> box = find_box(corners, tolerance);
      cells.visit(box[0], box[1], [&](int item) {
        const Vec3& place = items[at(item)].place;
        for (std::size_t k = 0; k < 3; ++k)
          if (place[k] < box[0][k] || place[k] > box[1][k]) return;
        Host host = find_host(chunked, e, corners, place, tolerance);
        if (host.item < 0) return;
        host.item = item;
        if (own[at(item)].item < 0 || is_before(host, own[at(item)])) own[at(item)] = host;
      });
    }
  }
  own.erase(std::remove_if(own.begin(), own.end(), [](const Host& host) { return host.item < 0; }), own.end());
  std::vector<Host> all(items.size());
  for (const Host& host : gather_items(find_ranks(chunked.mesh), own))
    if (all[at(host.item)].item < 0 || is_before(host, all[at(host.item)])) all[at(host.item)] = host;
  return all;
}

/// The nodes of an entry that are no corners of its solids, which hold those as they are. Collective.
std::vector<Item> list_nodes(const Deck& deck, const ChunkedMesh& chunked, const EmbeddedDeck& embedded,
                             const std::vector<int>& hosts) {
  const Mesh& mesh = chunked.mesh;
  std::vector<int> own;
  for (const int n : select_nodes(mesh, deck, embedded.nodes))
    if (owns_node(chunked, n)) own.push_back(n);
  std::vector<Item> items = gather_nodes(chunked, own);
  std::vector<int> is_corner(items.size(), 0);
  for (const int e : hosts)
    for (const int n : mesh.corners(at(e))) {
      const std::int64_t number = mesh.node_numbers[at(n)];
      const auto item = std::lower_bound(items.begin(), items.end(), number,
                                         [](const Item& a, std::int64_t b) { return a.number < b; });
      if (item != items.end() && item->number == number) is_corner[at(item - items.begin())] = 1;
    }
  all_reduce(find_ranks(mesh), Reduce::largest, is_corner);
  std::vector<Item> left;
  for (std::size_t i = 0; i < items.size(); ++i)
    if (is_corner[i] == 0) left.push_back(items[i]);
  return left;
}

/// An embedded node and its solid, until the places of all are known.
struct Draft {
  std::int64_t node = 0;
  Host host;
  int entry = 0;
};

std::string describe(const EmbeddedDeck& embedded, std::size_t count, std::size_t held, double farthest) {
  std::string note = fmt::format("embedded '{}': {} nodes keep their places in solids", embedded.name, held);
  if (held < count) note += fmt::format(", {} lie outside and are free", count - held);
  if (farthest > 0) note += fmt::format(", up to {:.2g} of an element outside", farthest);
  return note;
}

/// Entry by entry; a node of several belongs to the first. Collective.
std::vector<Draft> find_drafts(const Deck& deck, const ChunkedMesh& chunked, EmbeddedModel& model) {
  std::map<std::int64_t, Draft> of_node;
  for (std::size_t d = 0; d < deck.embedded.size(); ++d) {
    const EmbeddedDeck& embedded = deck.embedded[d];
    const std::vector<int> elements = list_hosts(chunked.mesh, embedded);
    const std::vector<Item> items = list_nodes(deck, chunked, embedded, elements);
    const std::vector<Host> hosts = find_hosts(chunked, elements, items, embedded.tolerance);
    std::size_t held = 0;
    double farthest = 0;
    for (const Host& host : hosts) {
      if (host.item < 0) continue;
      ++held;
      farthest = std::max(farthest, host.outside);
      const std::int64_t number = items[at(host.item)].number;
      of_node.emplace(number, Draft{number, host, static_cast<int>(d)});
    }
    if (held == 0)
      throw InputError(
          fmt::format("{}: error: embedded '{}' holds nothing (none of its {} nodes lies in a solid, apart "
                      "from corners of these): correct nodes or in",
                      deck.where(embedded.place), embedded.name, items.size()));
    model.notes.push_back(describe(embedded, items.size(), held, farthest));
  }
  std::vector<Draft> drafts;
  drafts.reserve(of_node.size());
  for (const auto& [number, draft] : of_node) drafts.push_back(draft);
  return drafts;
}

int find_place(const EmbeddedModel& model, std::int64_t number) {
  return static_cast<int>(std::lower_bound(model.nodes.begin(), model.nodes.end(), number) - model.nodes.begin());
}

EmbeddedNode make_node(const Draft& draft, const EmbeddedModel& model) {
  EmbeddedNode node;
  node.node = find_place(model, draft.node);
  node.element = draft.host.element;
  node.corner_count = draft.host.corner_count;
  node.weights = draft.host.weights;
  for (std::size_t i = 0; i < at(node.corner_count); ++i) node.corners[i] = find_place(model, draft.host.corners[i]);
  return node;
}

/// Refuses nodes with a motion of their own: it would separate them from their host.
void refuse_moved(const Deck& deck, const ChunkedMesh& chunked, const Model& model, const std::vector<Draft>& drafts) {
  const EmbeddedModel& embedded = model.embedded;
  const std::vector<int> is_rigid = mark_rigid_nodes(model, embedded);
  const auto is_among = [](const ConnectedNodes& others, std::int64_t number) {
    return std::binary_search(others.nodes.begin(), others.nodes.end(), number);
  };
  const auto refuse = [&](const Draft& draft, std::int64_t number) {
    const char* const what = is_rigid[at(find_place(embedded, number))] != 0 ? "of a rigid body"
                             : is_among(model.welds, number)                 ? "of a weld"
                             : is_among(model.constraints, number)           ? "of a constraint"
                                                                             : nullptr;
    if (what == nullptr) return;
    const EmbeddedDeck& entry = deck.embedded[at(draft.entry)];
    throw InputError(
        fmt::format("{}: error: embedded '{}' moves node {}, which is {} (both would break each other): "
                    "leave it out of one",
                    deck.where(entry.place), entry.name, find_node_id(chunked, number), what));
  };
  for (const Draft& draft : drafts) {
    refuse(draft, draft.node);
    for (std::size_t i = 0; i < at(draft.host.corner_count); ++i) refuse(draft, draft.host.corners[i]);
  }
}

}  // namespace

void build_embedded(const Deck& deck, const ChunkedMesh& chunked, Model& model) {
  if (deck.embedded.empty()) return;
  EmbeddedModel& embedded = model.embedded;
  const std::vector<Draft> drafts = find_drafts(deck, chunked, embedded);
  if (drafts.size() > most_embedded_nodes)
    throw InputError(
        fmt::format("{}: error: {} nodes are embedded (at most {}, because every rank computes all of "
                    "them): name smaller sets",
                    deck.where(deck.embedded.back().place), drafts.size(), most_embedded_nodes));
  for (const Draft& draft : drafts) {
    embedded.nodes.push_back(draft.node);
    for (std::size_t i = 0; i < at(draft.host.corner_count); ++i) embedded.nodes.push_back(draft.host.corners[i]);
  }
  std::sort(embedded.nodes.begin(), embedded.nodes.end());
  embedded.nodes.erase(std::unique(embedded.nodes.begin(), embedded.nodes.end()), embedded.nodes.end());
  find_connected_nodes(chunked, embedded);
  refuse_moved(deck, chunked, model, drafts);
  for (const Draft& draft : drafts) embedded.embedded.push_back(make_node(draft, embedded));
}

}  // namespace percuss
