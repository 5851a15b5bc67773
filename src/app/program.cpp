#include "src/app/program.hpp"

#include <fmt/format.h>

#include <csignal>
#include <cstdio>
#include <functional>

#include "comm/rendezvous.hpp"
#include "src/app/commands.hpp"
#include "src/app/process/failure_report.hpp"
#include "src/app/process/stop_signals.hpp"
#include "src/app/process/tools.hpp"
#include "src/output/files/safe_text.hpp"
#include "src/output/progress.hpp"
#include "src/step/run/stop_request.hpp"

namespace percuss {
namespace {

using Work = std::function<ExitCode()>;

ExitCode guard(const Work& work) {
  try {
    return work();
  } catch (...) {
    return tell(describe_failure());
  }
}

// Checks that the output arrived: a full disk or a closed pipe is a failure.
ExitCode finish_output(ExitCode code) {
  if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return code;
  return code == ExitCode::done ? tell({ExitCode::system_failed, "standard output cannot be written to"}) : code;
}

// The work of a rank among others. Rank 0 reports a failure of all ranks. A rank that fails alone reports it and ends
// the others, which wait for it.
ExitCode guard_on_ranks(const Communicator& ranks, const Work& work) {
  Rendezvous rendezvous(ranks);
  ExitCode code = ExitCode::done;
  try {
    code = work();
  } catch (const Interruption& interruption) {  // all ranks have agreed on it
    code = ExitCode::interrupted;
    if (ranks.rank() == 0) print_quietly(stderr, "percuss: {}\n", interruption.what());
  } catch (...) {
    const FailureReport failure = describe_failure();
    code = failure.code;
    const bool all_here = rendezvous.meet();
    if (ranks.rank() == 0 || !all_here) tell(failure);
    if (!all_here) ranks.abort(static_cast<int>(code));
  }
  ranks.barrier();  // mpirun ends every rank when the first one fails: not before the message is out
  return code;
}

ExitCode run_on_ranks(int argc, char** argv, const std::function<ExitCode(const Communicator&)>& command) {
  const MpiSession mpi(argc, argv);
  const Communicator world = Communicator::world();
  return guard_on_ranks(world, [&] { return command(world); });
}

// For what needs no other rank: mpirun starts it on all of them, and one is to be heard.
ExitCode run_on_rank_0(int argc, char** argv, const Work& work) {
  if (!is_launched()) return work();
  const MpiSession mpi(argc, argv);
  const Communicator world = Communicator::world();
  ExitCode code = world.rank() == 0 ? finish_output(guard(work)) : ExitCode::done;
  wait_mpi([&] { return MPI_Bcast(&code, 1, MPI_INT, 0, world.handle()); }, "MPI_Bcast");
  return code;
}

ExitCode execute(int argc, char** argv, const Command& command) {
  switch (command.kind) {
    case Command::Kind::run:
      return run_on_ranks(argc, argv, [&](const Communicator& ranks) { return run_command(command, ranks); });
    case Command::Kind::check:
      return run_on_ranks(argc, argv, [&](const Communicator& ranks) { return check_command(command, ranks); });
    case Command::Kind::plan:
      return run_on_ranks(argc, argv, [&](const Communicator& ranks) { return plan_command(command, ranks); });
    case Command::Kind::info:
      return run_on_rank_0(argc, argv, [&] { return info_command(command); });
    case Command::Kind::schema:
      return run_on_rank_0(argc, argv, schema_command);
  }
  return ExitCode::wrong_input;
}

ExitCode print_answer(const Answer& answer) {
  print_text(answer.exit_code == ExitCode::done ? stdout : stderr, answer.text);
  return answer.exit_code;
}

}  // namespace

int run_program(int argc, char** argv) {
  // A reader that went away or a file size limit is an error of the write, which is reported, not a silent end.
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
  const ExitCode code = guard([&] {
    become_tool(argc, argv);
    const auto parsed = parse_command_line(argc, argv);
    const auto* command = std::get_if<Command>(&parsed);
    const bool can_stop = command != nullptr && command->kind == Command::Kind::run;
    can_stop ? take_stop_signals() : release_stop_signals();
    if (const auto* answer = std::get_if<Answer>(&parsed)) {
      return run_on_rank_0(argc, argv, [&] { return print_answer(*answer); });
    }
    return execute(argc, argv, *command);
  });
  return static_cast<int>(guard([&] { return finish_output(code); }));
}

}  // namespace percuss
