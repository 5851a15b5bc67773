#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <memory>
#include <variant>

#include "comm/agreement.hpp"
#include "comm/before_abort.hpp"
#include "kernels/core/views.hpp"
#include "src/app/commands.hpp"
#include "src/app/folder/folder_lock.hpp"
#include "src/app/folder/output_folder.hpp"
#include "src/app/process/compute_session.hpp"
#include "src/app/process/external_files.hpp"
#include "src/app/process/failure_report.hpp"
#include "src/app/process/placement.hpp"
#include "src/app/read_together.hpp"
#include "src/app/reports/summary_report.hpp"
#include "src/deck/laws/user_exits.hpp"
#include "src/deck/laws/user_routines.hpp"
#include "src/deck/units.hpp"
#include "src/fail_together.hpp"
#include "src/output/progress.hpp"
#include "src/step/run/run.hpp"
#include "src/step/run/stop_request.hpp"

namespace percuss {
namespace {

std::string format_file_size(const std::string& path) {
  std::error_code lost;  // somebody may have moved it
  const auto bytes = std::filesystem::file_size(path, lost);
  return lost ? "size unknown" : fmt::format("{:.3g} MB", static_cast<double>(bytes) * 1e-6);
}

void report(const RunResult& result, const std::string& out_dir, const Deck& deck) {
  const Summary& s = result.summary;
  print_quietly(stderr, "{}: t = {:.6g}{} in {} steps, {:.3g} s; {:.4g} ns per element and step; energy error {:.1e}\n",
                s.status, s.time, unit_suffix(deck.units, dimensions::time), s.steps, s.setup_s + s.loop_s, s.grind_ns,
                s.energy.error);
  if (const std::string limit = describe_step_limit(s); !limit.empty()) print_quietly(stderr, "{}\n", limit);
  if (s.mass.in_run > 0) print_quietly(stderr, "mass: {}\n", format_added_mass(s));
  if (s.eroded.elements > 0) print_quietly(stderr, "eroded: {}\n", format_eroded(s));
  print_quietly(stderr, "results: {}\n", out_dir);
  if (result.exit_code == ExitCode::interrupted) {
    print_quietly(stderr, "checkpoint: {}; {}\n", result.checkpoint, result.resume);
  } else if (result.has_end) {
    print_quietly(stderr, "checkpoint: {}, {}, of the end: a later time.end and --restart continue the run\n",
                  result.checkpoint, format_file_size(result.checkpoint));
  }
  if (const std::string loss = format_contact_loss(s); !loss.empty()) print_quietly(stderr, "contact: {}\n", loss);
  if (!s.warnings.empty()) print_quietly(stderr, "{}\n", describe_warnings(s, out_dir));
}

std::string choose_folder(const Command& command) {
  if (!command.out_dir.empty()) return command.out_dir;
  return command.restart.empty() ? default_output_folder(command.file) : find_restart_folder(command.restart);
}

/// Whether the run continues in the folder of its checkpoint. Ranks on several machines may see other folders: rank 0
/// decides. Collective.
bool check_restart(const Command& command, const std::string& out_dir, const Communicator& ranks) {
  if (command.restart.empty()) return false;
  std::string answer;
  fail_together(ranks, [&] {
    if (!std::filesystem::exists(command.restart))
      throw InputError(command.restart + ": error: no such file (--restart needs a checkpoint)");
    if (ranks.rank() != 0) return;
    refuse_other_file(command.restart);
    if (!command.allow_external) refuse_external_checkpoint(command.restart);
    if (lies_in_folder(command.restart, out_dir))
      answer = "in place";
    else if (command.force)
      refuse_to_remove(command.restart, "checkpoint", out_dir);
  });
  return !broadcast_text(ranks, answer, 0).empty();
}

/// Files that the deck reads may lie in the folder.
void refuse_to_remove_inputs(const Deck& deck, const std::string& out_dir) {
  for (const PartDeck& part : deck.parts)
    if (const auto* mesh = std::get_if<FileMesh>(&part.shape))
      refuse_to_remove(mesh->file, "mesh of the deck", out_dir);
  for (const StartFieldsDeck& fields : deck.start.fields)
    refuse_to_remove(fields.file, "file of start.fields", out_dir);
}

/// Rank 0 makes and locks the folder, and looks into it; before the mesh is built. It is emptied only when the scene is
/// known to be sound. Whichever rank ends all ranks at once also removes the lock. Collective.
std::unique_ptr<FolderLock> prepare_folder(const Command& command, const Deck& deck, const std::string& out_dir,
                                           const Communicator& ranks, RunOptions& options) {
  options.out_dir = out_dir;
  options.restart = command.restart;
  options.may_remove_results = command.force;
  options.allows_external_files = command.allow_external;
  options.goes_on_in_place = check_restart(command, out_dir, ranks);
  std::unique_ptr<FolderLock> lock;
  fail_together(ranks, [&] {
    if (ranks.rank() != 0) return;
    make_output_folder(out_dir);
    lock = std::make_unique<FolderLock>(out_dir);
    if (!options.goes_on_in_place && !command.force) return check_folder_is_empty(out_dir);
    if (!options.goes_on_in_place) refuse_to_remove_inputs(deck, out_dir);
    remove_stale_requests(out_dir, lock->path());
    if (options.goes_on_in_place) check_results_to_go_on_with(out_dir, command.restart, command.allow_external);
  });
  const std::string text = broadcast_text(ranks, lock ? lock->text() : "", 0);
  do_before_abort([path = out_dir + "/" + lock_file_name, text] { remove_lock(path, text); });
  if (command.force && !options.goes_on_in_place) options.prepare_output = [out_dir] { remove_results(out_dir); };
  return lock;
}

}  // namespace

ExitCode run_command(Command command, const Communicator& ranks) {
  stop_if_requested(ranks, "before the deck was read");
  command.restart = find_checkpoint(command.restart);
  const bool speaks = ranks.rank() == 0;
  const Deck deck = read_deck_together(command, ranks);
  const ComputeSession session(ranks, deck);
  const std::string out_dir = choose_folder(command);
  RunOptions options;
  const std::unique_ptr<FolderLock> lock = prepare_folder(command, deck, out_dir, ranks, options);
  if (lock && !command.quiet && !lock->note().empty()) print_quietly(stderr, "{}\n", lock->note());
  if (speaks && !command.quiet && !session.note().empty()) print_quietly(stderr, "{}\n", session.note());
  UserRun run = describe_run(command.file, out_dir, ranks);
  run.threads = ExecSpace().concurrency();
  set_user_run(run);
  if (!command.allowed_libraries.empty()) guard_user_stacks();
  options.end_all_ranks = [&] { ranks.abort(static_cast<int>(tell(describe_failure()))); };
  options.progress = command.quiet ? Progress::Style::quiet : Progress::choose_style(stderr);
  const Placement placement = find_placement(ranks, ExecSpace().concurrency());
  if (const auto crowding = describe_crowding(placement, ranks.size())) options.warnings.push_back(*crowding);
  choose_work_clock(are_cores_shared(placement) ? WorkClock::thread : WorkClock::usual);
  const RunResult result = run_scene(deck, options);
  if (speaks && !command.quiet) report(result, out_dir, deck);
  return result.exit_code;
}

}  // namespace percuss
