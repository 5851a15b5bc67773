#include "src/contact/contact_stage_impl.hpp"

namespace percuss {

/// Everything that follows from the mesh as it is now, but the history.
void ContactStage::Impl::redefine_surface() {
  ties = keep_living_ties(chunks, ties_of_start, ranks);
  breaking.use(ties);
  tie_rows = TieRows(seen(), ties, contact);
  share = build_surface_share(chunks, deck, ties, exchange, folds.folds());
  walls = build_walls(chunks, deck, share);
  enforcer.redefine(mesh, share, walls, tie_rows.geometry());
  follow_share();
  renew_finder();
}

/// Faces and nodes are others, or named by other classes.
void ContactStage::Impl::follow_share() {
  areas.reset();
  approach.redefine();
  forces.set_surface(seen(), share);
}

void ContactStage::Impl::renew_finder() {
  forget_last_step();
  bound.redefine();
  is_new_surface = true;
  std::unique_ptr<ContactFinder> next = make_contact_finder(seen(), share, contact);
  next->take_over(*finder);
  finder = std::move(next);
  candidates = 0;
}

/// For a surface that has changed: one search for both, where it overlaps now and the pairs of the next steps.
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
  history = carry_history(ranks, history, before, now, share, walls);
  if (!has_pairs()) return;
  search_changed(here);
  const ReleasedTies released = ties_let_go == nullptr ? ReleasedTies{} : *ties_let_go;
  if (ties_let_go != nullptr)
    seed_edges(look_for_overlap(*finder), here, {before.edges, now.edges, released.nodes}, history.edges);
  seed_opened(look_for_overlap(*finder), here, contact.overlap, {before, now, released.nodes, released.faces}, history);
}

/// Nodes, faces, walls and ties are as they were.
void ContactStage::Impl::redefine_folds(const SurfaceMotion& here) {
  const Phase phase("percuss::contact_redefine", clocks.search);
  const std::vector<EdgeTopology> before = share.edges;
  if (!change_folds(chunks, deck, ties, exchange, folds.folds(), share)) follow_share();
  renew_finder();
  history.edges = carry_edges(ranks, history.edges, before, share.edges);
  if (!has_pairs()) return;
  search_changed(here);
  seed_edges(look_for_overlap(*finder), here, {before, share.edges, {}}, history.edges);
}

void ContactStage::restore_surface() {
  Impl& stage = *impl_;
  stage.folds.redefine();
  stage.redefine_surface();
  stage.history = make_history(stage.share, stage.walls);
  stage.history.ties = Rows3<double>("contact::history_ties", stage.tie_rows.keys().size());
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
  if (!stage.breaking.are_failing()) return false;
  const ReleasedTies released = stage.breaking.release(stage.ties_of_start);
  stage.redefine({x, v, 0}, &released);
  return true;
}

std::vector<Warning> ContactStage::take_warnings() { return impl_->breaking.take_warnings(); }

}  // namespace percuss
