#include "src/step/run/run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "src/contact/overlap/start_overlap.hpp"
#include "src/fail_together.hpp"
#include "src/mesh/decomposition/decompose.hpp"
#include "src/mesh/describe_joints.hpp"
#include "src/output/files/atomic_file.hpp"
#include "src/output/files/first_rank.hpp"
#include "src/output/files/safe_text.hpp"
#include "src/step/initial/start_fields.hpp"
#include "src/step/inverted_corners.hpp"
#include "src/step/mass/mass_scaling.hpp"
#include "src/step/model/whole_mesh.hpp"
#include "src/step/phases.hpp"
#include "src/step/restart/checkpoint.hpp"
#include "src/step/restart/mesh_pieces.hpp"
#include "src/step/restart/restart_removals.hpp"
#include "src/step/run/run_scene.hpp"
#include "src/step/run/run_totals.hpp"
#include "src/step/run/stop_request.hpp"

namespace percuss {
namespace {

/// Energy and momentum are judged at least this often, also without output.
constexpr long steps_between_audits = 500;

std::string in_one_line(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c == '\n' || c == '\r'; }, ' ');
  return make_printable(text);
}

}  // namespace

Run::Run(const Deck& deck, const RunOptions& options)
    : deck_(deck),
      options_(options),
      warnings_(deck.silenced, ranks_),
      chunked_(load_scene()),
      model_(build_model(deck, chunked_)),
      contact_(chunked_, deck, ranks_),
      state_(make_initial_state(model_)),
      stepper_(deck, chunked_, model_, contact_),
      erosion_(deck, chunked_, model_, contact_),
      audit_(model_),
      output_(deck, chunked_, model_, contact_, stepper_, options.out_dir),
      checkpoints_(deck, options.out_dir, options.allows_external_files),
      mesh_pieces_(list_mesh_pieces(deck, chunked_, ranks_)),
      requests_(ranks_.rank() == 0 ? options.out_dir : ""),
      user_databases_(deck),
      measures_(measure_scene(deck, chunked_, model_.start_velocity)) {
  stop_if_requested(ranks_, "after contact was made");
  progress_.emplace(stderr, ranks_.rank() == 0 ? options.progress : Progress::Style::quiet);
  warnings_.print_over(*progress_);
  warnings_.add(find_start_warnings(deck_, chunked_));
  warnings_.add(check_input({deck_, &measures_, nullptr, 0}));
  warnings_.add(stepper_.list_start_warnings());
  warnings_.end_input();
  say(chunked_.mesh.notes);
  say(describe_joints(chunked_.mesh));
  say(model_.mass_notes);
  say(describe_added_masses(model_));
  if (stepper_.sensors().any()) stepper_.sensors().find_columns(History::list_columns({deck_, chunked_, stepper_}));
  if (options.restart.empty()) {
    begin();
  } else {
    restart();
  }
  stop_if_requested(ranks_, "before the first step");
  open_files();  // last: to close a file that several ranks write takes all of them, should one fail alone
  summary_.end_time = deck_.time.end;
  summary_.deck = {deck_.file, deck_.resolved, deck_.settings};
  summary_.setup_s = find_seconds(setup_start_);
}

/// Tells what is known before the mesh, which may be refused. Of the members above the mesh only.
ChunkedMesh Run::load_scene() {
  warnings_.add(deck_.warnings);
  warnings_.add(options_.warnings);
  ChunkedMesh chunked = load_mesh(deck_, ranks_);
  stop_if_requested(ranks_, "after the mesh was made");
  return chunked;
}

void Run::begin() {
  start_sensors();
  warnings_.add(set_start_states(deck_, chunked_, model_, state_));
  if (const std::string notice = contact_.prepare(state_.x, state_.v); !notice.empty()) say({notice});
  warnings_.note_pushed(find_pushed_square(contact_.start_overlap(), deck_.contact.overlap));
  say(contact_.start_notes());
  relax();
  compute_start_ = compute_seconds();
  call_user_code(RunMoment::start_of_analysis);
  call_user_code(RunMoment::start_of_step);
  stepper_.start(state_);
  warnings_.add(stepper_.take_warnings());
  begin_books();
  const TieMeasures ties = contact_.measure_ties();
  const double bound = model_.rigid.is_all ? state_.next_dt : state_.bound.step;
  const std::vector<double> part_steps = find_part_steps(chunked_, state_.results);
  warnings_.add(check_start({deck_, &measures_, &contact_.start_overlap(), bound, &ties, &part_steps}));
  erode();
  // Only the step of elements can collapse.
  const bool is_approach = stepper_.find_limiting_approach(state_) != nullptr;
  first_dt_ = is_approach ? deck_.time.step_scale * state_.bound.step : state_.next_dt;
  note_limit();
  checkpoints_.begin(state_.time);  // none at time 0
}

void Run::restart() {
  CheckpointReader reader(options_.restart, chunked_, ranks_);
  check_checkpoint_header(options_.restart, reader.header(),
                          make_checkpoint_header(deck_, mesh_pieces_, chunked_, state_), deck_);
  archive(reader);
  summary_.restart_changes = list_changed_values(reader.header(), deck_);
  if (options_.goes_on_in_place) refuse_changed_regions(reader.header(), deck_, summary_.restart_changes);
  warnings_.restore(reader.header(), options_.restart);
  if (!reader.header().earlier.empty()) summary_.earlier = read_earlier(reader.header().earlier, options_.restart);
  if (deck_.time.end < state_.time * (1 - 1e-12)) {
    throw InputError(
        fmt::format("{}: error: time.end is {:g}, before the checkpoint's time {:g} (a restart cannot go back in time)",
                    deck_.file, deck_.time.end, state_.time));
  }
  complete_state(chunked_, model_, state_);
  if (stepper_.sensors().any()) switch_contact();
  compute_start_ = compute_seconds();
  call_user_code(RunMoment::start_of_analysis);
  call_user_code(RunMoment::start_of_step);
  stepper_.resume(state_);
  start_step_ = state_.step;
  checkpoints_.note(options_.restart, state_);
  if (speaks()) print_quietly(stderr, "continuing from step {}, t = {:.6g}\n", state_.step, state_.time);
  for (const std::string& change : summary_.restart_changes) say({"note: changed since the checkpoint: " + change});
}

void Run::say(const std::vector<std::string>& lines) const {
  if (!speaks()) return;
  for (const std::string& line : lines) print_quietly(stderr, "{}\n", line);
}

void Run::open_files() {
  open_results();
  run_on_first_rank(ranks_, [&] { checkpoints_.remove_unfinished(); });
}

void Run::open_results() {
  if (!options_.out_dir.empty() && deck_.output.history_every) {
    History::check_points(deck_, chunked_, model_);  // an unknown id is reported before earlier results go
  }
  if (options_.goes_on_in_place) {
    output_.check_earlier();
    run_on_first_rank(ranks_, [&] { check_removals(); });
    output_.go_on();
    keep_deck();
    return;
  }
  fail_together(ranks_, [&] {
    if (ranks_.rank() == 0 && options_.prepare_output) options_.prepare_output();
  });
  output_.create();
  keep_deck();
}

/// The deck beside its results, with what --set changed in comments before it.
void Run::keep_deck() const {
  run_on_first_rank(ranks_, [&] {
    if (options_.out_dir.empty()) return;
    std::string text = "# As run from " + in_one_line(deck_.file) + "\n";
    for (const std::string& setting : deck_.settings) text += "# --set " + in_one_line(setting) + "\n";
    write_file_atomically(options_.out_dir + "/run_deck.yaml", text + deck_.text, Durability::system);
  });
}

/// A run that continues in place cuts off what lies behind its checkpoint.
void Run::check_removals() const {
  RestartInPlace restart{options_.out_dir, options_.restart, {state_.time, state_.step}, {deck_.time.end, 0}};
  restart.end.step = deck_.time.max_steps.value_or(std::numeric_limits<std::int64_t>::max());
  const std::string removals = describe_removals(restart, output_.find_cut_states(restart.from, restart.end));
  if (removals.empty()) return;
  if (!options_.may_remove_results) throw InputError(refuse_removals(restart, removals));
  say({"note: removed, since --force is given: " + removals});
}

bool Run::is_finished() const {
  return deck_.time.end - state_.time <= 1e-12 * deck_.time.end ||
         (deck_.time.max_steps && state_.step >= *deck_.time.max_steps) || stepper_.sensors().ends_run(state_.time);
}

void Run::loop() {
  if (options_.restart.empty()) {
    summary_.dt.min = first_dt_;
    check_step_made();
    audit();  // what later audits compare with, whatever the output
    observe();
  } else {
    keep_frame();  // as the run did that wrote the checkpoint; what it kept before is not in there
    if (is_finished())
      say(
          {fmt::format("note: nothing is left to compute (the checkpoint is of t = {:g} and step {}, the end of this "
                       "run{}): raise time.end or time.max_steps to continue",
                       state_.time, state_.step, keeps_summary_ ? "; summary.json stays as it is" : "")});
  }
  while (!is_finished() && !stepper_.is_stop_agreed()) advance();
  // The checkpoint goes before the last row and frame, which a run that continues does not have.
  if (!is_finished()) {
    save_interrupted();
  } else if (checkpoints_.step() != state_.step && checkpoints_.is_wanted_at_end()) {
    write_checkpoint();
  }
  if (is_finished()) watch_depth();
  observe_last();
  call_user_code(RunMoment::end_of_step);
  call_user_code(RunMoment::end_of_analysis);
  if (is_finished() && contact_.is_active())
    if (const std::string left = contact_.describe_overlap_left(state_.x); !left.empty()) say({left});
}

/// Notes what bounds the next step.
void Run::note_limit() {
  limiting_element_id_ = state_.bound.element_id;
  limiting_spring_ = state_.bound.spring;
  const Approach* const approach = stepper_.find_limiting_approach(state_);
  limiting_approach_ = approach == nullptr ? "" : describe_approach(*approach, chunked_.mesh);
}

/// VEXTERNALDB of the user's libraries; one that requests the end of the run stops it.
void Run::call_user_code(RunMoment moment) {
  if (!user_databases_.any()) return;
  const bool is_made = moment >= RunMoment::end_of_increment;
  const std::int64_t increment = state_.step + (is_made || moment < RunMoment::setup_of_increment ? 0 : 1);
  const std::string asked =
      user_databases_.call(moment, {chunked_.numbering.node_count(), chunked_.numbering.element_count(), increment,
                                    state_.time, is_made ? state_.dt : state_.next_dt});
  if (asked.empty() || moment != RunMoment::end_of_increment) return;
  if (!is_stop_requested()) print_quietly(stderr, "note: the code of {} asks for the end of the run\n", asked);
  request_stop();
}

/// A step, and all that is due after it.
void Run::advance() {
  note_limit();
  call_user_code(RunMoment::setup_of_increment);
  call_user_code(RunMoment::start_of_increment);
  is_state_whole_ = false;
  stepper_.advance(state_, find_wishes());
  is_state_whole_ = true;
  summary_.dt.min = std::min(summary_.dt.min, state_.dt);
  summary_.dt.max = std::max(summary_.dt.max, state_.dt);
  note_contact();
  check_step_made();
  call_user_code(RunMoment::end_of_increment);
  if (contact_.is_active()) contact_.break_ties(state_.x, state_.v);
  erode();
  if (contact_.is_active()) contact_.watch_folds(state_.x, state_.v, state_.step);
  observe();
  keep_frame();
  if (stepper_.is_stop_agreed()) return;  // save_interrupted() writes the checkpoint, without a wait for other files
  if (stepper_.is_checkpoint_agreed() || checkpoints_.is_due(state_.time)) write_checkpoint();
  if (!is_finished()) progress_->report(find_progress());  // finish() has the last word
}

/// (1.1) Redefine the contact surface: where elements have died, everything else follows before the state is looked at.
void Run::erode() {
  if (!state_.bound.died) return;
  PhaseClock& clock = stepper_.clocks().reduce;
  const PhaseClock before = contact_.clocks().sum();
  {
    const Phase phase("percuss::erosion", clock);
    erosion_.redefine(state_, stepper_.bookkeeper());
    stepper_.drop_vanished(state_);
  }
  clock += before;  // contact has phases of its own
  clock -= contact_.clocks().sum();
}

StepWishes Run::find_wishes() {
  const FolderRequests::Found asked = ranks_.rank() == 0 ? requests_.take() : FolderRequests::Found{};
  StepWishes wishes;
  wishes.stop = is_stop_requested() || asked.stop;
  wishes.checkpoint =
      is_checkpoint_requested() || asked.checkpoint || (ranks_.rank() == 0 && checkpoints_.is_clock_due());
  wishes.frame = asked.frame;
  return wishes;
}

void Run::watch_depth() {
  if (!contact_.is_active()) return;
  contact_.watch_depth(state_.x, state_.v, state_.time);
  warnings_.add(contact_.take_warnings());
}

void Run::note_contact() {
  constexpr long steps_between_looks = 4096;  // one costs some dozen steps
  warnings_.add(stepper_.take_warnings());
  if (!contact_.is_active()) return;
  if (state_.step % steps_between_looks == 0) watch_depth();
  contact_.watch_edges(state_.x, state_.step, state_.time);
  warnings_.add(contact_.take_warnings());
  warnings_.note_step(stepper_.contact_report(), state_.time, [&] { return name_deepest_node(checked_run()); });
  if (!warnings_.has_warned_gain()) note_contact_gain(false);
}

/// Contact that gives energy is booked as work, so that the balance does not show it. It is reported where it is still
/// too much a while later, or in the last state: loads that rise from 0 begin with energies of round-off.
void Run::note_contact_gain(bool is_last) {
  constexpr double wait = 0.01;  // share of the run
  const GainPlace* const found = warnings_.found_gain();
  if (found != nullptr && !is_last && state_.time < found->time + wait * deck_.time.end) return;
  const double share = find_tolerated_gain(deck_.audit);
  const double work = state_.books.contact_work, friction = state_.books.friction_work;
  if (!is_gain(find_given(work, friction, find_scales()), share, find_scales())) return warnings_.forget_gain();
  audit();  // the largest energy may be larger by now
  const EnergyScales scales = find_scales();
  const double given = find_given(work, friction, scales);
  if (!is_gain(given, share, scales)) return warnings_.forget_gain();
  if (found == nullptr) warnings_.find_gain(find_gain_place(checked_run()));
  if (found == nullptr && !is_last) return;
  warnings_.add_gain(given, scales, deck_.units);
  if (!deck_.audit.max_contact_gain) return;
  refuse_gain(checked_run(), describe_gain(given, scales, *warnings_.found_gain(), deck_.units));
}

void Run::audit() {
  if (audited_step_ == state_.step) return;
  const Phase phase("percuss::reduce", stepper_.clocks().reduce);
  audited_ = audit_(state_, contact_.find_wall_energy());
  audited_step_ = state_.step;
}

/// Audit and output of a state, where they are due. A row of the history is written before the balance is judged, so
/// that it shows what grew; a frame only after.
void Run::observe() {
  const bool is_asked = stepper_.is_frame_agreed();
  const bool row_due = output_.is_row_due(state_.time) || (is_asked && !stepper_.sensors().any()),
             frame_due = output_.is_frame_due(state_.time) || is_asked;
  if (!row_due && !frame_due && state_.step % steps_between_audits != 0) return look_by_sensors(false);
  audit();
  const Phase phase("percuss::output", stepper_.clocks().output);
  if (row_due) output_.write_row(state_, audited_);
  warnings_.renew(find_element_warnings());
  check_balance(checked_run(), audited_);
  if (is_asked)
    output_.write_frames(state_);
  else if (frame_due)
    output_.write_due_frames(state_);
  if (frame_due) look_at_corners();
  output_.advance(state_.time);
  look_by_sensors(row_due);
}

void Run::look_at_corners() {
  const std::vector<std::int64_t> counts = count_inverted_corners(chunked_, model_, state_);
  warnings_.renew(describe_inverted_corners(counts, chunked_.mesh.parts, state_.time));
}

/// Whoever interrupts a run may end it by force a second later: what is needed to continue comes first, then what tells
/// that it was interrupted, and only then all other output and the wait for the disk.
void Run::save_interrupted() {
  if (checkpoints_.step() != state_.step) save_checkpoint();
  audit();
  const Summary summary = make_summary("interrupted", "");
  fail_together(ranks_, [&] {
    if (ranks_.rank() == 0 && !options_.out_dir.empty()) write_summary(options_.out_dir + "/summary.json", summary);
  });
  output_.sync();
}

/// Observes the last state, due or not.
void Run::observe_last() {
  audit();
  if (contact_.is_active() && !warnings_.has_warned_gain()) note_contact_gain(true);
  const Phase phase("percuss::output", stepper_.clocks().output);
  output_.write_row(state_, audited_);
  look_at_corners();
  warnings_.renew(find_element_warnings());
  check_balance(checked_run(), audited_);
  output_.write_frames(state_);
}

void Run::check_step_made() const {
  check_elements(checked_run());
  if (!is_finished()) check_step(checked_run(), first_dt_);
}

/// Everything that a run needs to continue as if it had never stopped.
void Run::archive(CheckpointArchive& archive) {
  archive_state(archive, chunked_, model_, state_);
  stepper_.archive_actions(archive, state_);
  if (archive.is_loading() && model_.can_erode) erosion_.restore(state_);
  stepper_.archive(archive);
  audit_.archive(archive);
  if (archive.is_loading() && stepper_.sensors().any()) stepper_.set_switches(state_);
  output_.archive(archive, state_.time);
  archive.number("run/first_dt", first_dt_);
  archive.number("run/dt_min", summary_.dt.min);
  archive.number("run/dt_max", summary_.dt.max);
  archive.number("run/limiting_element_id", limiting_element_id_);
  archive.number("run/limiting_spring", limiting_spring_);
  archive.integer("run/audited_step", audited_step_);
  audited_.archive(archive);
  archive_relaxation(archive);
  warnings_.archive(archive);
}

void Run::write_checkpoint() {
  output_.sync();
  save_checkpoint();
}

void Run::save_checkpoint() {
  if (options_.out_dir.empty()) return;
  const Phase phase("percuss::output", stepper_.clocks().output);
  output_.note_lengths();
  CheckpointHeader header = make_checkpoint_header(deck_, mesh_pieces_, chunked_, state_);
  header.warnings = warnings_.write();
  header.earlier = write_earlier(find_cost_so_far());
  checkpoints_.write(header, chunked_, ranks_, state_, [&](CheckpointArchive& to) { archive(to); });
  forget_checkpoint_request();
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

RunResult Run::operator()() {
  loop_start_ = Clock::now();
  try {
    keeps_summary_ = is_summary_whole();
    announce();
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
  return {interrupted ? ExitCode::interrupted : ExitCode::done, result_, checkpoints_.path(),
          checkpoints_.describe_resume(), checkpoints_.step() == state_.step};
}

RunResult run_scene(const Deck& deck, const RunOptions& options) {
  Run run(deck, options);
  const RunResult result = run();
  forget_stop_request();
  return result;
}

}  // namespace percuss
