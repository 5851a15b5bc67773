#include "src/contact/enforcer.hpp"

#include "kernels/contact/row_solution.hpp"
#include "kernels/core/host_copy.hpp"

namespace percuss {
namespace {

/// Shared nodes with their owners as the mesh numbers them.
SharedNodes find_copies(const ContactRanks& ranks) {
  UnstructuredExchange exchange(ranks.ranks);
  SharedNodes shared = find_shared_nodes(exchange, ranks.mesh.node_numbers);
  for (std::size_t n = 0; n < shared.owners.size(); ++n) {
    shared.owners[n] = ranks.numbering.find_node_owner(ranks.mesh.node_numbers[n]);
  }
  return shared;
}

}  // namespace

Enforcer::Enforcer(const ContactRanks& ranks, const WallPairs& walls)
    : walls_(walls),
      node_numbers_(to_view("contact::mesh_node_numbers", ranks.mesh.node_numbers)),
      has_many_ranks_(ranks.ranks.size() > 1),
      exchange_(ranks),
      copied_(find_copies(ranks)),
      velocity_copies_(ranks.ranks, copied_),
      impulse_copies_(ranks.ranks, copied_) {}

void Enforcer::clear_last_impulse(const ContactMotion& motion) {
  // Only the nodes of the last step's rows can be set, if it is the same memory; copies of them are not listed.
  if (last_impulse_ != motion.impulse.data() || (was_pushed_ && has_many_ranks_)) {
    Kokkos::deep_copy(ExecSpace(), motion.impulse, 0.0);
  } else if (was_pushed_) {
    run_where_it_pays(system_.num_nodes / 10,
                      [&](const auto& space) { clear_impulses(space, system_, motion.impulse); });
  }
  last_impulse_ = motion.impulse.data();
  was_pushed_ = false;
}

/// Copies of nodes on other ranks get what their owners found.
void Enforcer::update_copies(const ContactMotion& motion) {
  if (!has_many_ranks_) return;
  velocity_copies_.begin(ExecSpace(), motion.v);
  impulse_copies_.begin(ExecSpace(), motion.impulse);
  velocity_copies_.end(ExecSpace(), motion.v);
  impulse_copies_.end(ExecSpace(), motion.impulse);
}

void Enforcer::rest(const ContactMotion& motion, const ContactHistory& history) {
  clear_last_impulse(motion);
  last_dt_ = motion.dt;
  if (remembers_) Kokkos::deep_copy(history.face, std::int64_t{-1});
  remembers_ = false;
}

void Enforcer::enforce(const ContactMotion& motion, const Array<const RowTouch>& touches, int num_touches,
                       const ContactHistory& history, ContactReport& report) {
  clear_last_impulse(motion);
  const RowInputs inputs{{motion.x, motion.v, motion.dt},
                         motion.v_before,
                         motion.inverse_mass,
                         node_numbers_,
                         last_dt_ > 0 ? motion.dt / last_dt_ : 1};
  last_dt_ = motion.dt;
  remembers_ = true;
  exchange_.announce_foreign_nodes(touches, num_touches, system_);
  const int wall_pairs = static_cast<int>(walls_.node.extent(0));
  // A row's solution costs some dozen passes; a wall's pair that is out of reach costs one look.
  run_where_it_pays(num_touches + wall_pairs / 8, [&](const auto& space) {
    build_rows(space, inputs, touches, num_touches, walls_, history, system_, exchange_);
    const SolveReport solved = solve_rows(space, motion.dt, system_, sums_, exchange_);
    if (solved.rows > 0) {
      apply_impulses(space, system_, motion.v, motion.impulse);
      EnforcementSums done = sum_outcome(space, motion.dt, system_, sums_);
      exchange_.reduce(done);
      report.iterations = solved.iterations;
      report.converged = solved.converged;
      report.interactions = static_cast<int>(done.pushes);
      report.normal_work = done.normal_work.round();
      report.friction_work = done.friction_work.round();
      report.residual = done.residual;
      report.deepest = done.deepest;
      report.deepest_node = done.deepest_key < 0 ? -1 : find_key_node(done.deepest_key);
      update_copies(motion);
      was_pushed_ = true;
    }
    write_history(space, motion.dt, system_, history);
    space.fence();
  });
}

}  // namespace percuss
