#include "src/step/fluids/fluid_stage.hpp"

#include "comm/exact_reduction.hpp"
#include "kernels/core/host_copy.hpp"
#include "src/index.hpp"
#include "src/output/checkpoint/checkpoint_archive.hpp"
#include "src/step/model/impulses.hpp"

namespace percuss {
namespace {

/// Rows of the chunks of fluids; other chunks have none.
ChunkRows list_rows(const Model& model, const HostMirror<Array<int>>& first) {
  ChunkRows rows;
  rows.counts.resize(at(model.chunks.count), 0);
  const auto list = to_host(model.fluids.list);
  for (std::size_t i = 0; i < list.extent(0); ++i) rows.counts[at(list(i))] = first(i + 1) - first(i);
  return rows;
}

}  // namespace

FluidStage::FluidStage(const ChunkedMesh& chunked, const Model& model)
    : chunked_(chunked),
      model_(model),
      velocity_("percuss::fluid_velocities", at(to_host(model.fluids.first_element)(at(model.fluids.count())))),
      sums_("percuss::centroid_sums", at(model.fluids.count())) {}

void FluidStage::begin_step(const State& /*state*/, const StepTimes& times) { dt_mean_ = times.dt_mean; }

/// Moments of the forces at n; as forces they add up to nothing.
void FluidStage::book_motion(State& state, const StepTimes& times) {
  const CentroidSums of_chunks = sums_;
  const double dt_mean = times.dt_mean;
  const auto moments = moment_sums_(
      ExecSpace(), model_.fluids.count(), KOKKOS_LAMBDA(const int i, const ExactAdder& add) {
        for (int k = 0; k < 3; ++k) add(k, dt_mean * of_chunks(i, CentroidSum::moment + k));
      });
  for (std::size_t k = 0; k < 3; ++k) {
    state.books.moment_impulse[k].merge(moments[k]);
    state.books.moment_impulse[k].normalize();
  }
}

/// dt = 0: what a relaxation has left is not accelerated; what has no pressure yet is, as gravity says.
void FluidStage::advance(State& state, double dt) {
  CentroidMotion motion;
  motion.x = state.x;
  motion.v = state.v;
  motion.dt_mean = dt > 0 ? dt_mean_ : 0;
  const Gravity gravity = find_gravity(model_, state.time + dt);
  for (int k = 0; k < 3; ++k) {
    motion.gravity[k] = gravity.g[k];
    motion.center[k] = model_.mass_center[at(k)];
  }
  motion.mass = state.element_mass;
  motion.failing = model_.failing;
  motion.lives = state.lives;
  apply_centroid_forces(ExecSpace(), model_.chunks, model_.fluids, motion, {velocity_, state.slot_force, sums_});
}

/// Half of the work of the step by the forces at either end. A switch does not change these.
void FluidStage::book_forces(State& state, double dt, double /*time*/, bool takes_gravity) {
  if (takes_gravity) return;
  const CentroidSums of_chunks = sums_;
  const auto work = work_sum_(
      ExecSpace(), model_.fluids.count(), KOKKOS_LAMBDA(const int i, const ExactAdder& add) {
        add(0, 0.5 * dt * (of_chunks(i, CentroidSum::old_power) + of_chunks(i, CentroidSum::power)));
      });
  add_work(work[0], state.books);
  work_.merge(work[0]);
  work_.normalize();
}

void FluidStage::archive(CheckpointArchive& archive, State& state) {
  const FluidChunks& fluids = model_.fluids;
  const auto list = to_host(fluids.list), first_slot = to_host(model_.chunks.first_slot);
  ChunkRows of_slots, of_chunks;
  of_slots.counts.resize(at(model_.chunks.count), 0);
  of_chunks.counts = of_slots.counts;
  std::size_t count = 0;
  for (std::size_t i = 0; i < list.extent(0); ++i) {
    const std::size_t c = at(list(i));
    of_chunks.counts[c] = 1;
    of_slots.counts[c] = first_slot(c + 1) - first_slot(c);
    count += at(first_slot(c + 1) - first_slot(c));
  }
  const std::size_t first = count > 0 ? at(to_host(fluids.first_slot)(0)) : 0;  // they lie one after the other
  archive.rows("fluids/velocity", list_rows(model_, to_host(fluids.first_element)), 3, velocity_);
  archive.rows("fluids/slot_force", of_slots, 3,
               Kokkos::subview(state.slot_force, std::pair(first, first + count), Kokkos::ALL));
  archive.rows("fluids/sums", of_chunks, CentroidSum::count, sums_);
  archive.sum("books/centroid_work", work_);
}

std::vector<HistoryColumn> FluidStage::list_columns() const {
  return {{"centroid_work", dimensions::energy,
           "work of the forces that move weight and inertia of fluids to the centroids of elements, part of external"}};
}

void FluidStage::append_values(const State& /*state*/, std::vector<double>& row) {
  ExactSum work = work_;
  sum_over_ranks(model_.ranks, std::span(&work, 1));
  row.push_back(work.round());
}

}  // namespace percuss
