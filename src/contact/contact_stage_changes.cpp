#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <utility>

#include "comm/gather_items.hpp"
#include "src/contact/contact_stage_impl.hpp"
#include "src/error.hpp"

namespace percuss {

/// Everything that follows from the mesh as it is now, but the history.
void ContactStage::Impl::redefine_surface() {
  if (late.any()) late.refresh(active, ties_of_start);
  ties = keep_living_ties(chunks, ties_of_start, ranks);
  breaking.use(ties);
  tie_rows = TieRows(contact_ranks(), ties, contact);
  share = build_surface_share(chunks, deck, ties, exchange, folds.folds(), active);
  walls = build_walls(chunks, deck, share);
  enforcer.redefine(mesh, share, walls, tie_rows.geometry());
  follow_share();
  renew_finder();
}

/// Faces and nodes are others, or named by other classes.
void ContactStage::Impl::follow_share() {
  areas.reset();
  approach.redefine();
  forces.set_surface(contact_ranks(), share);
}

void ContactStage::Impl::renew_finder() {
  forget_last_step();
  bound.redefine();
  is_new_surface = true;
  std::unique_ptr<ContactFinder> next = make_contact_finder(contact_ranks(), share, contact);
  next->take_over(*finder);
  finder = std::move(next);
  candidates = 0;
}

/// Searches once for a surface that has changed: for its overlap now, and for the pairs of the next steps.
void ContactStage::Impl::search_changed(const SurfaceMotion& here) {
  candidates = finder->search(here, bound.restart(here, true));
  count_search();
}

/// ties: those whose surfaces may touch from now on; null: elements have died.
void ContactStage::Impl::redefine(const SurfaceMotion& here, const ReleasedTies* ties_let_go) {
  const Phase phase("percuss::contact_redefine", clocks.search);
  const HistoryOwners before = list_owners();
  folds.redefine();
  redefine_surface();
  const HistoryOwners now = list_owners();
  history = carry_history(ranks, history, before, now, make_history(share, walls, contact));
  if (!has_pairs()) return;
  search_changed(here);
  const ReleasedTies released = ties_let_go == nullptr ? ReleasedTies{} : *ties_let_go;
  if (ties_let_go != nullptr)
    seed_edges(look_for_overlap(*finder), here, {before.edges, now.edges, released.nodes}, history.edges);
  seed_opened(look_for_overlap(*finder), here, {before, now, released.nodes, released.faces}, history);
}

/// Nodes, faces, walls and ties are as they were.
void ContactStage::Impl::redefine_folds(const SurfaceMotion& here) {
  const Phase phase("percuss::contact_redefine", clocks.search);
  const std::vector<EdgeTopology> before = share.edges;
  if (!change_folds(chunks, deck, ties, exchange, folds.folds(), share)) follow_share();
  renew_finder();
  is_new_surface = false;  // the next one is many steps away: a list of near pairs pays
  history.edges = carry_edges(ranks, history.edges, before, share.edges);
  if (!has_pairs()) return;
  search_changed(here);
  seed_edges(look_for_overlap(*finder), here, {before, share.edges, {}}, history.edges);
}

void ContactStage::Impl::restore_surface() {
  folds.redefine();
  redefine_surface();
  history = make_history(share, walls, contact);
  history.ties = Rows3<double>("contact::history_ties", tie_rows.keys().size());
}

void ContactStage::restore_surface() { impl_->restore_surface(); }

/// Pairs and walls that act now and did not before.
BornContact ContactStage::Impl::list_born(const ActiveContact& before) const {
  const auto is_born = [](const std::vector<char>& then, const std::vector<char>& now, std::size_t i) {
    return now[i] != 0 && then[i] == 0;
  };
  BornContact born;
  for (std::size_t w = 0; w < active.walls.size(); ++w)
    born.walls.push_back(is_born(before.walls, active.walls, w) ? 1 : 0);
  std::vector<char> is_class_born;
  for (const SurfaceSet& set : share.classes.sets)
    is_class_born.push_back(std::any_of(set.begin(), set.end(), [&](int surface) {
      const auto pair = static_cast<std::size_t>(surface / 2);
      return pair < active.pairs.size() && is_born(before.pairs, active.pairs, pair);
    }));
  for (const FaceTopology& face : share.faces) {
    if (is_class_born[static_cast<std::size_t>(face.surface_class)] == 0) continue;
    born.faces.push_back(face.number);
    born.nodes.insert(born.nodes.end(), std::begin(face.corners), std::end(face.corners));
  }
  for (std::vector<std::int64_t>* const list : {&born.faces, &born.nodes}) {
    *list = gather_items(ranks, *list);
    std::sort(list->begin(), list->end());
    list->erase(std::unique(list->begin(), list->end()), list->end());
  }
  return born;
}

std::string ContactStage::Impl::describe(const StartOverlap& found, const std::string& when) const {
  const std::int64_t deepest = found.deepest_node < 0 ? -1 : find_user_id(found.deepest_node);
  return describe_overlap(found, contact.overlap, mesh, deepest, when);
}

/// Describes parts that cross where they may touch now, and could not at the start. Throws RunError where the deck
/// refuses them. Collective.
std::string ContactStage::Impl::describe_born_crossings(const Rows3<const double>& x) const {
  std::vector<PartCrossing> born = find_crossings(x);
  std::erase_if(born, [&](const PartCrossing& crossing) {
    const auto is_known = [&](const PartCrossing& of) {
      return of.part == crossing.part && of.other == crossing.other && of.contact == PartCrossing::Contact::now;
    };
    const std::vector<PartCrossing>& known = start_overlap.crossings;
    return crossing.contact != PartCrossing::Contact::now || std::any_of(known.begin(), known.end(), is_known);
  });
  const std::string refused = describe_refused_crossings(born, contact.overlap, mesh);
  if (!refused.empty())
    throw RunError(
        fmt::format("as contact begins, {}: move the parts apart, or set contact.overlap to accept", refused));
  return describe_crossings("crossing as contact begins, which it does not separate: ", PartCrossing::Contact::now,
                            born, mesh);
}

/// Loading: whether other pairs and walls act than at the start of the scene.
bool ContactStage::Impl::archive_active(CheckpointArchive& archive) {
  const ActiveContact before = active;
  const auto archive_all = [&](const char* kind, const auto& entries, std::vector<char>& acts) {
    for (std::size_t i = 0; i < entries.size(); ++i) {
      if (!entries[i].when.any()) continue;
      bool does_act = acts[i] != 0;
      archive.integer(fmt::format("contact/{}/{}/acts", kind, i), does_act);
      acts[i] = does_act ? 1 : 0;
    }
  };
  archive_all("pairs", deck.contact.pairs, active.pairs);
  archive_all("walls", deck.walls, active.walls);
  archive_all("ties", deck.contact.ties, active.ties);
  return active != before;
}

void ContactStage::set_switches(const std::vector<char>& happened) {
  Impl& stage = *impl_;
  const ActiveContact now = find_active_contact(stage.deck, happened);
  if (now == stage.active) return;
  const ActiveContact before = std::exchange(stage.active, now);
  std::vector<std::string> lines;
  stage.switch_ties(before, stage.place_at_start(), lines);
  stage.start_notes.insert(stage.start_notes.end(), lines.begin(), lines.end());
  stage.restore_surface();
}

std::vector<std::string> ContactStage::switch_now(const std::vector<char>& happened, Rows3<const double> x,
                                                  Rows3<const double> v) {
  Impl& stage = *impl_;
  const ActiveContact before = std::exchange(stage.active, find_active_contact(stage.deck, happened));
  if (stage.active == before) return {};
  const SurfaceMotion here{x, v, 0};
  std::vector<std::string> lines;
  const ReleasedTies released = stage.switch_ties(before, x, lines);
  stage.redefine(here, lines.empty() ? nullptr : &released);
  const StartOverlap found =
      seed_born(stage.look_for_overlap(*stage.finder), here, stage.list_born(before), stage.history);
  if (const std::string crossings = stage.describe_born_crossings(x); !crossings.empty()) lines.push_back(crossings);
  const std::string line = stage.describe(found, "as contact begins");
  if (line.empty()) return lines;
  if (stage.contact.overlap == ContactDeck::Overlap::refuse)
    throw RunError(fmt::format("{}: move the parts apart, or set contact.overlap to accept or push_out", line));
  lines.push_back(line);
  return lines;
}

void ContactStage::redefine(Rows3<const double> x, Rows3<const double> v) { impl_->redefine({x, v, 0}, nullptr); }

void ContactStage::watch_folds(Rows3<const double> x, Rows3<const double> v, long step) {
  Impl& stage = *impl_;
  if (!stage.folds.is_due(step)) return;
  {
    const Phase phase("percuss::contact_folds", stage.clocks.search);
    if (!stage.folds.look(stage.share, x, step)) return;
  }
  stage.redefine_folds({x, v, 0});
}

bool ContactStage::break_ties(Rows3<const double> x, Rows3<const double> v) {
  Impl& stage = *impl_;
  const bool are_failing = stage.breaking.are_failing();
  if (are_failing) {
    const ReleasedTies released = stage.breaking.release(stage.ties_of_start);
    stage.redefine({x, v, 0}, &released);
  }
  if (!stage.late.grows(stage.active) || !stage.stick(x)) return are_failing;
  stage.redefine({x, v, 0}, nullptr);
  return true;
}

std::vector<Warning> ContactStage::take_warnings() {
  std::vector<Warning> warnings = impl_->breaking.take_warnings();
  for (Warning& warning : std::exchange(impl_->missed, {})) warnings.push_back(std::move(warning));
  return warnings;
}

}  // namespace percuss
