#include "src/step/run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <csignal>
#include <memory>
#include <optional>

#include "comm/agreement.hpp"
#include "comm/rendezvous.hpp"
#include "src/contact/contact_stage.hpp"
#include "src/fail_together.hpp"
#include "src/mesh/decompose.hpp"
#include "src/output/warning_log.hpp"
#include "src/step/audit.hpp"
#include "src/step/checkpoint.hpp"
#include "src/step/erosion.hpp"
#include "src/step/mass_scaling.hpp"
#include "src/step/phases.hpp"
#include "src/step/run_checkpoints.hpp"
#include "src/step/run_checks.hpp"
#include "src/step/run_notes.hpp"
#include "src/step/run_output.hpp"
#include "src/step/run_summary.hpp"
#include "src/step/run_totals.hpp"
#include "src/step/step.hpp"
#include "src/step/turned_corners.hpp"
#include "src/step/whole_mesh.hpp"

namespace percuss {

namespace {

volatile std::sig_atomic_t stop_requested = 0;

/// Energy and momentum are judged at least this often, also without output.
constexpr long steps_between_audits = 500;

using Clock = std::chrono::steady_clock;

double find_seconds(Clock::time_point since) { return std::chrono::duration<double>(Clock::now() - since).count(); }

/// Everything a run holds between its start and its summary.
class Run {
 public:
  Run(const Deck& deck, const RunOptions& options);
  RunResult operator()();

 private:
  bool speaks() const { return ranks_.rank() == 0 && options_.progress != Progress::Style::quiet; }
  void say(const std::vector<std::string>& lines) const;
  void tell(const Warning& warning);
  void say_or_warn(const StartNotice& notice);
  ChunkedMesh load_scene();
  void begin();
  void restart();
  void restore_warnings(const CheckpointHeader& header);
  void open_files();
  bool is_finished() const;
  void loop();
  void advance();
  void erode();
  void observe();
  void observe_last();
  void look_at_corners();
  void audit();
  void note_contact();
  void check_step_made() const;
  CheckedRun seen() const { return {deck_, chunked_, model_, state_, stepper_}; }
  StepWishes find_wishes() const;
  void archive(CheckpointArchive& archive);
  std::string write_run_warnings() const;
  void write_checkpoint();
  long steps_done() const { return state_.step - start_step_; }
  void finish(const std::string& status, const std::string& error);
  SummedRun summed() const {
    return {chunked_, model_, state_, stepper_, contact_, audited_, steps_done(), compute_seconds() - compute_start_};
  }
  void fail(const std::exception& error);
  void write_failed_state();
  ProgressState find_progress() const;

  const Deck& deck_;
  RunOptions options_;
  Clock::time_point setup_start_ = Clock::now();
  const Communicator ranks_ = Communicator::world();
  std::optional<Progress> progress_;  // once the scene is read
  WarningLog log_;
  Rendezvous rendezvous_{ranks_};
  ChunkedMesh chunked_;
  Model model_;
  ContactStage contact_;
  State state_;
  Stepper stepper_;
  Erosion erosion_;
  Audit audit_;
  AuditResult audited_;
  long audited_step_ = -1;
  RunOutput output_;
  RunCheckpoints checkpoints_;
  bool is_state_whole_ = true;  // false while a step is made
  long start_step_ = 0;         // where this run began
  double first_dt_ = 0;
  std::int64_t limiting_element_id_ = 0;  // bounded the last step
  std::size_t input_warnings_ = 0;        // of log_: those that a restart finds again
  Clock::time_point loop_start_;
  double compute_start_ = 0;  // compute_seconds() when the clocks of the phases began
  Summary summary_;
};

Run::Run(const Deck& deck, const RunOptions& options)
    : deck_(deck),
      options_(options),
      log_(deck.silenced, [this](const Warning& warning) { tell(warning); }),
      chunked_(load_scene()),
      model_(build_model(deck, chunked_)),
      contact_(chunked_, deck, ranks_),
      state_(make_initial_state(model_)),
      stepper_(deck, chunked_, model_, contact_),
      erosion_(deck, chunked_, model_, contact_),
      audit_(model_),
      output_(deck, chunked_, model_, contact_, options.out_dir),
      checkpoints_(deck, options.out_dir) {
  progress_.emplace(stderr, ranks_.rank() == 0 ? options.progress : Progress::Style::quiet);
  log_.add(find_start_warnings(chunked_, ranks_.size()));
  input_warnings_ = log_.list().size();
  say(describe_added_masses(model_));
  if (options.restart.empty()) {
    begin();
  } else {
    restart();
  }
  open_files();  // last: to close a file that several ranks write takes all of them, should one fail alone
  summary_.setup_s = find_seconds(setup_start_);
}

/// Tells what is known before the mesh, which may be refused. Of the members above the mesh only.
ChunkedMesh Run::load_scene() {
  log_.add(deck_.warnings);
  log_.add(options_.warnings);
  return load_mesh(deck_, ranks_);
}

void Run::begin() {
  if (contact_.is_active()) say_or_warn(contact_.prepare(state_.x, state_.v));
  say(contact_.start_notes());
  compute_start_ = compute_seconds();
  stepper_.start(state_, {stop_requested != 0, false});
  erode();
  first_dt_ = state_.next_dt;
  limiting_element_id_ = state_.bound.element_id;
  checkpoints_.begin(state_.time);  // none at time 0
}

void Run::restart() {
  CheckpointReader reader(options_.restart, chunked_, ranks_);
  check_checkpoint_header(options_.restart, reader.header(), make_checkpoint_header(deck_, chunked_, model_, state_),
                          deck_);
  archive(reader);
  restore_warnings(reader.header());
  if (deck_.time.end < state_.time * (1 - 1e-12)) {
    throw InputError(fmt::format("{}: error: time.end is {:g}, before the checkpoint's time {:g} (a run goes forward)",
                                 deck_.file, deck_.time.end, state_.time));
  }
  complete_state(chunked_, model_, state_);
  compute_start_ = compute_seconds();
  stepper_.resume(state_);
  start_step_ = state_.step;
  checkpoints_.note(options_.restart, state_);
  if (speaks()) print_quietly(stderr, "goes on from step {}, t = {:.6g}\n", state_.step, state_.time);
}

void Run::say(const std::vector<std::string>& lines) const {
  if (!speaks()) return;
  for (const std::string& line : lines) print_quietly(stderr, "{}\n", line);
}

/// Warnings are rank 0's to tell, and never hidden.
void Run::tell(const Warning& warning) {
  if (ranks_.rank() != 0) return;
  if (progress_) progress_->clear();
  print_quietly(stderr, "{}\n", format_warning(warning));
}

void Run::say_or_warn(const StartNotice& notice) {
  if (notice.is_warning()) {
    log_.add({notice.rule, notice.text, "", state_.time, 1});
  } else if (!notice.text.empty()) {
    say({notice.text});
  }
}

/// What the run warned of before its checkpoint and is not found again.
void Run::restore_warnings(const CheckpointHeader& header) {
  try {
    log_.restore(read_warnings(header.warnings));
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}: error: the warnings in it cannot be read ({})", options_.restart, error.what()));
  }
}

void Run::open_files() {
  if (!options_.out_dir.empty() && deck_.output.history_every) {
    find_history_points(deck_, chunked_);  // an unknown id is told before earlier results go
  }
  if (options_.goes_on_in_place) {
    output_.check_earlier();
    output_.go_on();
    return;
  }
  fail_together(ranks_, [&] {
    if (ranks_.rank() == 0 && options_.prepare_output) options_.prepare_output();
  });
  output_.create();
}

bool Run::is_finished() const {
  return deck_.time.end - state_.time <= 1e-12 * deck_.time.end ||
         (deck_.time.max_steps && state_.step >= *deck_.time.max_steps);
}

void Run::loop() {
  if (options_.restart.empty()) {
    summary_.dt.min = first_dt_;
    check_step_made();
    audit();  // what later audits compare with, whatever the output
    observe();
  }
  while (!is_finished() && !stepper_.is_stop_agreed()) advance();
  // The checkpoint goes before the last row and frame, which a run that goes on does not have.
  const bool is_interrupted = !is_finished();
  if (checkpoints_.step() != state_.step && (is_interrupted || checkpoints_.are_wanted())) write_checkpoint();
  observe_last();
}

/// A step, and all that is due after it.
void Run::advance() {
  limiting_element_id_ = state_.bound.element_id;
  is_state_whole_ = false;
  stepper_.advance(state_, find_wishes());
  is_state_whole_ = true;
  summary_.dt.min = std::min(summary_.dt.min, state_.dt);
  summary_.dt.max = std::max(summary_.dt.max, state_.dt);
  note_contact();
  check_step_made();
  erode();
  observe();
  if (stepper_.is_checkpoint_agreed() || checkpoints_.is_due(state_.time)) write_checkpoint();
  if (!is_finished() && !stepper_.is_stop_agreed()) progress_->report(find_progress());  // finish() has the last word
}

/// (1.1) Redefine the contact surface: where elements have died, everything else follows before the state is looked at.
void Run::erode() {
  if (!state_.bound.died) return;
  PhaseClock& clock = stepper_.clocks().reduce;
  const PhaseClock before = contact_.clocks().sum();
  {
    const Phase phase("percuss::erosion", clock);
    erosion_.redefine(state_, stepper_.bookkeeper());
    if (!deck_.pressures.empty() || !deck_.nodal_loads.empty()) stepper_.renew_loads(state_);
  }
  clock += before;  // contact has phases of its own
  clock -= contact_.clocks().sum();
}

StepWishes Run::find_wishes() const {
  StepWishes wishes;
  wishes.stop = stop_requested != 0;
  wishes.checkpoint = ranks_.rank() == 0 && checkpoints_.is_clock_due();
  return wishes;
}

void Run::note_contact() {
  if (!stepper_.contact_report().converged) log_.add(describe_unconverged(state_.time));
}

void Run::audit() {
  if (audited_step_ == state_.step) return;
  const Phase phase("percuss::reduce", stepper_.clocks().reduce);
  audited_ = audit_(state_);
  audited_step_ = state_.step;
}

/// Audit and output of a state, where they are due. A row of the history is written before the balance is judged, so
/// that it shows what grew; a frame only after.
void Run::observe() {
  const bool row_due = output_.is_row_due(state_.time), frame_due = output_.is_frame_due(state_.time);
  if (!row_due && !frame_due && state_.step % steps_between_audits != 0) return;
  audit();
  const Phase phase("percuss::output", stepper_.clocks().output);
  if (row_due) output_.write_row(state_, audited_, stepper_);
  check_balance(seen(), audited_);
  if (frame_due) output_.write_frame(state_);
  if (frame_due) look_at_corners();
  output_.advance(state_.time);
}

void Run::look_at_corners() {
  const std::vector<std::int64_t> counts = count_turned_corners(chunked_, model_, state_);
  for (const Warning& warning : describe_turned_corners(counts, chunked_.mesh.parts, state_.time)) log_.renew(warning);
}

/// The same of the last state, due or not.
void Run::observe_last() {
  audit();
  const Phase phase("percuss::output", stepper_.clocks().output);
  output_.write_row(state_, audited_, stepper_);
  look_at_corners();
  check_balance(seen(), audited_);
  output_.write_frame(state_);
}

void Run::check_step_made() const {
  check_elements(seen());
  if (!is_finished()) check_step(seen(), first_dt_);
}

/// Everything that a run needs to go on as if it had never stopped.
void Run::archive(CheckpointArchive& archive) {
  archive_state(archive, chunked_, model_, state_);
  if (archive.is_loading() && model_.can_erode) erosion_.restore(state_);
  stepper_.archive(archive);
  audit_.archive(archive);
  output_.archive(archive, state_.time);
  archive.number("run/first_dt", first_dt_);
  archive.number("run/dt_min", summary_.dt.min);
  archive.number("run/dt_max", summary_.dt.max);
  archive.number("run/limiting_element_id", limiting_element_id_);
  archive.integer("run/audited_step", audited_step_);
  audited_.archive(archive);
}

/// All but those that a restart finds again.
std::string Run::write_run_warnings() const {
  const auto first = log_.list().begin() + static_cast<std::ptrdiff_t>(input_warnings_);
  return write_warnings({first, log_.list().end()});
}

void Run::write_checkpoint() {
  if (options_.out_dir.empty()) return;
  const Phase phase("percuss::output", stepper_.clocks().output);
  output_.sync();
  CheckpointHeader header = make_checkpoint_header(deck_, chunked_, model_, state_);
  header.warnings = broadcast_text(ranks_, write_run_warnings(), 0);
  checkpoints_.write(header, chunked_, ranks_, state_, [&](CheckpointArchive& to) { archive(to); });
}

ProgressState Run::find_progress() const {
  return {state_.step,
          state_.time,
          deck_.time.end,
          state_.dt,
          audited_.energy.error,
          stepper_.contact_report().interactions,
          state_.books.eroded_elements};
}

/// Collective.
void Run::finish(const std::string& status, const std::string& error) {
  summary_.status = status;
  summary_.error = error;
  summary_.dt.last = state_.dt;
  summary_.dt.element = limiting_element_id_;
  summary_.loop_s = find_seconds(loop_start_);
  const std::vector<RankRow> rows = gather_rows(ranks_, make_rank_row(summed()));
  fill_summary(summed(), summary_);
  progress_->finish(find_progress());
  log_.add(find_end_warnings(summary_));
  summary_.warnings = log_.list();
  fail_together(ranks_, [&] {
    if (ranks_.rank() != 0 || options_.out_dir.empty()) return;
    write_ranks(options_.out_dir + "/ranks.csv", rows);
    write_summary(options_.out_dir + "/summary.json", summary_);
  });
}

/// The state in which a run failed, if it can be looked at: a row and a frame more.
void Run::write_failed_state() {
  if (!is_state_whole_) return;
  output_.write_row(state_, audit_(state_), stepper_);
  if (!has_finite_positions(model_, state_)) return;
  output_.write_frame(state_);
  if (speaks() && !options_.out_dir.empty() && deck_.output.fields_every)
    print_quietly(stderr, "the last frame is the state that failed, t = {:.6g}; the one before it is sound\n",
                  state_.time);
}

/// Writes what there is of a failed run, if all ranks have come here; only then may they talk to each other.
void Run::fail(const std::exception& error) {
  if (!rendezvous_.meet()) {
    if (options_.end_all_ranks) options_.end_all_ranks();
    ranks_.abort(static_cast<int>(ExitCode::system_failed));
  }
  try {
    if (dynamic_cast<const RunError*>(&error) != nullptr) write_failed_state();
    finish("failed", error.what());
    output_.close();
  } catch (const std::exception& second) {  // a full disk must not hide why the run failed, and is told once
    if (ranks_.rank() == 0 && dynamic_cast<const SystemError*>(&error) == nullptr)
      print_quietly(stderr, "percuss: error: {}\n", second.what());
  }
  if (!speaks() || options_.out_dir.empty()) return;
  print_quietly(stderr, "results: {}\n", options_.out_dir);
  if (const std::string hint = checkpoints_.describe(); !hint.empty()) say({hint});
  if (const std::string hint = describe_warnings(summary_, options_.out_dir); !hint.empty()) say({hint});
}

RunResult Run::operator()() {
  loop_start_ = Clock::now();
  try {
    ranks_.mark_profiled(true);
    loop();
    ranks_.mark_profiled(false);
    output_.close();
  } catch (const std::exception& error) {
    fail(error);
    throw;
  }
  const bool interrupted = stepper_.is_stop_agreed() && !is_finished();
  finish(interrupted ? "interrupted" : "completed", "");
  return {interrupted ? ExitCode::interrupted : ExitCode::done, summary_, checkpoints_.path()};
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
