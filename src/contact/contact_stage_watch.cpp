// Warnings of what lies inside other bodies, or has gone through them, without a contact.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "comm/all_reduce.hpp"
#include "src/contact/contact_stage_impl.hpp"

namespace percuss {

/// None: the scene began with edges inside one another alone, and which ends these have is not known. Collective.
std::optional<KnownContact> ContactStage::Impl::find_known() const {
  KnownContact known{start_overlap.inside, std::vector<char>(mesh.parts.size(), 0)};
  std::int64_t count = static_cast<std::int64_t>(known.inside.size());
  all_reduce(ranks, Reduce::sum, count);
  if (overlap_at_start > 0 && count == 0) return std::nullopt;
  known.holds_deep = share.springs == SpringRows::all || overlap_at_start > 0;
  std::sort(known.inside.begin(), known.inside.end());
  for (const ElementBlock& block : mesh.elements.blocks)
    if (block.section.thickness > 0) known.of_shells[static_cast<std::size_t>(block.part)] = 1;
  return known;
}

/// Edges that go through sheets and through their own bodies, but those of bodies that did at the start. Collective.
PiercingEdges ContactStage::Impl::find_piercings(const Rows3<const double>& x) {
  if (has_switched_pairs(deck.contact)) return {};  // what passed while a pair did not act
  PiercingEdges look = find_piercing_edges(ranks, share, x, PiercedPairs::that_may_touch);
  if (look.found.empty()) return look;
  if (!pierced_at_start) {
    pierced_at_start.emplace();
    for (const PiercingEdge& edge : find_piercing_edges(ranks, share, place_at_start(), PiercedPairs::all).found)
      pierced_at_start->push_back(edge.bodies());
    std::sort(pierced_at_start->begin(), pierced_at_start->end());
  }
  std::erase_if(look.found, [&](const PiercingEdge& edge) {
    return std::binary_search(pierced_at_start->begin(), pierced_at_start->end(), edge.bodies());
  });
  return look;
}

void ContactStage::Impl::warn_of_missed(const std::optional<MissedContact>& found, double time) {
  if (!found || has_warned_missed) return;
  has_warned_missed = true;
  missed.push_back({"missed_contact", describe_missed_contact(*found, mesh, find_user_id(found->node)), "", time});
}

/// Archives what is known of the start, and when the next checks are due, so that a restarted run warns of what one
/// that never stopped warns of.
void ContactStage::Impl::archive_watch(CheckpointArchive& archive) {
  archive.number("contact/overlap_at_start", overlap_at_start);
  archive.integer("contact/watch/has_warned", has_warned_missed);
  archive.integer("contact/watch/next_edge_look", next_edge_look);
  archive.integer("contact/watch/next_piercing_look", next_piercing_look);
  archive_pierced(archive);
  if (overlap_at_start > 0) archive_inside(archive);
}

void ContactStage::Impl::archive_pierced(CheckpointArchive& archive) {
  bool is_known = pierced_at_start.has_value();
  archive.integer("contact/watch/knows_pierced", is_known);
  if (!is_known) return pierced_at_start.reset();
  const auto name = [](std::size_t i) { return fmt::format("contact/watch/pierced/{}", i); };
  if (archive.is_loading()) {
    pierced_at_start.emplace();
    while (archive.has_number(name(pierced_at_start->size()))) pierced_at_start->emplace_back();
  }
  for (std::size_t i = 0; i < pierced_at_start->size(); ++i) {
    auto& [body, in] = (*pierced_at_start)[i];
    std::array<std::int64_t, 2> pair{body, in};
    archive.words(name(i), pair);
    body = static_cast<int>(pair[0]);
    in = static_cast<int>(pair[1]);
  }
}

/// The nodes that began inside another body, as a number for each node: 1 for these.
void ContactStage::Impl::archive_inside(CheckpointArchive& archive) {
  const std::vector<std::int64_t>& numbers = mesh.node_numbers;
  std::vector<std::int64_t> began_inside(numbers.size(), 0);
  for (const std::int64_t node : start_overlap.inside) {
    const auto place = std::lower_bound(numbers.begin(), numbers.end(), node) - numbers.begin();
    began_inside[static_cast<std::size_t>(place)] = 1;
  }
  archive.rows("contact/watch/began_inside", find_owned_node_rows(chunks), 1, std::span<std::int64_t>(began_inside));
  if (!archive.is_loading()) return;
  start_overlap.inside.clear();
  for (std::size_t n = 0; n < numbers.size(); ++n)
    if (began_inside[n] != 0) start_overlap.inside.push_back(numbers[n]);
}

void ContactStage::watch_depth(Rows3<const double> x, Rows3<const double> v, double time) {
  Impl& stage = *impl_;
  if (!stage.has_pairs() || stage.has_warned_missed) return;
  const Phase phase("percuss::contact_watch", stage.clocks.check);
  const std::optional<KnownContact> known = stage.find_known();
  if (!known) return;
  const OverlapSearch search = stage.look_for_overlap(*stage.finder);
  const SurfaceMotion here{x, v, 0};
  const LookedAt at = find_watched(search, here, stage.history, *known);
  std::optional<MissedContact> missed;
  if (at.has_nodes || at.has_edges)
    missed = find_missed_contact(stage.look_for_overlap(*stage.make_look(at)), here, stage.history, at, *known);
  if (!missed) missed = find_missed_edge(search, x, stage.history, *known).missed;
  if (!missed) missed = find_missed_piercing(search, stage.history, *known, stage.find_piercings(x).found);
  stage.warn_of_missed(missed, time);
}

void ContactStage::watch_edges(Rows3<const double> x, long step, double time) {
  constexpr long least_steps = 32, most_steps = 4096;  // between looks
  constexpr long tests_of_step = 64;      // of boxes: hundreds of nanoseconds, far below the cost of a step
  constexpr std::int64_t of_a_face = 16;  // tests of a look through faces, before the first has counted them
  Impl& stage = *impl_;
  if (!stage.has_pairs() || stage.has_warned_missed || step % least_steps != 0) return;
  const bool looks_at_edges = stage.share.total_edges > 0 && step >= stage.next_edge_look;
  const auto find_next = [&](std::int64_t tests) {
    return step + std::clamp(static_cast<long>(tests / tests_of_step), least_steps, most_steps);
  };
  if (stage.next_piercing_look == 0)
    stage.next_piercing_look = find_next(of_a_face * stage.share.total_faces) - least_steps;
  const bool looks_through = step >= stage.next_piercing_look;
  if (!looks_at_edges && !looks_through) return;
  const Phase phase("percuss::contact_watch", stage.clocks.check);
  const std::optional<KnownContact> known = stage.find_known();
  const OverlapSearch search = stage.look_for_overlap(*stage.finder);
  if (looks_at_edges) {
    const MissedEdge look = known ? find_missed_edge(search, x, stage.history, *known) : MissedEdge{};
    stage.warn_of_missed(look.missed, time);
    stage.next_edge_look = find_next(look.tests);
  }
  if (looks_through) {
    const PiercingEdges look = known ? stage.find_piercings(x) : PiercingEdges{};
    if (known) stage.warn_of_missed(find_missed_piercing(search, stage.history, *known, look.found), time);
    stage.next_piercing_look = find_next(look.tests);
  }
}

}  // namespace percuss
