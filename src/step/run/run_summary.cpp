#include "src/step/run/run_summary.hpp"

#include <fmt/format.h>

#include "kernels/core/host_copy.hpp"
#include "src/step/run/run_totals.hpp"

namespace percuss {
namespace {

void fill_contact_summary(const SummedRun& run, Summary& summary) {
  if (!run.contact.is_active()) return;
  const DecompositionReport done = run.contact.decomposition();
  if (run.steps > 0) {
    const auto steps = static_cast<double>(run.steps);
    summary.skipped.searches = 1 - static_cast<double>(run.contact.searches()) / steps;
    summary.skipped.enforcements = 1 - static_cast<double>(run.contact.enforcements()) / steps;
    summary.skipped.rebalances = 1 - static_cast<double>(done.rebalances) / steps;
  }
  const PairCounts own = run.contact.pair_counts();
  const std::int64_t candidates = sum_counts(run.model.ranks, own.candidates),
                     left_out = sum_counts(run.model.ranks, own.left_out);
  if (candidates > 0) summary.skipped.pair_checks = static_cast<double>(left_out) / static_cast<double>(candidates);
  const WallCounts walls = run.contact.wall_counts();
  const std::int64_t pairs = sum_counts(run.model.ranks, walls.pairs),
                     looked_at = sum_counts(run.model.ranks, walls.looked_at);
  if (pairs > 0) summary.skipped.wall_looks = 1 - static_cast<double>(looked_at) / static_cast<double>(pairs);
  summary.balance.contact = done.imbalance;
  summary.decomposition = {done.rebalances, done.ghost_faces, done.worst_imbalance, done.rounds_per_cut};
}

void fill_skipped_chunks(const SummedRun& run, Summary& summary) {
  std::int64_t skipped = 0;
  const auto by_chunk = to_host(run.state.results.skipped);
  for (std::size_t c = 0; c < by_chunk.extent(0); ++c) skipped += by_chunk(c);
  skipped = sum_counts(run.model.ranks, skipped);
  const double updates = static_cast<double>(run.chunked.numbering.chunk_count()) * static_cast<double>(run.steps);
  if (updates > 0) summary.skipped.chunk_updates = static_cast<double>(skipped) / updates;
}

void fill_messages(const SummedRun& run, Summary& summary) {
  const Communicator& ranks = run.model.ranks;
  const Traffic halo = run.stepper.traffic(), contact = run.contact.traffic();
  const Traffic traffic = sum_traffic(ranks, {halo.messages + contact.messages, halo.bytes + contact.bytes});
  if (run.steps == 0) return;
  const double rank_steps = static_cast<double>(run.steps) * ranks.size();
  summary.messages = {static_cast<double>(traffic.messages) / rank_steps,
                      static_cast<double>(traffic.bytes) / rank_steps};
}

}  // namespace

void fill_scene(const SummedRun& run, Summary& summary) {
  const Numbering& numbering = run.chunked.numbering;
  summary.version = PERCUSS_VERSION;
  summary.backend = ExecSpace::name();
  summary.ranks = run.model.ranks.size();
  summary.threads = ExecSpace().concurrency();
  summary.elements = numbering.element_count();
  summary.nodes = numbering.node_count();
  summary.steps = run.state.step;
  summary.time = run.state.time;
  if (!run.contact.is_active()) return;
  summary.contact_nodes = run.contact.contact_nodes();
  summary.contact_faces = run.contact.contact_faces();
}

void fill_summary(const SummedRun& run, Summary& summary) {
  const Communicator& ranks = run.model.ranks;
  const Numbering& numbering = run.chunked.numbering;
  fill_scene(run, summary);
  const StepEstimateReport estimates = run.stepper.step_estimates();
  summary.dt.estimate = run.stepper.estimates_steps() ? "global" : "element";
  summary.dt.estimates = estimates.count;
  summary.dt.gain = estimates.gain;
  for (const AddedMass& part : run.model.added_masses) summary.mass.added += part.added;
  const double before = run.model.total_mass - summary.mass.added;
  summary.mass.in_run = run.state.books.added_mass;
  summary.mass.energy = run.state.books.added_energy;
  summary.mass.added += summary.mass.in_run;
  summary.mass.share = summary.mass.added / before;
  summary.phases_s = run.stepper.read_clocks().wall();
  summary.peak_bytes = find_peak_bytes();
  take_largest(ranks, summary);
  const double work = static_cast<double>(summary.elements) * static_cast<double>(run.steps);
  if (work > 0) summary.grind_ns = 1e9 * summary.loop_s * summary.ranks * summary.threads / work;
  fill_skipped_chunks(run, summary);
  fill_contact_summary(run, summary);
  summary.balance.elements = find_element_balance(numbering, ranks.size());
  fill_messages(run, summary);
  summary.energy = run.audited.energy;
  summary.momentum = run.audited.momentum;
  summary.eroded = run.audited.eroded;
  summary.state_hash = fmt::format("{:016x}", hash_state(run.model, run.state));
}

RankRow make_rank_row(const SummedRun& run) {
  RankRow row;
  row.rank = run.model.ranks.rank();
  row.elements = static_cast<std::int64_t>(run.chunked.mesh.elements.size());
  row.nodes = static_cast<std::int64_t>(run.chunked.mesh.nodes.size());
  const SearchLoad load = run.contact.load();
  row.contact_nodes = load.nodes;
  row.contact_faces = load.faces;
  row.compute = run.stepper.read_clocks().compute();
  row.compute_loop = run.compute_s;
  if (run.steps == 0) return row;
  const auto steps = static_cast<double>(run.steps);
  const Traffic halo = run.stepper.traffic(), contact = run.contact.traffic();
  row.halo_messages = static_cast<double>(halo.messages) / steps;
  row.halo_bytes = static_cast<double>(halo.bytes) / steps;
  row.contact_messages = static_cast<double>(contact.messages) / steps;
  row.contact_bytes = static_cast<double>(contact.bytes) / steps;
  return row;
}

}  // namespace percuss
