#include "src/step/run.hpp"

#include <fmt/format.h>
#include <sys/resource.h>

#include <chrono>
#include <cmath>
#include <csignal>
#include <memory>
#include <optional>

#include "kernels/core/host_copy.hpp"
#include "src/contact/contact_stage.hpp"
#include "src/mesh/decompose.hpp"
#include "src/step/audit.hpp"
#include "src/step/frames.hpp"
#include "src/step/history.hpp"
#include "src/step/phases.hpp"
#include "src/step/step.hpp"

namespace percuss {

namespace {

volatile std::sig_atomic_t stop_requested = 0;

/// The energy is judged at least this often, also without output.
constexpr long steps_between_audits = 500;

using Clock = std::chrono::steady_clock;

double find_seconds(Clock::time_point since) { return std::chrono::duration<double>(Clock::now() - since).count(); }

std::int64_t find_peak_bytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<std::int64_t>(usage.ru_maxrss) * 1024;
}

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
  bool is_finished() const;
  void loop();
  void observe(bool is_last);
  void note_contact();
  std::string describe(int element) const;
  void check_elements() const;
  void check_energy() const;
  void finish(const std::string& status, const std::string& error);
  ProgressState find_progress() const;

  const Deck& deck_;
  RunOptions options_;
  Clock::time_point setup_start_ = Clock::now();
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
  int limiting_element_ = 0;     // bounded the last step
  long unconverged_steps_ = 0;   // of the contact enforcement
  long first_unconverged_ = -1;  // the first such step
  Clock::time_point loop_start_;
  std::string contact_notice_;
  Progress progress_;
  Summary summary_;
};

Run::Run(const Deck& deck, const RunOptions& options)
    : deck_(deck),
      options_(options),
      chunked_(load_mesh(deck, Communicator::world())),
      model_(build_model(deck, chunked_)),
      contact_(chunked_, deck, Communicator::world()),
      state_(make_initial_state(model_)),
      stepper_(deck, model_, contact_),
      audit_(model_),
      frame_schedule_(deck.output.fields_every),
      history_schedule_(deck.output.history_every),
      progress_(stderr, options.progress) {
  if (options.progress != Progress::Style::quiet) {
    for (const std::string& warning : chunked_.mesh.warnings) print_quietly(stderr, "warning: {}\n", warning);
  }
  if (contact_.is_active()) contact_notice_ = contact_.prepare(state_.x, state_.v, model_.inverse_mass);
  if (!contact_notice_.empty() && options.progress != Progress::Style::quiet)
    print_quietly(stderr, "{}\n", contact_notice_);
  if (options.prepare_output) options.prepare_output();
  if (!options.out_dir.empty()) {
    if (deck.output.fields_every) frames_.emplace(options.out_dir, deck, chunked_, model_);
    if (deck.output.history_every) history_.emplace(options.out_dir, deck, chunked_.mesh);
  }
  stepper_.start(state_);
  first_dt_ = state_.next_dt;
  summary_.setup_s = find_seconds(setup_start_);
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
  while (!is_finished() && stop_requested == 0) {
    limiting_element_ = state_.bound.element;
    stepper_.advance(state_);
    note_contact();
    check_elements();
    summary_.dt.min = std::min(summary_.dt.min, state_.dt);
    summary_.dt.max = std::max(summary_.dt.max, state_.dt);
    const bool is_last = is_finished() || stop_requested != 0;
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
    const Phase phase("percuss::reduce", stepper_.seconds().reduce);
    audited_ = audit_(state_);
  }
  const Phase phase("percuss::output", stepper_.seconds().output);
  if (history_ && (history_due || is_last)) {
    history_->write(model_, state_, audited_, stepper_.contact_report(), stepper_.wall_force());
  }
  check_energy();
  if (frames_ && (frame_due || is_last)) {
    frames_->write(state_);
    if (history_) history_->flush();
  }
  history_schedule_.advance(state_.time);
  frame_schedule_.advance(state_.time);
}

std::string Run::describe(int element) const {
  const auto e = static_cast<std::size_t>(element);
  const auto x = to_host(state_.x);
  double center[3] = {0, 0, 0};
  for (const int n : chunked_.mesh.elements[e]) {
    for (int k = 0; k < 3; ++k) center[k] += x(static_cast<std::size_t>(n), static_cast<std::size_t>(k)) / 8;
  }
  return fmt::format("element {} of part '{}' at ({:.6g}, {:.6g}, {:.6g})", chunked_.mesh.element_ids[e],
                     chunked_.mesh.parts[static_cast<std::size_t>(chunked_.mesh.element_part[e])].name, center[0],
                     center[1], center[2]);
}

void Run::check_elements() const {
  if (state_.bound.failed_element >= 0) {
    throw RunError(fmt::format(
        "{} has inverted or is not finite any more, in step {} at t = {:.6g} (the mesh is crushed beyond what it can "
        "follow, or the run is unstable); try a finer mesh there, a stronger material, or a smaller time.step_scale "
        "(now {})",
        describe(state_.bound.failed_element), state_.step, state_.time, deck_.time.step_scale));
  }
  if (state_.next_dt < deck_.time.collapse_ratio * first_dt_ && !is_finished() &&
      deck_.time.step_scale * state_.bound.step < deck_.time.collapse_ratio * first_dt_) {
    throw RunError(fmt::format(
        "the time step has collapsed to {:.3g} (it began at {:.3g}) in step {} at t = {:.6g}; {} controls it; try a "
        "coarser mesh there, or lower time.collapse_ratio (now {:g}) to go on",
        state_.next_dt, first_dt_, state_.step, state_.time, describe(state_.bound.element),
        deck_.time.collapse_ratio));
  }
}

void Run::check_energy() const {
  const double error = audited_.energy.error;
  if (std::abs(error) <= deck_.audit.max_energy_error) return;  // false for NaN
  const ContactReport& contact = stepper_.contact_report();
  const std::string deepest = contact.deepest_node < 0
                                  ? std::string()
                                  : fmt::format("; the deepest contact node is {}",
                                                chunked_.mesh.node_ids[static_cast<std::size_t>(contact.deepest_node)]);
  const EnergySummary& e = audited_.energy;
  throw RunError(
      fmt::format("the energy balance is off by {:.3g} of the largest energy, more than audit.max_energy_error = {:g}, "
                  "in step {} at "
                  "t = {:.6g} (kinetic {:.6g}, internal {:.6g}, hourglass {:.6g}, contact {:.6g}; {} has the smallest "
                  "step{}); look "
                  "at history.csv for what grows, try a smaller time.step_scale (now {})",
                  error, deck_.audit.max_energy_error, state_.step, state_.time, e.kinetic, e.internal, e.hourglass,
                  e.contact, describe(state_.bound.element), deepest, deck_.time.step_scale));
}

ProgressState Run::find_progress() const {
  return {state_.step, state_.time,           deck_.time.end,
          state_.dt,   audited_.energy.error, stepper_.contact_report().interactions};
}

void Run::finish(const std::string& status, const std::string& error) {
  summary_.status = status;
  summary_.error = error;
  summary_.version = PERCUSS_VERSION;
  summary_.backend = ExecSpace::name();
  summary_.threads = ExecSpace().concurrency();
  summary_.elements = model_.element_count;
  summary_.nodes = model_.node_count;
  summary_.contact_nodes = contact_.contact_nodes();
  summary_.contact_faces = contact_.contact_faces();
  summary_.steps = state_.step;
  summary_.time = state_.time;
  summary_.dt.last = state_.dt;
  summary_.dt.element = chunked_.mesh.element_ids[static_cast<std::size_t>(limiting_element_)];
  summary_.loop_s = find_seconds(loop_start_);
  const double work = static_cast<double>(model_.element_count) * static_cast<double>(state_.step);
  if (work > 0) summary_.grind_ns = 1e9 * summary_.loop_s * summary_.ranks * summary_.threads / work;
  summary_.phases_s = stepper_.seconds();
  if (contact_.is_active() && state_.step > 0) {
    summary_.skipped.searches = 1 - static_cast<double>(contact_.searches()) / static_cast<double>(state_.step);
  }
  summary_.energy = audited_.energy;
  summary_.momentum = audited_.momentum;
  summary_.peak_bytes = find_peak_bytes();
  summary_.state_hash = fmt::format("{:016x}", hash_state(model_, state_));
  progress_.finish(find_progress());
  if (unconverged_steps_ > 0 && options_.progress != Progress::Style::quiet) {
    fmt::print(
        stderr,
        "warning: the contact enforcement did not converge in {} of {} steps, the first of them step {} (what was "
        "left over is in the column residual of history.csv)\n",
        unconverged_steps_, state_.step, first_unconverged_);
  }
  if (!options_.out_dir.empty()) write_summary(options_.out_dir + "/summary.json", summary_);
}

RunResult Run::operator()() {
  loop_start_ = Clock::now();
  try {
    loop();
    if (frames_) frames_->close();
    if (history_) history_->flush();
  } catch (const std::exception& error) {
    try {
      finish("failed", error.what());
    } catch (const std::exception& second) {  // a full disk must not hide why the run failed
      print_quietly(stderr, "percuss: error: {}\n", second.what());
    }
    throw;
  }
  const bool interrupted = stop_requested != 0 && !is_finished();
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
