#include <fmt/format.h>

#include <csignal>
#include <cstdio>
#include <filesystem>

#include "kernels/core/views.hpp"
#include "src/app/commands.hpp"
#include "src/app/failure_report.hpp"
#include "src/app/output_folder.hpp"
#include "src/app/placement.hpp"
#include "src/app/read_together.hpp"
#include "src/app/summary_report.hpp"
#include "src/deck/units.hpp"
#include "src/fail_together.hpp"
#include "src/output/progress.hpp"
#include "src/step/run.hpp"

namespace percuss {
namespace {

extern "C" void stop_on_signal(int) { request_stop(); }

// The first signal asks the run to stop after its step; SA_RESETHAND lets the second one end the program. SIGUSR1 is
// what mpirun passes on without killing its ranks a second later, and what queueing systems can be told to send.
void install_signal_handlers() {
  struct sigaction action = {};
  action.sa_handler = stop_on_signal;
  action.sa_flags = static_cast<int>(SA_RESETHAND);
  sigemptyset(&action.sa_mask);
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
  sigaction(SIGUSR1, &action, nullptr);
}

void report(const RunResult& result, const std::string& out_dir, const Deck& deck) {
  const Summary& s = result.summary;
  print_quietly(stderr,
                "{}: t = {:.6g}{} in {} steps, {:.3g} s; {:.4g} ns per element and step; energy error {:.2g} %\n",
                s.status, s.time, unit_suffix(deck.units, dimensions::time), s.steps, s.setup_s + s.loop_s, s.grind_ns,
                100 * s.energy.error);
  if (s.eroded.elements > 0) print_quietly(stderr, "eroded: {}\n", format_eroded(s));
  print_quietly(stderr, "results: {}\n", out_dir);
  if (result.exit_code == ExitCode::interrupted) {
    print_quietly(stderr, "checkpoint: {}; to go on: percuss run {} --restart {}\n", result.checkpoint, deck.file,
                  result.checkpoint);
  }
  if (!s.warnings.empty()) print_quietly(stderr, "{}\n", describe_warnings(s, out_dir));
}

std::string choose_folder(const Command& command) {
  if (!command.out_dir.empty()) return command.out_dir;
  return command.restart.empty() ? default_output_folder(command.file) : find_restart_folder(command.restart);
}

// The folder is made and looked at before the mesh is built, and emptied only when the scene is known to be sound.
void prepare_folder(const Command& command, const std::string& out_dir, const Communicator& ranks,
                    RunOptions& options) {
  options.out_dir = out_dir;
  options.restart = command.restart;
  if (!command.restart.empty()) {
    fail_together(ranks, [&] {
      if (!std::filesystem::exists(command.restart))
        throw InputError(command.restart + ": error: no such file (--restart needs a checkpoint)");
      options.goes_on_in_place = is_same_folder(out_dir, find_restart_folder(command.restart));
      if (options.goes_on_in_place) check_folder_is_writable(out_dir);
    });
    if (options.goes_on_in_place) return;
  }
  if (command.force) {
    options.prepare_output = [out_dir] { prepare_output_folder(out_dir, true); };
    return;
  }
  fail_together(ranks, [&] {
    if (ranks.rank() == 0) prepare_output_folder(out_dir, false);
  });
}

}  // namespace

ExitCode run_command(Command command, const Communicator& ranks) {
  command.restart = find_checkpoint(command.restart);
  const bool speaks = ranks.rank() == 0;
  const Deck deck = read_deck_together(command, ranks);
  const std::string out_dir = choose_folder(command);
  RunOptions options;
  prepare_folder(command, out_dir, ranks, options);
  options.end_all_ranks = [&] { ranks.abort(static_cast<int>(tell(describe_failure()))); };
  options.progress = command.quiet ? Progress::Style::quiet : Progress::choose_style(stderr);
  const Placement placement = find_placement(ranks, ExecSpace().concurrency());
  if (const auto crowding = describe_crowding(placement, ranks.size())) options.warnings.push_back(*crowding);
  choose_work_clock(are_cores_shared(placement) ? WorkClock::thread : WorkClock::usual);
  install_signal_handlers();
  const RunResult result = run_scene(deck, options);
  if (speaks && !command.quiet) report(result, out_dir, deck);
  return result.exit_code;
}

}  // namespace percuss
