#include "src/contact/ties/tie_failures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <span>

#include "comm/all_reduce.hpp"
#include "comm/exchange/item_exchange.hpp"
#include "comm/gather_items.hpp"
#include "kernels/contact/surface/node_areas.hpp"
#include "kernels/core/host_copy.hpp"
#include "src/contact/surface/number_map.hpp"
#include "src/error.hpp"
#include "src/index.hpp"
#include "src/mesh/surface_nodes.hpp"

namespace percuss {
namespace {

/// Share of a face in the area of a tied node, on its way to the node's owner.
struct AreaItem {
  std::int64_t node = 0, face = 0;  // numbers
  double area = 0;
};

bool has_failure(const TieDeck& tie) { return tie.normal_strength || tie.shear_strength; }

/// Shares of this rank's faces of side a that are tied with all corners: sides of a body at the rim do not count.
void list_shares(const ChunkedMesh& chunked, const std::vector<ElementFace>& faces,
                 const std::vector<std::int64_t>& tied, std::vector<AreaItem>& items) {
  const Mesh& mesh = chunked.mesh;
  const std::vector<std::int64_t> elements = list_element_numbers(chunked);
  for (const ElementFace& face : faces) {
    const std::array<int, 4> nodes = mesh.elements.face_nodes(face);
    Point3 corners[4];
    std::int64_t numbers[4];
    bool is_whole = true, is_triangle = false;
    for (std::size_t i = 0; i < 4; ++i) {
      const Vec3& x = mesh.nodes[at(nodes[i])];
      corners[i] = {x[0], x[1], x[2]};
      numbers[i] = mesh.node_numbers[at(nodes[i])];
      is_whole = is_whole && std::binary_search(tied.begin(), tied.end(), numbers[i]);
      is_triangle = is_triangle || nodes[i] == nodes[(i + 1) % 4];
    }
    if (!is_whole) continue;
    const double area = norm(find_corner_area(corners, is_triangle));
    for (std::size_t i = 0; i < 4; ++i)
      if (nodes[i] != nodes[(i + 1) % 4])
        items.push_back({numbers[i], find_face_number(elements[at(face.element)], face.face), area});
  }
}

}  // namespace

TieFailures::TieFailures(const ChunkedMesh& chunked, const Deck& deck, const TiedSurfaces& ties,
                         const Communicator& ranks)
    : chunked_(chunked), ranks_(ranks) {
  const std::vector<TieDeck>& decks = deck.contact.ties;
  if (std::none_of(decks.begin(), decks.end(), has_failure)) return;
  std::vector<AreaItem> items;
  for (std::size_t t = 0; t < decks.size(); ++t) {
    law_of_tie_.push_back(has_failure(decks[t]) ? static_cast<int>(laws_.size()) : -1);
    if (!has_failure(decks[t])) continue;
    laws_.push_back({decks[t].normal_strength.value_or(0), decks[t].shear_strength.value_or(0),
                     decks[t].normal_exponent, decks[t].shear_exponent});
    list_shares(chunked, select_surface_nodes(chunked.mesh, deck, decks[t].a).faces, ties.known[t], items);
  }
  std::vector<int> owners;
  for (const AreaItem& item : items) owners.push_back(chunked.numbering.find_node_owner(item.node));
  items = ItemExchange(ranks).send(owners, items);
  std::sort(items.begin(), items.end(),
            [](const AreaItem& a, const AreaItem& b) { return a.node != b.node ? a.node < b.node : a.face < b.face; });
  std::vector<std::int64_t> bare(decks.size(), 0);
  for (const TiedNode& tied : ties.nodes) {
    if (law_of_tie_[at(tied.tie)] < 0) continue;
    double area = 0;
    auto item = std::lower_bound(items.begin(), items.end(), tied.node,
                                 [](const AreaItem& i, std::int64_t number) { return i.node < number; });
    for (; item != items.end() && item->node == tied.node; ++item) area += item->area;
    numbers_.push_back(tied.node);
    areas_.push_back(area);
    if (!(area > 0)) ++bare[at(tied.tie)];
  }
  has_failed_.assign(numbers_.size(), 0);
  all_reduce(ranks, Reduce::sum, bare);
  for (std::size_t t = 0; t < decks.size(); ++t) {
    if (bare[t] == 0) continue;
    throw InputError(fmt::format(
        "{}: error: tie of '{}' and '{}' cannot fail by stress ({} of its nodes are on no face of side a that is tied "
        "with all its corners): tie a surface of whole faces, or leave out failure",
        deck.where(decks[t].place), decks[t].a.name, decks[t].b.name, bare[t]));
  }
  take(ties);
}

void TieFailures::take(const TiedSurfaces& ties) {
  if (!any()) return;
  taken_.clear();
  std::vector<int> law;
  std::vector<double> area;
  for (const TiedNode& tied : ties.nodes) {
    taken_.push_back(tied.node);
    law.push_back(law_of_tie_[at(tied.tie)]);
    area.push_back(law.back() < 0 ? 1 : areas_[at(find_number(numbers_, tied.node))]);
  }
  strengths_ = {to_view("contact::tie_laws", law), to_view("contact::tie_strengths", laws_),
                to_view("contact::tie_areas", area)};
}

std::int64_t TieFailures::judge(const Array<const double>& use) {
  failing_.clear();
  const auto host = to_host(use);
  for (std::size_t t = 0; t < taken_.size(); ++t)
    if (host(t) >= 1) failing_.push_back(taken_[t]);
  auto count = static_cast<std::int64_t>(failing_.size());
  all_reduce(ranks_, Reduce::sum, count);
  return count;
}

void TieFailures::let_go(TiedSurfaces& ties) {
  for (const std::int64_t number : failing_) has_failed_[at(find_number(numbers_, number))] = 1;
  std::vector<std::int64_t> gone = gather_items(ranks_, failing_);
  std::sort(gone.begin(), gone.end());
  count_ += static_cast<std::int64_t>(gone.size());
  failing_.clear();
  const auto is_gone = [&](std::int64_t number) { return std::binary_search(gone.begin(), gone.end(), number); };
  const Mesh& mesh = chunked_.mesh;
  std::erase_if(ties.nodes, [&](const TiedNode& tied) { return is_gone(tied.node); });
  for (std::size_t t = 0; t < ties.known.size(); ++t) {
    std::vector<std::int64_t>& known = ties.known[t];
    std::erase_if(known, is_gone);
    std::erase_if(ties.faces[t][0], [&](const ElementFace& face) {
      const std::array<int, 4> nodes = mesh.elements.face_nodes(face);
      return std::none_of(nodes.begin(), nodes.end(), [&](int node) {
        return std::binary_search(known.begin(), known.end(), mesh.node_numbers[at(node)]);
      });
    });
  }
}

bool TieFailures::archive(CheckpointArchive& archive) {
  if (!any()) return false;
  archive.rows("contact/ties/failed", find_rows_of_nodes(chunked_, numbers_), 1, std::span<double>(has_failed_));
  if (!archive.is_loading()) return false;
  failing_.clear();
  for (std::size_t n = 0; n < numbers_.size(); ++n)
    if (has_failed_[n] != 0) failing_.push_back(numbers_[n]);
  auto count = static_cast<std::int64_t>(failing_.size());
  all_reduce(ranks_, Reduce::sum, count);
  count_ = 0;
  return count > 0;
}

}  // namespace percuss
