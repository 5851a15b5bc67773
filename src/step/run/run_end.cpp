// The end of a run, good or bad: its summary, and what is written of a failed one.

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "comm/all_reduce.hpp"
#include "src/error.hpp"
#include "src/fail_together.hpp"
#include "src/index.hpp"
#include "src/output/files/first_rank.hpp"
#include "src/step/run/run_scene.hpp"
#include "src/step/run/run_totals.hpp"

namespace percuss {

/// Whether a run that continues in place has nothing left to do, and the folder's summary is of this very state: it
/// tells what the computation has cost, which this run would not. Collective.
bool Run::is_summary_whole() const {
  if (!options_.goes_on_in_place || !is_finished()) return false;
  const std::string hash = fmt::format("{:016x}", hash_state(model_, state_)),
                    path = options_.out_dir + "/summary.json";
  int is_whole = 0;
  if (ranks_.rank() == 0 && std::filesystem::exists(path)) {
    try {
      const Summary found = read_summary(path);
      is_whole = found.status == "completed" && found.steps == state_.step && found.state_hash == hash ? 1 : 0;
    } catch (const std::exception&) {
      is_whole = 0;  // one that cannot be read is written anew
    }
  }
  all_reduce(ranks_, Reduce::largest, is_whole);
  return is_whole != 0;
}

/// A folder whose summary says "running" and that no run holds is of a run that was killed. Collective.
void Run::announce() {
  if (keeps_summary_) return;
  Summary summary = summary_;
  summary.status = "running";
  summary.warnings = warnings_.list();
  fill_scene(summed(), summary);
  fail_together(ranks_, [&] {
    if (ranks_.rank() == 0 && !options_.out_dir.empty()) write_summary(options_.out_dir + "/summary.json", summary);
  });
}

/// Cost with that of the runs before the checkpoint of this one. Collective.
EarlierSummary Run::find_cost_so_far() const {
  Summary now = summary_;
  now.loop_s = find_seconds(loop_start_);
  now.phases_s = stepper_.read_clocks().wall();
  take_largest(ranks_, now);
  EarlierSummary sum = summary_.earlier;
  sum.runs += 1;
  sum.steps += steps_done();
  sum.setup_s += now.setup_s;
  sum.loop_s += now.loop_s;
  std::vector<double> seconds;
  visit_phases(now.phases_s, [&](const char*, double value) { seconds.push_back(value); });
  auto next = seconds.begin();
  visit_phases(sum.phases_s, [&](const char*, double& total) { total += *next++; });
  return sum;
}

/// Collective.
Summary Run::make_summary(const std::string& status, const std::string& error) const {
  Summary summary = summary_;
  summary.status = status;
  summary.error = error;
  summary.dt.last = state_.dt;
  summary.dt.element = limiting_element_id_;
  if (const std::int64_t turn = find_turn_spring(limiting_spring_); turn >= 0)
    summary.dt.spring = model_.turn_springs[at(turn)].name;
  if (model_.springs.has(limiting_spring_)) summary.dt.spring = model_.springs.springs[at(limiting_spring_)].name;
  summary.dt.approach = limiting_approach_;
  summary.loop_s = find_seconds(loop_start_);
  if (status == "completed" && stepper_.sensors().ends_run(state_.time)) summary.ended_by = deck_.time.until;
  for (const SensorEvent& event : stepper_.sensors().list_events(state_.time))
    summary.sensors.push_back({event.sensor, event.time, event.value});
  summary.warnings = warnings_.list();
  fill_summary(summed(), summary);
  return summary;
}

/// Contact that pushes nodes of mass m out by g in steps of dt compresses elements, or springs of its own, at most as
/// stiff as m / dt^2. What else it may give holds the forces that were there at the start. Bodies that rest on each
/// other have no other energy than that of half a step of their weight, which contact takes and gives again.
EnergyScales Run::find_scales() const {
  const auto nodes = static_cast<double>(chunked_.numbering.node_count());
  const double steps = static_cast<double>(state_.step), node_mass = model_.total_mass / nodes;
  EnergyScales scales;
  scales.largest = audit_.largest_energy();
  scales.largest_strain = audit_.largest_strain_energy();
  scales.resolved = find_resolved_energy(chunked_, model_, steps > 0 ? state_.time / steps : 0);
  scales.stored = stepper_.contact_report().stored;
  scales.stored_slip = stepper_.contact_report().stored_slip;
  scales.granted = audit_.start_half_steps();
  scales.resolved = std::max(scales.resolved, scales.granted);
  if (warnings_.pushed_square() > 0)
    scales.granted += 0.5 * node_mass * warnings_.pushed_square() / (first_dt_ * first_dt_);
  scales.granted += summary_.relaxation.contact_stored;
  return scales;
}

/// Judges the state audited last. Gases and springs may hold energy at the start.
std::vector<Warning> Run::find_element_warnings() const {
  const bool starts_empty =
      deck_.springs.empty() && std::none_of(deck_.materials.begin(), deck_.materials.end(),
                                            [](const MaterialDeck& material) { return material.equation_of_state; });
  return warn_of_elements(find_given_by_elements(audited_.energy, starts_empty), find_scales(), state_.time,
                          deck_.units);
}

/// Forces that stayed 0 and bodies that met nothing, where the run has come to its end by time. Collective.
std::vector<Warning> Run::find_idle_warnings() {
  if (deck_.time.end - state_.time > 1e-12 * deck_.time.end) return {};
  EndMotion end{state_.time - 0.5 * state_.dt, {}, {}};
  find_velocity_ranges(chunked_.mesh, state_.v, end.low, end.high);
  const CheckedScene scene{deck_, &measures_};
  std::vector<Warning> warnings = check_flown_bodies(scene, end);
  if (!output_.has_rows()) return warnings;
  for (const Warning& warning : check_idle_columns(scene, stepper_.forces().has_acted())) warnings.push_back(warning);
  return warnings;
}

/// Collective.
void Run::finish(const std::string& status, const std::string& error) {
  const std::vector<RankRow> rows = gather_rows(ranks_, make_rank_row(summed()));
  result_ = make_summary(status, error);
  progress_->finish(find_progress());
  const EnergyScales scales = find_scales();
  const double given = find_given(state_.books.contact_work, state_.books.friction_work, scales);
  if (warnings_.has_warned_gain())
    warnings_.renew_gain(given, scales, deck_.units);
  else if (warnings_.found_gain() != nullptr && is_gain(given, find_tolerated_gain(deck_.audit), scales))
    warnings_.add_gain(given, scales, deck_.units);  // the run has failed meanwhile
  result_.energy.largest = scales.largest;
  result_.energy.contact_taken = find_taken(result_.energy.contact, summary_.relaxation.contact_stored, scales);
  if (status == "completed") warnings_.add(find_idle_warnings());
  warnings_.add(find_end_warnings(
      result_, scales, find_hourglassed_parts(deck_, chunked_, model_, state_, find_hourglass_limits(scales))));
  result_.warnings = warnings_.list();
  fail_together(ranks_, [&] {
    if (ranks_.rank() != 0 || options_.out_dir.empty() || (keeps_summary_ && status == "completed")) return;
    write_summary(options_.out_dir + "/summary.json", result_);  // first: it tells how the run ended
    write_ranks(options_.out_dir + "/ranks.csv", rows);
  });
}

/// Keeps a frame for a run that fails in a later step.
void Run::keep_frame() {
  if (!deck_.output.keeps_frames()) return;
  const Phase phase("percuss::output", stepper_.clocks().output);
  output_.keep_frames(state_);
}

/// Frames that the run before a restart kept in memory.
void Run::note_lost_frames() {
  const int lost = options_.restart.empty() ? 0 : output_.count_lost_frames(state_, start_step_);
  if (lost == 0) return;
  warnings_.add({{"lost_frames",
                  fmt::format("{} of before_failure {} kept in memory before the restart at step {}, and not written: "
                              "continue from an older checkpoint to see {}",
                              lost == 1 ? "a frame" : fmt::format("{} frames", lost), lost == 1 ? "was" : "were",
                              start_step_, lost == 1 ? "it" : "them"),
                  "", state_.time, 1}});
}

/// The state in which a run failed, if it can be looked at: a row and a frame more.
void Run::write_failed_state() {
  if (!is_state_whole_) return;
  output_.write_row(state_, audit_(state_, contact_.find_wall_energy()));
  note_lost_frames();
  output_.write_kept_frames(state_);
  if (!has_finite_positions(model_, state_)) return;
  output_.write_frames(state_);
  if (speaks() && !options_.out_dir.empty() && !deck_.output.list_fields().empty())
    print_quietly(stderr, "the last frame shows the failed state, t = {:.6g}; the one before it is valid\n",
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
    // The state is sound where files were taken away: from a checkpoint the run can continue in another folder. That of
    // a run that failed by itself would only fail again.
    const bool is_sound = is_state_whole_ && dynamic_cast<const SystemError*>(&error) != nullptr;
    if (is_sound && !output_.are_files_in_place()) save_checkpoint();
    finish("failed", error.what());
    output_.close();
  } catch (const std::exception& second) {  // a full disk must not hide why the run failed, and is reported once
    if (ranks_.rank() == 0 && dynamic_cast<const SystemError*>(&error) == nullptr)
      print_quietly(stderr, "percuss: error: {}\n", second.what());
  }
  if (!speaks() || options_.out_dir.empty()) return;
  print_quietly(stderr, "results: {}\n", options_.out_dir);
  if (const std::string hint = checkpoints_.describe(); !hint.empty()) say({hint});
  if (const std::string hint = describe_warnings(result_, options_.out_dir); !hint.empty()) say({hint});
}

}  // namespace percuss
