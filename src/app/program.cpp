#include "src/app/program.hpp"

#include <fmt/format.h>

#include <Kokkos_Core.hpp>
#include <csignal>
#include <cstdio>
#include <functional>
#include <new>
#include <stdexcept>

#include "comm/communicator.hpp"
#include "src/app/commands.hpp"
#include "src/app/threads.hpp"
#include "src/output/progress.hpp"

namespace percuss {
namespace {

ExitCode tell(ExitCode code, const std::string& message) {
  // Messages about a file begin with its name and "error:"; the others need the program's name.
  const bool named = message.find(": error: ") != std::string::npos;
  std::fflush(stdout);
  print_quietly(stderr, "{}{}\n", named ? "" : "percuss: error: ", message);
  return code;
}

// Every way to fail, by the exit code that it ends with.
ExitCode guard(const std::function<ExitCode()>& work) {
  try {
    return work();
  } catch (const InputError& error) {
    return tell(ExitCode::wrong_input, error.what());
  } catch (const RunError& error) {
    return tell(ExitCode::run_failed, error.what());
  } catch (const SystemError& error) {
    return tell(ExitCode::system_failed, error.what());
  } catch (const MpiError& error) {
    return tell(ExitCode::system_failed, error.what());
  } catch (const std::bad_alloc&) {
    return tell(ExitCode::system_failed,
                "memory is exhausted (the scene is too large for this machine) make its mesh coarser");
  } catch (const std::length_error&) {
    return tell(ExitCode::system_failed,
                "memory is exhausted (the scene is too large for any machine) make its mesh coarser");
  } catch (const std::exception& error) {
    return tell(ExitCode::system_failed,
                fmt::format("internal error ({}) please report it with the deck", error.what()));
  }
}

// One rank so far: the others would only repeat it.
ExitCode run_on_one_rank(int argc, char** argv, const Command& command) {
  const MpiSession mpi(argc, argv);
  const Communicator world = Communicator::world();
  if (world.size() > 1) {
    if (world.rank() == 0) {
      tell(ExitCode::wrong_input,
           fmt::format("started on {} ranks (percuss runs on one rank so far) start it without mpirun and set "
                       "OMP_NUM_THREADS for threads",
                       world.size()));
    }
    world.barrier();  // mpirun ends every rank when the first one fails: not before the message is out
    return ExitCode::wrong_input;
  }
  choose_threads();
  const Kokkos::ScopeGuard kokkos;
  return guard([&] { return run_command(command); });
}

ExitCode check_with_kokkos(const Command& command) {
  choose_threads();
  const Kokkos::ScopeGuard kokkos;
  return guard([&] { return check_command(command); });
}

ExitCode execute(int argc, char** argv, const Command& command) {
  switch (command.kind) {
    case Command::Kind::run:
      return run_on_one_rank(argc, argv, command);
    case Command::Kind::check:
      return check_with_kokkos(command);
    case Command::Kind::info:
      return info_command(command);
  }
  return ExitCode::wrong_input;
}

// What was printed counts only if it arrived: a full disk or a closed pipe is a failure.
ExitCode finish_output(ExitCode code) {
  if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return code;
  return code == ExitCode::done ? tell(ExitCode::system_failed, "standard output cannot be written to") : code;
}

}  // namespace

int run_program(int argc, char** argv) {
  // A reader that went away or a file size limit is an error of the write, which is told; not a silent death.
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
  const ExitCode code = guard([&] {
    const auto parsed = parse_command_line(argc, argv);
    if (const auto* answer = std::get_if<Answer>(&parsed)) {
      fmt::print(answer->exit_code == ExitCode::done ? stdout : stderr, "{}", answer->text);
      return answer->exit_code;
    }
    return execute(argc, argv, std::get<Command>(parsed));
  });
  return static_cast<int>(guard([&] { return finish_output(code); }));
}

}  // namespace percuss
