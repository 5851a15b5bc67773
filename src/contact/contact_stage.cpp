#include "src/contact/contact_stage.hpp"

#include <fmt/format.h>

#include "src/contact/stage_memory.hpp"

namespace percuss {
namespace {

/// A profiling region whose seconds are added up.
class TimedRegion {
 public:
  TimedRegion(const char* name, double& seconds) : seconds_(seconds) { Kokkos::Profiling::pushRegion(name); }
  ~TimedRegion() {
    ExecSpace().fence();
    Kokkos::Profiling::popRegion();
    seconds_ += timer_.seconds();
  }
  TimedRegion(const TimedRegion&) = delete;
  TimedRegion& operator=(const TimedRegion&) = delete;

 private:
  double& seconds_;
  Kokkos::Timer timer_;
};

std::vector<std::int64_t> list_node_ids(const Mesh& mesh, const ContactSurface& surface) {
  const auto nodes = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), surface.nodes);
  std::vector<std::int64_t> ids;
  for (int n = 0; n < surface.num_nodes; ++n) ids.push_back(mesh.node_ids[static_cast<std::size_t>(nodes(n))]);
  return ids;
}

}  // namespace

struct ContactStage::Impl {
  Impl(const Mesh& mesh, const Deck& deck)
      : surface(build_surface(mesh, deck)),
        walls(build_walls(mesh, deck, surface)),
        overlap(deck.contact.overlap),
        node_ids(list_node_ids(mesh, surface)),
        memory(surface),
        bound(surface, deck.contact.reuse_search),
        history(make_history(surface, walls)) {}

  bool has_pairs() const { return surface.searched_faces.extent(0) > 0; }
  bool has_walls() const { return walls.node.extent(0) > 0; }

  bool search(const SurfaceMotion& motion);
  void check(const SurfaceMotion& motion);
  void enforce(const ContactMotion& motion, ContactReport& report);
  void clear_last_impulse(const ContactMotion& motion);

  const ContactSurface surface;
  const WallPairs walls;
  const ContactDeck::Overlap overlap;
  const std::vector<std::int64_t> node_ids;  // the user's id of each contact node
  SearchMemory memory;
  ReuseBound bound;
  ContactHistory history;
  TouchTable touches;
  RowSystem system;
  double last_dt = 0;
  const double* last_impulse = nullptr;  // where the impulses of the last step were written
  long searches = 0;
  ContactSeconds seconds;
};

bool ContactStage::Impl::search(const SurfaceMotion& motion) {
  if (!has_pairs()) return false;
  const TimedRegion region("percuss::contact_search", seconds.search);
  if (bound.covers(surface, motion)) return false;
  const double margin = bound.restart(surface, motion);
  search_pairs(surface, motion, margin, history.face, memory);
  run_where_it_pays(surface.num_nodes / 10,
                    [&](const auto& space) { drop_history(space, surface, memory.candidates, history); });
  ++searches;
  return true;
}

void ContactStage::Impl::check(const SurfaceMotion& motion) {
  const CandidateList& candidates = memory.candidates;
  touches.count = 0;
  if (candidates.num_pairs == 0) return;
  const TimedRegion region("percuss::contact_check", seconds.check);
  run_where_it_pays(candidates.num_pairs, [&](const auto& space) {
    update_faces(space, surface, motion, candidates, memory.faces);
    find_touches(space, surface, motion, candidates, memory.faces, history, touches);
  });
}

void ContactStage::Impl::enforce(const ContactMotion& motion, ContactReport& report) {
  if (touches.count == 0 && memory.candidates.num_nodes == 0 && !has_walls()) return;
  const TimedRegion region("percuss::contact_enforce", seconds.enforce);
  const SurfaceMotion predicted{motion.x, motion.v, motion.dt};
  const RowInputs inputs{predicted, motion.inverse_mass, last_dt > 0 ? motion.dt / last_dt : 1};
  const int wall_pairs = static_cast<int>(walls.node.extent(0));
  // A row's solution costs some dozen passes; a wall's pair that is out of reach costs one look.
  run_where_it_pays(touches.count + wall_pairs / 8, [&](const auto& space) {
    build_rows(space, surface, memory.candidates, touches, walls, history, inputs, system);
    if (system.num_rows > 0) {
      const SolveReport solved = solve_rows(space, motion.inverse_mass, motion.dt, system);
      const EnforcementSums sums = apply_impulses(space, motion.v_before, motion.dt, system, motion.v, motion.impulse);
      report.iterations = solved.iterations;
      report.converged = solved.converged;
      report.interactions = sums.pushes;
      report.residual = sums.residual;
      report.normal_work = sums.normal_work;
      report.friction_work = sums.friction_work;
      report.deepest = sums.deepest;
      report.deepest_node = sums.deepest_node;
    }
    write_history(space, memory.candidates, walls, motion.dt, system, history);
  });
}

void ContactStage::Impl::clear_last_impulse(const ContactMotion& motion) {
  // Only the nodes of the last step's rows can be set, if it is the same memory.
  if (last_impulse != motion.impulse.data()) {
    Kokkos::deep_copy(ExecSpace(), motion.impulse, 0.0);
  } else if (system.num_nodes > 0) {
    run_where_it_pays(system.num_nodes / 10, [&](const auto& space) { clear_impulses(space, system, motion.impulse); });
  }
  last_impulse = motion.impulse.data();
}

ContactStage::ContactStage(const ChunkedMesh& chunked, const Deck& deck, const Communicator&)
    : impl_(std::make_unique<Impl>(chunked.mesh, deck)) {}
ContactStage::~ContactStage() = default;

bool ContactStage::is_active() const { return impl_->has_pairs() || impl_->has_walls(); }

std::string ContactStage::prepare(Rows3<const double> x, Rows3<const double> v, Rows3<const double>) {
  const StartOverlap found = seed_history(impl_->surface, impl_->walls, {x, v, 0}, impl_->overlap, impl_->history);
  if (found.nodes == 0) return "";
  std::string line =
      fmt::format("{} contact node{} overlap{} another body at the start, deepest {:.4g} at node {}: {}", found.nodes,
                  found.nodes == 1 ? "" : "s", found.nodes == 1 ? "s" : "", found.deepest,
                  impl_->node_ids[static_cast<std::size_t>(found.deepest_node)],
                  impl_->overlap == ContactDeck::Overlap::accept ? "accepted as the reference" : "pushed out slowly");
  if (found.too_deep > 0)
    line += fmt::format("; {} of them lie deeper than a quarter of a face and are not in contact", found.too_deep);
  return line;
}

ContactReport ContactStage::apply(const ContactMotion& motion) {
  Impl& stage = *impl_;
  const SurfaceMotion predicted{motion.x, motion.v, motion.dt};
  ContactReport report;
  stage.clear_last_impulse(motion);
  report.searched = stage.search(predicted);
  report.candidates = stage.memory.candidates.num_pairs;
  stage.check(predicted);
  stage.system.num_nodes = 0;
  stage.system.num_rows = 0;
  stage.enforce(motion, report);
  stage.last_dt = motion.dt;
  return report;
}

int ContactStage::contact_nodes() const { return impl_->surface.num_nodes; }
int ContactStage::contact_faces() const { return impl_->surface.num_faces; }
long ContactStage::searches() const { return impl_->searches; }
const ContactSeconds& ContactStage::seconds() const { return impl_->seconds; }

double ContactStage::measure_penetration(Rows3<const double> x) const {
  return find_deepest_penetration(impl_->surface, impl_->walls, x);
}

}  // namespace percuss
