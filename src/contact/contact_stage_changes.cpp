#include "src/contact/contact_stage_impl.hpp"

namespace percuss {

/// Everything that follows from the mesh as it is now, but the history.
void ContactStage::Impl::redefine_surface() {
  ties = keep_living_ties(chunks, ties_of_start, ranks);
  breaking.use(ties);
  tie_rows = TieRows(seen(), ties, contact);
  redefine_share();
  walls = build_walls(chunks, deck, share);
  approach.redefine();
  redefine_finder();
}

void ContactStage::Impl::redefine_share() {
  forget_last_step();
  areas.reset();
  share = build_surface_share(chunks, deck, ties, exchange, folds.folds());
  bound.redefine();
  is_new_surface = true;
}

void ContactStage::Impl::redefine_finder() {
  std::unique_ptr<ContactFinder> next = make_contact_finder(seen(), share, contact);
  next->take_over(*finder);
  finder = std::move(next);
  enforcer.redefine(mesh, share, walls, tie_rows.geometry());
  forces.set_surface(seen(), share);
  candidates = 0;
}

/// Nodes, faces, walls and ties are as they were.
void ContactStage::Impl::redefine_edges() {
  redefine_share();
  approach.redefine_bodies();  // numbers of classes are others
  redefine_finder();
}

void ContactStage::Impl::redefine(Rows3<const double> x, Rows3<const double> v, const SurfaceCause& cause) {
  const Phase phase("percuss::contact_redefine", clocks.search);
  const bool are_folds = cause.kind == SurfaceCause::Kind::folds;
  const HistoryOwners before = list_owners();
  if (are_folds) {
    redefine_edges();
  } else {
    folds.redefine();
    redefine_surface();
  }
  const HistoryOwners now = list_owners();
  history = carry_history(ranks, history, before, now, share, walls);
  if (!has_pairs()) return;
  // One search for both: where opened surfaces overlap, and the pairs of the next steps.
  const SurfaceMotion here{x, v, 0};
  candidates = finder->search(here, bound.restart(here, true));
  count_search();
  const SurfaceChange change{before, now, cause.released.nodes, cause.released.faces};
  if (cause.kind != SurfaceCause::Kind::elements) seed_edges(look_for_overlap(*finder), here, change, history.edges);
  if (!are_folds) seed_opened(look_for_overlap(*finder), here, contact.overlap, change, history);
}

void ContactStage::restore_surface() {
  Impl& stage = *impl_;
  stage.folds.redefine();
  stage.redefine_surface();
  stage.history = make_history(stage.share, stage.walls);
  stage.history.ties = Rows3<double>("contact::history_ties", stage.tie_rows.keys().size());
}

void ContactStage::redefine(Rows3<const double> x, Rows3<const double> v) { impl_->redefine(x, v, {}); }

void ContactStage::watch_folds(Rows3<const double> x, Rows3<const double> v, long step) {
  Impl& stage = *impl_;
  if (!stage.folds.is_due(step)) return;
  {
    const Phase phase("percuss::contact_folds", stage.clocks.search);
    if (!stage.folds.look(stage.share, x, step)) return;
  }
  stage.redefine(x, v, {SurfaceCause::Kind::folds});
}

bool ContactStage::break_ties(Rows3<const double> x, Rows3<const double> v) {
  Impl& stage = *impl_;
  if (!stage.breaking.are_failing()) return false;
  stage.redefine(x, v, {SurfaceCause::Kind::ties, stage.breaking.release(stage.ties_of_start)});
  return true;
}

std::vector<Warning> ContactStage::take_warnings() { return impl_->breaking.take_warnings(); }

}  // namespace percuss
