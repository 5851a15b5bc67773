#pragma once
// A run between its start and its summary: what run.cpp (start, time loop) and run_end.cpp (summary, failure) share.

#include <chrono>
#include <cstdint>
#include <exception>
#include <optional>
#include <string>
#include <vector>

#include "comm/rendezvous.hpp"
#include "src/checks/rules.hpp"
#include "src/contact/contact_stage.hpp"
#include "src/deck/laws/user_database.hpp"
#include "src/step/audit/audit.hpp"
#include "src/step/erosion.hpp"
#include "src/step/restart/run_checkpoints.hpp"
#include "src/step/results/run_output.hpp"
#include "src/step/run/run.hpp"
#include "src/step/run/run_checks.hpp"
#include "src/step/run/run_notes.hpp"
#include "src/step/run/run_summary.hpp"
#include "src/step/run/run_warnings.hpp"
#include "src/step/run/stop_request.hpp"
#include "src/step/sensors/sensors.hpp"
#include "src/step/step.hpp"

namespace percuss {

/// Everything a run holds between its start and its summary.
class Run {
 public:
  Run(const Deck& deck, const RunOptions& options);
  RunResult operator()();

 private:
  using Clock = std::chrono::steady_clock;

  static double find_seconds(Clock::time_point since) {
    return std::chrono::duration<double>(Clock::now() - since).count();
  }
  bool speaks() const { return ranks_.rank() == 0 && options_.progress != Progress::Style::quiet; }
  void say(const std::vector<std::string>& lines) const;
  ChunkedMesh load_scene();
  void begin();
  void relax();
  void note_unsettled(const Warning& warning);
  void begin_books();
  void archive_relaxation(CheckpointArchive& archive);
  void restart();
  void open_files();
  void check_removals() const;
  void open_results();
  void keep_deck() const;
  bool is_finished() const;
  void loop();
  void note_limit();
  void call_user_code(RunMoment moment);
  void advance();
  void erode();
  void observe();
  void observe_last();
  void save_interrupted();
  void keep_frame();
  void look_at_corners();
  void start_sensors();
  void look_by_sensors(bool has_new_row);
  void report_events(const std::vector<char>& happened);
  void switch_contact();
  void audit();
  void note_contact();
  void watch_depth();
  void note_contact_gain(bool is_last);
  void check_step_made() const;
  CheckedRun checked_run() const { return {deck_, chunked_, model_, state_, stepper_}; }
  StepWishes find_wishes();
  void archive(CheckpointArchive& archive);
  void save_checkpoint();
  void write_checkpoint();
  bool is_summary_whole() const;
  void announce();
  long steps_done() const { return state_.step - start_step_; }
  EarlierSummary find_cost_so_far() const;
  Summary make_summary(const std::string& status, const std::string& error) const;
  EnergyScales find_scales() const;
  std::vector<Warning> find_element_warnings() const;
  std::vector<Warning> find_idle_warnings();
  void finish(const std::string& status, const std::string& error);
  SummedRun summed() const {
    return {chunked_, model_, state_, stepper_, contact_, audited_, steps_done(), compute_seconds() - compute_start_};
  }
  void fail(const std::exception& error);
  void note_lost_frames();
  void write_failed_state();
  ProgressState find_progress() const;

  const Deck& deck_;
  RunOptions options_;
  Clock::time_point setup_start_ = Clock::now();
  const Communicator ranks_ = Communicator::world();
  std::optional<Progress> progress_;  // once the scene is read
  RunWarnings warnings_;
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
  const std::vector<std::string> mesh_pieces_;  // for its checkpoints (mesh_pieces.hpp)
  FolderRequests requests_;
  const UserDatabases user_databases_;
  const SceneMeasures measures_;  // at time 0
  bool is_state_whole_ = true;    // false while a step is made
  bool keeps_summary_ = false;    // whether the summary of the continued run stays: nothing is left to compute
  long start_step_ = 0;           // where this run began
  double first_dt_ = 0;
  std::int64_t limiting_element_id_ = 0;  // bounded the last step
  std::int64_t limiting_spring_ = -1;     // likewise, -1: none
  std::string limiting_approach_;         // likewise, empty: none
  Clock::time_point loop_start_;
  double compute_start_ = 0;  // compute_seconds() when the clocks of the phases began
  Summary summary_;           // what is noted on the way
  Summary result_;            // at the end
};

}  // namespace percuss
