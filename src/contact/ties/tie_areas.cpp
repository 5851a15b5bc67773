#include "src/contact/ties/tie_areas.hpp"

#include <algorithm>

#include "comm/exchange/item_exchange.hpp"
#include "kernels/contact/surface/node_areas.hpp"
#include "src/index.hpp"
#include "src/mesh/surface_nodes.hpp"

namespace percuss {
namespace {

/// Share of a face in the area of a tied node, on its way to the node's owner.
struct AreaItem {
  std::int64_t node = 0, face = 0;  // numbers
  double area = 0;
};

/// Whether the face before this one is the other side of the same shell.
bool is_second_side(const Mesh& mesh, const std::vector<ElementFace>& faces, std::size_t f) {
  return f > 0 && faces[f - 1].element == faces[f].element && mesh.topology_of(at(faces[f].element)).is_surface();
}

/// Shares of this rank's faces of side a that are tied with all corners: sides of a body at the rim do not count, a
/// shell counts once.
void list_shares(const ChunkedMesh& chunked, const std::vector<ElementFace>& faces,
                 const std::vector<std::int64_t>& tied, std::vector<AreaItem>& items) {
  const Mesh& mesh = chunked.mesh;
  const std::vector<std::int64_t> elements = list_element_numbers(chunked);
  for (std::size_t f = 0; f < faces.size(); ++f) {
    const std::array<int, 4> nodes = mesh.elements.face_nodes(faces[f]);
    Point3 corners[4];
    std::int64_t numbers[4];
    bool is_whole = !is_second_side(mesh, faces, f), is_triangle = false;
    for (std::size_t i = 0; i < 4; ++i) {
      const Vec3& x = mesh.nodes[at(nodes[i])];
      corners[i] = {x[0], x[1], x[2]};
      numbers[i] = mesh.node_numbers[at(nodes[i])];
      is_whole = is_whole && std::binary_search(tied.begin(), tied.end(), numbers[i]);
      is_triangle = is_triangle || nodes[i] == nodes[(i + 1) % 4];
    }
    if (!is_whole) continue;
    const double area = norm(find_corner_area(corners, is_triangle));
    const std::int64_t number = find_face_number(elements[at(faces[f].element)], faces[f].face);
    for (std::size_t i = 0; i < 4; ++i)
      if (nodes[i] != nodes[(i + 1) % 4]) items.push_back({numbers[i], number, area});
  }
}

}  // namespace

std::vector<double> sum_tie_areas(const TieScene& scene, const TiedSurfaces& ties,
                                  const std::vector<std::int64_t>& numbers) {
  const ChunkedMesh& chunked = scene.chunked;
  const std::vector<TieDeck>& decks = scene.deck.contact.ties;
  std::vector<AreaItem> items;
  for (std::size_t t = 0; t < decks.size(); ++t) {
    if (decks[t].can_fail() && !decks[t].is_late())
      list_shares(chunked, select_surface_nodes(chunked.mesh, scene.deck, decks[t].a).faces, ties.known[t], items);
  }
  std::vector<int> owners;
  owners.reserve(items.size());
  for (const AreaItem& item : items) owners.push_back(chunked.numbering.find_node_owner(item.node));
  items = ItemExchange(scene.ranks).send(owners, items);
  std::sort(items.begin(), items.end(),
            [](const AreaItem& a, const AreaItem& b) { return a.node != b.node ? a.node < b.node : a.face < b.face; });
  std::vector<double> areas;
  for (const std::int64_t number : numbers) {
    auto item = std::lower_bound(items.begin(), items.end(), number,
                                 [](const AreaItem& i, std::int64_t n) { return i.node < n; });
    areas.push_back(0);
    for (; item != items.end() && item->node == number; ++item) areas.back() += item->area;
  }
  return areas;
}

}  // namespace percuss
