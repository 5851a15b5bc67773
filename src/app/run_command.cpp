#include <fmt/format.h>

#include <csignal>
#include <cstdio>

#include "src/app/commands.hpp"
#include "src/app/memory_check.hpp"
#include "src/app/output_folder.hpp"
#include "src/deck/read_deck.hpp"
#include "src/output/progress.hpp"
#include "src/step/run.hpp"

namespace percuss {
namespace {

extern "C" void stop_on_signal(int) { request_stop(); }

// The first signal asks the run to stop after its step; SA_RESETHAND lets the second one end the program.
void install_signal_handlers() {
  struct sigaction action = {};
  action.sa_handler = stop_on_signal;
  action.sa_flags = static_cast<int>(SA_RESETHAND);
  sigemptyset(&action.sa_mask);
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
}

void report(const RunResult& result, const std::string& out_dir) {
  const Summary& s = result.summary;
  print_quietly(stderr, "{}: t = {:.6g} in {} steps, {:.3g} s; {:.4g} ns per element and step; energy error {:.2g} %\n",
                s.status, s.time, s.steps, s.setup_s + s.loop_s, s.grind_ns, 100 * s.energy.error);
  print_quietly(stderr, "results: {}\n", out_dir);
}

}  // namespace

ExitCode run_command(const Command& command) {
  const Deck deck = read_deck(command.file, command.settings);
  for (const std::string& warning : deck.warnings) print_quietly(stderr, "{}\n", warning);
  check_memory(deck);
  const std::string out_dir = command.out_dir.empty() ? default_output_folder(command.file) : command.out_dir;
  RunOptions options;
  options.out_dir = out_dir;
  if (command.force) {  // earlier results go only when the scene is known to be sound
    options.prepare_output = [&] { prepare_output_folder(out_dir, true); };
  } else {
    prepare_output_folder(out_dir, false);
  }
  install_signal_handlers();
  options.progress = command.quiet ? Progress::Style::quiet : Progress::choose_style(stderr);
  const RunResult result = run_scene(deck, options);
  if (!command.quiet) report(result, out_dir);
  return result.exit_code;
}

}  // namespace percuss
