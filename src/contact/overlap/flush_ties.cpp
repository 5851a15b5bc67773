#include "src/contact/overlap/flush_ties.hpp"

#include <algorithm>
#include <iterator>

#include "comm/gather_items.hpp"
#include "kernels/contact/geometry/contact_limits.hpp"
#include "src/contact/overlap/part_gaps.hpp"

namespace percuss {
namespace {

using Item = FlushTies::Item;

std::vector<Item> gather_sorted(const Communicator& ranks, const std::vector<Item>& own) {
  std::vector<Item> all = gather_items(ranks, own);
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

/// Calls visit(tie) for the ties of a number.
template <class Visit>
void visit_ties(const std::vector<Item>& items, std::int64_t number, const Visit& visit) {
  const auto first = std::lower_bound(items.begin(), items.end(), Item{number, -1});
  for (auto item = first; item != items.end() && item->number == number; ++item) visit(item->tie);
}

/// A tied node, on its way to the rank of its face.
struct TiedGap {
  std::int64_t face;
  int part;
  double distance, thickness, size;  // thickness: half that of the shells around the node
};

}  // namespace

bool FlushTies::has_common(const std::vector<Item>& of_a, std::int64_t a, const std::vector<Item>& of_b,
                           std::int64_t b) {
  bool is_common = false;
  visit_ties(of_a, a, [&](int tie) {
    if (std::binary_search(of_b.begin(), of_b.end(), Item{b, tie})) is_common = true;
  });
  return is_common;
}

FlushTies find_flush_ties(const Communicator& ranks, const SurfaceShare& share, const TiedSurfaces& ties) {
  FlushTies flush;
  if (!ties.any()) return flush;
  std::vector<Item> nodes, faces, edges;
  for (const TiedNode& tied : ties.nodes) {
    nodes.push_back({tied.node, tied.tie});
    for (const std::int64_t corner : tied.corners) nodes.push_back({corner, tied.tie});
  }
  flush.nodes = gather_sorted(ranks, nodes);
  for (const FaceTopology& face : share.faces)
    for (const std::int64_t corner : face.corners)
      visit_ties(flush.nodes, corner, [&](int tie) { faces.push_back({face.number, tie}); });
  for (const EdgeTopology& edge : share.edges)
    for (const std::int64_t end : edge.ends)
      visit_ties(flush.nodes, end, [&](int tie) { edges.push_back({edge.number, tie}); });
  flush.faces = gather_sorted(ranks, faces);
  flush.edges = gather_sorted(ranks, edges);
  return flush;
}

std::vector<PartGap> find_tied_gaps(const Communicator& ranks, const SurfaceShare& share, const TiedSurfaces& ties) {
  if (!ties.any()) return {};
  std::vector<TiedGap> sent;
  const std::vector<std::int64_t>& numbers = share.nodes.numbers;
  for (const TiedNode& tied : ties.nodes) {
    const auto place = std::lower_bound(numbers.begin(), numbers.end(), tied.node);
    if (place == numbers.end() || *place != tied.node) continue;
    const auto n = static_cast<std::size_t>(place - numbers.begin());
    const FaceTopology* const around = share.find_around(n);
    sent.push_back({tied.face, share.nodes.parts[n], norm(tied.geometry.offset), around == nullptr ? 0 : around->offset,
                    tied.geometry.size});
  }
  std::vector<PartGap> own;
  for (const TiedGap& tied : gather_items(ranks, sent)) {
    const auto face = std::lower_bound(share.faces.begin(), share.faces.end(), tied.face,
                                       [](const FaceTopology& f, std::int64_t number) { return f.number < number; });
    if (face == share.faces.end() || face->number != tied.face) continue;
    const double gap = tied.distance - tied.thickness - face->offset;
    add_gap({std::min(tied.part, face->part), std::max(tied.part, face->part),
             gap > contact_limits::overlap * tied.size ? gap : 0},
            own);
  }
  return gather_gaps(ranks, own);
}

}  // namespace percuss
