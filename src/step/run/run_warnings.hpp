#pragma once
// The warnings of a run: reported on rank 0 as they are found, kept over restarts, listed in the summary.

#include <functional>
#include <set>
#include <string>
#include <vector>

#include "comm/communicator.hpp"
#include "src/contact/contact_stage.hpp"
#include "src/output/checkpoint/checkpoint_archive.hpp"
#include "src/output/checkpoint/checkpoint_file.hpp"
#include "src/output/progress.hpp"
#include "src/output/warning_log.hpp"
#include "src/step/run/run_notes.hpp"

namespace percuss {

class RunWarnings {
 public:
  /// silenced: rules whose warnings are not shown. This is not moved: the log tells through it.
  RunWarnings(const std::set<std::string>& silenced, const Communicator& ranks);
  RunWarnings(const RunWarnings&) = delete;
  RunWarnings& operator=(const RunWarnings&) = delete;

  /// Lets a warning take the place of an open live line from now on. progress outlives this.
  void print_over(Progress& progress) { progress_ = &progress; }

  void add(const std::vector<Warning>& warnings) { log_.add(warnings); }
  /// As WarningLog::renew().
  void renew(const std::vector<Warning>& warnings);
  const std::vector<Warning>& list() const { return log_.list(); }

  /// All so far are of the input: a restart finds them again, so that no checkpoint needs to keep them.
  void end_input() { input_count_ = log_.list().size(); }

  /// Overlap at the start that is pushed out: find_pushed_square().
  void note_pushed(double pushed_square) { pushed_square_ = pushed_square; }
  /// Contact of a step. name_deepest: of the deepest node, called on all ranks where a warning first names it; never
  /// where deep_penetration is silenced.
  void note_step(const ContactReport& report, double time, const std::function<std::string()>& name_deepest);

  /// Contact that has given too much energy: keeps where that was first found, until it is forgotten or reported. A
  /// scene that begins at rest has energies of round-off in its first steps.
  void find_gain(const GainPlace& where) { gain_ = where; }
  void forget_gain() { gain_ = {}; }
  const GainPlace* found_gain() const { return gain_.step > 0 ? &gain_ : nullptr; }
  /// Tells it once, and keeps its figures up to date.
  void add_gain(double given, const EnergyScales& scales, const std::string& units);
  void renew_gain(double given, const EnergyScales& scales, const std::string& units);
  bool has_warned_gain() const { return has_warned_gain_; }

  /// note_pushed() of the start, also after a restart.
  double pushed_square() const { return pushed_square_; }

  /// Archives what is remembered besides the warnings, which write() gives as a text.
  void archive(CheckpointArchive& archive);
  /// Warnings that a restart does not find again, for a checkpoint's header; the same on all ranks. Collective.
  std::string write() const;
  /// Takes them back. Throws InputError that names the checkpoint.
  void restore(const CheckpointHeader& header, const std::string& path);

 private:
  void tell(const Warning& warning) const;
  void note_depth(double time, const std::function<std::string()>& name_deepest);

  Communicator ranks_;
  Progress* progress_ = nullptr;
  WarningLog log_;
  std::size_t input_count_ = 0;
  double pushed_square_ = 0;
  GainPlace gain_;  // step 0: none
  bool has_warned_gain_ = false;
  double accepted_depth_ = -1;  // deepest contact node / face edge in the first step; negative: none was made
};

}  // namespace percuss
