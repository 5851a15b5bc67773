// Ties that begin, end and grow in the run, of the contact stage.

#include <algorithm>

#include "comm/all_reduce.hpp"
#include "kernels/core/host_copy.hpp"
#include "kernels/core/view_copy.hpp"
#include "src/contact/contact_stage_impl.hpp"
#include "src/contact/surface/number_map.hpp"
#include "src/index.hpp"

namespace percuss {
namespace {

std::vector<Vec3> list_places(const Rows3<const double>& x) {
  const auto host = to_host(x);
  std::vector<Vec3> places(x.extent(0));
  for (std::size_t n = 0; n < places.size(); ++n) places[n] = {host(n, 0), host(n, 1), host(n, 2)};
  return places;
}

}  // namespace

void ContactStage::let_go(const std::vector<std::int64_t>& nodes) { impl_->breaking.let_go(nodes); }

std::vector<std::int64_t> ContactStage::list_tied_nodes() const {
  std::vector<std::int64_t> nodes;
  for (const TiedNode& tied : impl_->ties.nodes) nodes.push_back(tied.node);
  return nodes;
}

Rows3<const double> ContactStage::Impl::place_at_start() const {
  const Rows3<double> x("contact::start", mesh.nodes.size());
  const auto host = Kokkos::create_mirror_view(x);
  for (std::size_t n = 0; n < mesh.nodes.size(); ++n)
    for (std::size_t k = 0; k < 3; ++k) host(n, k) = mesh.nodes[n][k];
  copy_values(x, host);
  return x;
}

/// Areas of nodes of late ties that may fail: that of their faces which look at the tied face. A node without any is
/// not tied, since nothing says its stress.
void ContactStage::Impl::measure_late_areas(const Rows3<const double>& x) {
  if (!deck.contact.has_failing_ties()) return;
  const AreaNodes& of = find_areas(x);
  const HostNodeFaces around{to_host(of.around.first), to_host(of.around.faces), to_host(of.around.areas)};
  std::erase_if(ties_of_start.nodes, [&](TiedNode& tied) {
    const TieDeck& tie = deck.contact.ties[at(tied.tie)];
    if (!tie.can_fail() || !tie.is_late() || tied.area > 0) return false;
    const int n = find_number(share.nodes.numbers, tied.node);
    const Point3 outward = (tied.side < 0 ? -1.0 : 1.0) * find_face_normal(tied.geometry.face);
    if (n >= 0) tied.area = around.find_area(n, outward);
    return !(tied.area > 0);
  });
  ties = keep_living_ties(chunks, ties_of_start, ranks);
  breaking.use(ties);
}

/// Ties that begin now, at places x, and those that end.
ReleasedTies ContactStage::Impl::switch_ties(const ActiveContact& before, const Rows3<const double>& x,
                                             std::vector<std::string>& lines) {
  if (!late.any() || before.ties == active.ties) return {};
  ReleasedTies released = late.switch_now(before, active, list_places(x), ties_of_start, lines);
  measure_late_areas(x);
  late.note(ties_of_start);
  return released;
}

/// Owned nodes of a tie's side a that were pushed by its side b in the last step, and were never tied.
std::vector<std::int64_t> ContactStage::Impl::list_sticking(std::size_t tie) const {
  std::vector<std::int64_t> nodes;
  const auto face = to_host(history.face);
  const auto impulse = to_host(history.impulse);
  const std::vector<std::int64_t>& numbers = share.nodes.numbers;
  for (std::size_t n = 0; n < numbers.size(); ++n) {
    for (std::size_t r = n * contact_limits::max_touches; r < (n + 1) * contact_limits::max_touches; ++r) {
      const bool is_pushed = face(r) >= 0 && (impulse(r, 0) != 0 || impulse(r, 1) != 0 || impulse(r, 2) != 0);
      if (!is_pushed || !late.is_of_side_b(tie, face(r)) || !late.may_stick(tie, numbers[n])) continue;
      nodes.push_back(numbers[n]);
      break;
    }
  }
  return nodes;
}

/// Whether nodes have come into contact, on any rank, that growing ties hold from now on.
bool ContactStage::Impl::stick(const Rows3<const double>& x) {
  std::vector<std::vector<std::int64_t>> nodes(deck.contact.ties.size());
  std::int64_t count = 0;
  for (std::size_t t = 0; t < nodes.size(); ++t) {
    if (deck.contact.ties[t].sticks != TieDeck::Sticks::on_contact || !active.has_tie(t)) continue;
    nodes[t] = list_sticking(t);
    count += static_cast<std::int64_t>(nodes[t].size());
  }
  all_reduce(ranks, Reduce::sum, count);
  if (count == 0) return false;
  const std::vector<Vec3> places = list_places(x);
  std::int64_t tied = 0;
  for (std::size_t t = 0; t < nodes.size(); ++t)
    if (deck.contact.ties[t].sticks == TieDeck::Sticks::on_contact && active.has_tie(t))
      tied += late.stick(t, nodes[t], places, ties_of_start);
  if (tied == 0) return false;
  measure_late_areas(x);
  late.note(ties_of_start);
  return true;
}

}  // namespace percuss
