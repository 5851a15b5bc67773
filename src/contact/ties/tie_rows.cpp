#include "src/contact/ties/tie_rows.hpp"

#include <algorithm>

#include "kernels/core/host_copy.hpp"
#include "kernels/core/small_space.hpp"
#include "src/contact/surface/number_map.hpp"

namespace percuss {
namespace {

/// Nodes of other ranks among those of the first n touches.
int count_foreign(const WorkSpace& space, const Array<const RowTouch>& touches, int n) {
  int count = 0;
  parallel_reduce(
      "contact::count_foreign", RangeOf(space, 0, n),
      KOKKOS_LAMBDA(int r, int& sum) {
        for (int slot = 0; slot < touches(r).count; ++slot) sum += touches(r).node[slot] < 0 ? 1 : 0;
      },
      count);
  return count;
}

}  // namespace

int count_booked_surfaces(const ContactDeck& contact) {
  const bool no_contact = contact.surfaces == ContactDeck::Surfaces::none && !contact.ties.empty();
  return no_contact ? 0 : std::max(1, static_cast<int>(contact.pairs.size()));
}

TieRows::TieRows(const ContactRanks& ranks, const TiedSurfaces& ties, const ContactDeck& contact) : any_(ties.any()) {
  std::vector<RowTouch> rows;
  std::vector<TieGeometry> geometry;
  const std::vector<std::int64_t>& numbers = ranks.mesh.node_numbers;
  int foreign = 0;
  const auto add = [&](const TiedNode& tied, bool turns) {
    RowTouch row;
    row.key = turns ? make_turning_row_key(tied.node) : make_tie_row_key(tied.node);
    row.face = tied.face;
    row.kind = RowKind::tie;
    row.pair = count_booked_surfaces(contact) + tied.tie;
    row.record = static_cast<int>(rows.size());
    row.size = tied.geometry.size;
    row.node[0] = find_number(numbers, tied.node);
    row.node_number[0] = tied.node;
    for (std::size_t i = 0; i < 4; ++i) {
      const bool is_own = ranks.numbering.find_node_owner(tied.corners[i]) == ranks.ranks.rank();
      row.weight[i + 1] = turns ? 0 : -tied.geometry.weight[i];
      row.node[i + 1] = is_own ? find_number(numbers, tied.corners[i]) : -1 - foreign++;
      row.node_number[i + 1] = tied.corners[i];
    }
    if (turns) row.weight[0] = 0;
    keys_.push_back(row.key);
    rows.push_back(row);
    geometry.push_back(tied.geometry);
    geometry.back().turns = turns;
  };
  const auto is_glued = [&](const TiedNode& tied) { return contact.ties[static_cast<std::size_t>(tied.tie)].cohesive; };
  for (const TiedNode& tied : ties.nodes)
    if (!is_glued(tied)) add(tied, false);
  for (const TiedNode& tied : ties.nodes)
    if (contact.ties[static_cast<std::size_t>(tied.tie)].rotations) add(tied, true);
  rows_ = to_view("contact::tie_rows", rows);
  geometry_ = to_view("contact::ties", geometry);
}

int TieRows::append(int num_touches, Array<RowTouch>& touches) const {
  const int num_ties = static_cast<int>(rows_.extent(0)), total = num_touches + num_ties;
  if (num_ties == 0) return total;
  int foreign = 0;
  run_where_it_pays(total, [&](const auto& space) {
    foreign = count_foreign(space, touches, num_touches);
    keep_and_reserve(space, touches, num_touches, total);
  });
  const Array<RowTouch> out = touches;
  const Array<const RowTouch> rows = rows_;
  loop_where_it_pays(
      "contact::append_ties", num_ties, total, KOKKOS_LAMBDA(int t) {
        RowTouch row = rows(t);
        for (int& node : row.node)
          if (node < 0) node -= foreign;
        out(num_touches + t) = row;
      });
  return total;
}

}  // namespace percuss
