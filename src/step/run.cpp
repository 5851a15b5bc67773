#include "src/step/run.hpp"

#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <csignal>
#include <memory>
#include <optional>

#include "comm/rendezvous.hpp"
#include "kernels/core/host_copy.hpp"
#include "src/contact/contact_stage.hpp"
#include "src/fail_together.hpp"
#include "src/mesh/decompose.hpp"
#include "src/step/audit.hpp"
#include "src/step/frames.hpp"
#include "src/step/history.hpp"
#include "src/step/phases.hpp"
#include "src/step/run_totals.hpp"
#include "src/step/step.hpp"
#include "src/step/whole_mesh.hpp"

namespace percuss {

namespace {

volatile std::sig_atomic_t stop_requested = 0;

/// The energy is judged at least this often, also without output.
constexpr long steps_between_audits = 500;

using Clock = std::chrono::steady_clock;

double find_seconds(Clock::time_point since) { return std::chrono::duration<double>(Clock::now() - since).count(); }

/// Due at multiples of a period; never twice for one state.
class Schedule {
 public:
  explicit Schedule(std::optional<double> period) : period_(period) {}
  bool is_due(double time) const { return period_ && time >= next_ * (1 - 1e-12); }
  void advance(double time) {
    if (period_ && *period_ > 0) next_ = *period_ * (std::floor(time / *period_ * (1 + 1e-12)) + 1);
  }

 private:
  std::optional<double> period_;
  double next_ = 0;
};

/// Everything a run holds between its start and its summary.
class Run {
 public:
  Run(const Deck& deck, const RunOptions& options);
  RunResult operator()();

 private:
  bool speaks() const { return ranks_.rank() == 0 && options_.progress != Progress::Style::quiet; }
  void warn_about_idle_ranks() const;
  void open_files();
  bool is_finished() const;
  void loop();
  void observe(bool is_last);
  void note_contact();
  std::string describe_element(std::int64_t number) const;
  std::string describe_deepest_node() const;
  void check_elements() const;
  void check_energy() const;
  void finish(const std::string& status, const std::string& error);
  void fill_summary();
  void fill_contact_summary();
  RankRow make_rank_row() const;
  void fail(const std::string& error);
  ProgressState find_progress() const;

  const Deck& deck_;
  RunOptions options_;
  Clock::time_point setup_start_ = Clock::now();
  const Communicator ranks_ = Communicator::world();
  Rendezvous rendezvous_{ranks_};
  ChunkedMesh chunked_;
  Model model_;
  ContactStage contact_;
  State state_;
  Stepper stepper_;
  Audit audit_;
  AuditResult audited_;
  std::optional<Frames> frames_;
  std::optional<History> history_;
  Schedule frame_schedule_, history_schedule_;
  double first_dt_ = 0;
  std::int64_t limiting_element_id_ = 0;  // bounded the last step
  long unconverged_steps_ = 0;            // of the contact enforcement
  long first_unconverged_ = -1;           // the first such step
  Clock::time_point loop_start_;
  double compute_start_ = 0;  // compute_seconds() when the clocks of the phases began
  std::string contact_notice_;
  Progress progress_;
  Summary summary_;
};

Run::Run(const Deck& deck, const RunOptions& options)
    : deck_(deck),
      options_(options),
      chunked_(load_mesh(deck, ranks_)),
      model_(build_model(deck, chunked_)),
      contact_(chunked_, deck, ranks_),
      state_(make_initial_state(model_)),
      stepper_(deck, chunked_, model_, contact_),
      audit_(model_),
      frame_schedule_(deck.output.fields_every),
      history_schedule_(deck.output.history_every),
      progress_(stderr, ranks_.rank() == 0 ? options.progress : Progress::Style::quiet) {
  if (speaks()) {
    for (const std::string& warning : chunked_.mesh.warnings) print_quietly(stderr, "warning: {}\n", warning);
    warn_about_idle_ranks();
  }
  if (contact_.is_active()) contact_notice_ = contact_.prepare(state_.x, state_.v);
  if (!contact_notice_.empty() && speaks()) print_quietly(stderr, "{}\n", contact_notice_);
  compute_start_ = compute_seconds();
  stepper_.start(state_, stop_requested != 0);
  open_files();  // last: to close a file that several ranks write takes all of them, should one fail alone
  first_dt_ = state_.next_dt;
  limiting_element_id_ = state_.bound.element_id;
  summary_.setup_s = find_seconds(setup_start_);
}

void Run::warn_about_idle_ranks() const {
  const int idle = count_idle_ranks(chunked_.numbering, ranks_.size());
  if (idle == 0) return;
  print_quietly(stderr,
                "warning: {} of {} ranks have no elements (the mesh has {} chunks, and a chunk is never divided) start "
                "it on fewer ranks\n",
                idle, ranks_.size(), chunked_.numbering.chunk_count());
}

void Run::open_files() {
  if (!options_.out_dir.empty() && deck_.output.history_every) {
    find_history_points(deck_, chunked_);  // an unknown id is told before earlier results go
  }
  fail_together(ranks_, [&] {
    if (ranks_.rank() == 0 && options_.prepare_output) options_.prepare_output();
  });
  if (options_.out_dir.empty()) return;
  if (deck_.output.history_every) history_.emplace(options_.out_dir, deck_, chunked_);
  if (deck_.output.fields_every) frames_.emplace(options_.out_dir, deck_, chunked_, model_, contact_);
}

bool Run::is_finished() const {
  return deck_.time.end - state_.time <= 1e-12 * deck_.time.end ||
         (deck_.time.max_steps && state_.step >= *deck_.time.max_steps);
}

void Run::loop() {
  summary_.dt.min = first_dt_;
  check_elements();
  audited_ = audit_(state_);  // what later audits compare with, whatever the output
  observe(false);
  while (!is_finished() && !stepper_.is_stop_agreed()) {
    limiting_element_id_ = state_.bound.element_id;
    stepper_.advance(state_, stop_requested != 0);
    summary_.dt.min = std::min(summary_.dt.min, state_.dt);
    summary_.dt.max = std::max(summary_.dt.max, state_.dt);
    note_contact();
    check_elements();
    const bool is_last = is_finished() || stepper_.is_stop_agreed();
    observe(is_last);
    if (!is_last) progress_.report(find_progress());  // finish() has the last word
  }
}

void Run::note_contact() {
  if (stepper_.contact_report().converged) return;
  if (unconverged_steps_++ == 0) first_unconverged_ = state_.step;
}

/// Audit and output of a state, where they are due. A row of the history is written before the energy is judged, so
/// that it shows what grew; a frame only after.
void Run::observe(bool is_last) {
  const bool history_due = history_schedule_.is_due(state_.time);
  const bool frame_due = frame_schedule_.is_due(state_.time);
  if (!history_due && !frame_due && !is_last && state_.step % steps_between_audits != 0) return;
  {
    const Phase phase("percuss::reduce", stepper_.clocks().reduce);
    audited_ = audit_(state_);
  }
  const Phase phase("percuss::output", stepper_.clocks().output);
  if (history_ && (history_due || is_last)) {
    history_->write(model_, state_, audited_, stepper_.contact_report(), stepper_.find_wall_force());
  }
  check_energy();
  if (frames_ && (frame_due || is_last)) {
    frames_->write(state_);
    if (history_) history_->flush();
  }
  history_schedule_.advance(state_.time);
  frame_schedule_.advance(state_.time);
}

/// In the words of the rank that has it. Collective.
std::string Run::describe_element(std::int64_t number) const {
  const int element = find_local_element(chunked_, number);
  std::string text;
  if (element >= 0) {
    const auto e = static_cast<std::size_t>(element);
    const auto x = to_host(state_.x);
    double center[3] = {0, 0, 0};
    for (const int n : chunked_.mesh.elements[e]) {
      for (int k = 0; k < 3; ++k) center[k] += x(static_cast<std::size_t>(n), static_cast<std::size_t>(k)) / 8;
    }
    text = fmt::format("{} at ({:.6g}, {:.6g}, {:.6g})", name_element(chunked_.mesh, element), center[0], center[1],
                       center[2]);
  }
  return broadcast_text(ranks_, text, chunked_.numbering.find_element_owner(number));
}

/// Empty if no contact node lies deep. Collective.
std::string Run::describe_deepest_node() const {
  const std::int64_t number = stepper_.contact_report().deepest_node;
  if (number < 0) return "";
  const int node = find_local_node(chunked_, number);
  const std::int64_t id = node < 0 ? 0 : chunked_.mesh.node_ids[static_cast<std::size_t>(node)];
  return broadcast_text(ranks_, fmt::format("; the deepest contact node is {}", id),
                        chunked_.numbering.find_node_owner(number));
}

void Run::check_elements() const {
  if (state_.bound.failed_element >= 0) {
    throw RunError(fmt::format(
        "{} has inverted or is not finite any more, in step {} at t = {:.6g} (the mesh is crushed beyond what it can "
        "follow, or the run is unstable); try a finer mesh there, a stronger material, or a smaller time.step_scale "
        "(now {})",
        describe_element(state_.bound.failed_element), state_.step, state_.time, deck_.time.step_scale));
  }
  if (state_.next_dt < deck_.time.collapse_ratio * first_dt_ && !is_finished() &&
      deck_.time.step_scale * state_.bound.step < deck_.time.collapse_ratio * first_dt_) {
    throw RunError(fmt::format(
        "the time step has collapsed to {:.3g} (it began at {:.3g}) in step {} at t = {:.6g}; {} controls it; try a "
        "coarser mesh there, or lower time.collapse_ratio (now {:g}) to go on",
        state_.next_dt, first_dt_, state_.step, state_.time, describe_element(state_.bound.element),
        deck_.time.collapse_ratio));
  }
}

void Run::check_energy() const {
  const double error = audited_.energy.error;
  if (std::abs(error) <= deck_.audit.max_energy_error) return;  // false for NaN
  const EnergySummary& e = audited_.energy;
  const std::string limiting = describe_element(state_.bound.element), deepest = describe_deepest_node();
  throw RunError(
      fmt::format("the energy balance is off by {:.3g} of the largest energy, more than audit.max_energy_error = {:g}, "
                  "in step {} at "
                  "t = {:.6g} (kinetic {:.6g}, internal {:.6g}, hourglass {:.6g}, contact {:.6g}; {} has the smallest "
                  "step{}); look "
                  "at history.csv for what grows, try a smaller time.step_scale (now {})",
                  error, deck_.audit.max_energy_error, state_.step, state_.time, e.kinetic, e.internal, e.hourglass,
                  e.contact, limiting, deepest, deck_.time.step_scale));
}

ProgressState Run::find_progress() const {
  return {state_.step, state_.time,           deck_.time.end,
          state_.dt,   audited_.energy.error, stepper_.contact_report().interactions};
}

void Run::fill_summary() {
  summary_.version = PERCUSS_VERSION;
  summary_.backend = ExecSpace::name();
  summary_.ranks = ranks_.size();
  summary_.threads = ExecSpace().concurrency();
  summary_.elements = chunked_.numbering.element_count();
  summary_.nodes = chunked_.numbering.node_count();
  if (contact_.is_active()) {
    summary_.contact_nodes = contact_.contact_nodes();
    summary_.contact_faces = contact_.contact_faces();
  }
  summary_.steps = state_.step;
  summary_.time = state_.time;
  summary_.dt.last = state_.dt;
  summary_.dt.element = limiting_element_id_;
  summary_.loop_s = find_seconds(loop_start_);
  summary_.phases_s = stepper_.clocks().wall();
  summary_.peak_bytes = find_peak_bytes();
  take_largest(ranks_, summary_);
  const double work = static_cast<double>(summary_.elements) * static_cast<double>(state_.step);
  if (work > 0) summary_.grind_ns = 1e9 * summary_.loop_s * summary_.ranks * summary_.threads / work;
  fill_contact_summary();
  summary_.balance.elements = find_element_balance(chunked_.numbering, ranks_.size());
  const Traffic halo = stepper_.traffic(), contact = contact_.traffic();
  const Traffic traffic = sum_traffic(ranks_, {halo.messages + contact.messages, halo.bytes + contact.bytes});
  if (state_.step > 0) {
    const double rank_steps = static_cast<double>(state_.step) * ranks_.size();
    summary_.messages = {static_cast<double>(traffic.messages) / rank_steps,
                         static_cast<double>(traffic.bytes) / rank_steps};
  }
  summary_.energy = audited_.energy;
  summary_.momentum = audited_.momentum;
  summary_.state_hash = fmt::format("{:016x}", hash_state(model_, state_));
}

void Run::fill_contact_summary() {
  if (!contact_.is_active()) return;
  const DecompositionReport done = contact_.decomposition();
  if (state_.step > 0) {
    const auto steps = static_cast<double>(state_.step);
    summary_.skipped.searches = 1 - static_cast<double>(contact_.searches()) / steps;
    summary_.skipped.rebalances = 1 - static_cast<double>(done.rebalances) / steps;
  }
  summary_.balance.contact = done.imbalance;
  summary_.decomposition = {done.rebalances, done.ghost_faces, done.worst_imbalance, done.rounds_per_cut};
}

RankRow Run::make_rank_row() const {
  RankRow row;
  row.rank = ranks_.rank();
  row.elements = static_cast<std::int64_t>(chunked_.mesh.elements.size());
  row.nodes = static_cast<std::int64_t>(chunked_.mesh.nodes.size());
  const SearchLoad load = contact_.load();
  row.contact_nodes = load.nodes;
  row.contact_faces = load.faces;
  row.compute = stepper_.clocks().compute();
  row.compute_loop = compute_seconds() - compute_start_;
  if (state_.step == 0) return row;
  const auto steps = static_cast<double>(state_.step);
  const Traffic halo = stepper_.traffic(), contact = contact_.traffic();
  row.halo_messages = static_cast<double>(halo.messages) / steps;
  row.halo_bytes = static_cast<double>(halo.bytes) / steps;
  row.contact_messages = static_cast<double>(contact.messages) / steps;
  row.contact_bytes = static_cast<double>(contact.bytes) / steps;
  return row;
}

/// Collective.
void Run::finish(const std::string& status, const std::string& error) {
  summary_.status = status;
  summary_.error = error;
  const std::vector<RankRow> rows = gather_rows(ranks_, make_rank_row());
  fill_summary();
  progress_.finish(find_progress());
  if (unconverged_steps_ > 0 && speaks()) {
    print_quietly(
        stderr,
        "warning: the contact enforcement did not converge in {} of {} steps, the first of them step {} (what was "
        "left over is in the column residual of history.csv)\n",
        unconverged_steps_, state_.step, first_unconverged_);
  }
  fail_together(ranks_, [&] {
    if (ranks_.rank() != 0 || options_.out_dir.empty()) return;
    write_ranks(options_.out_dir + "/ranks.csv", rows);
    write_summary(options_.out_dir + "/summary.json", summary_);
  });
}

/// Writes the summary of a failed run, if all ranks have come here; only then may they talk to each other.
void Run::fail(const std::string& error) {
  if (!rendezvous_.meet()) {
    if (options_.end_all_ranks) options_.end_all_ranks();
    ranks_.abort(static_cast<int>(ExitCode::system_failed));
  }
  try {
    finish("failed", error);
  } catch (const std::exception& second) {  // a full disk must not hide why the run failed
    if (ranks_.rank() == 0) print_quietly(stderr, "percuss: error: {}\n", second.what());
  }
}

RunResult Run::operator()() {
  loop_start_ = Clock::now();
  try {
    ranks_.mark_profiled(true);
    loop();
    ranks_.mark_profiled(false);
    if (frames_) frames_->close();
    if (history_) history_->flush();
  } catch (const std::exception& error) {
    fail(error.what());
    throw;
  }
  const bool interrupted = stepper_.is_stop_agreed() && !is_finished();
  finish(interrupted ? "interrupted" : "completed", "");
  return {interrupted ? ExitCode::interrupted : ExitCode::done, summary_};
}

}  // namespace

void request_stop() { stop_requested = 1; }

RunResult run_scene(const Deck& deck, const RunOptions& options) {
  Run run(deck, options);
  const RunResult result = run();
  stop_requested = 0;  // the next run of this process starts afresh
  return result;
}

}  // namespace percuss
