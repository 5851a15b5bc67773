#pragma once
// The texts of `percuss --help` and `percuss COMMAND --help` around the lists of options, in lines of at most 80
// columns. The manual page and the completion of shells are made from what these commands print (scripts/make_manual).

namespace percuss::help_texts {

inline constexpr const char* about =
    "percuss is an explicit finite element code for impact: solids and shells with\n"
    "general contact, beams, rigid bodies.";

inline constexpr const char* general = R"(
Examples:
  percuss check inputs/brick_wall/deck.yaml
  percuss run inputs/brick_wall/deck.yaml --out wall
  percuss plan inputs/brick_wall/deck.yaml --ranks 1,8,64
  percuss report wall
  percuss run deck.yaml --set time.end=1e-3 --set 'initial.0.velocity=[9, 0, 0]'

Exit codes:
  0    done
  2    the deck, a mesh or the command is wrong
  3    the run failed: an inverted element, an energy error above its limit, a
       value that is not finite
  4    the system failed: files, memory, MPI
  130  interrupted (Ctrl-C, SIGTERM, SIGUSR1, SIGHUP or SIGXCPU); results and a
       checkpoint for a restart are written; before the first step nothing is
       changed
mpirun returns the same codes, except after a signal to mpirun itself (Open MPI:
1 after Ctrl-C or SIGTERM) and when a rank is killed (137 after SIGKILL). Then
see `status` in summary.json: `running` means that the run was killed.

Environment:
  OMP_NUM_THREADS   threads per rank; default: one for each 1000 elements, at
                    most one per core that the rank may use. Ranks that are not
                    bound to cores share those of the machine
  OMP_PROC_BIND     how OpenMP binds threads to cores; default: no binding
  OMP_WAIT_POLICY   how threads wait; default: they spin for 20 microseconds, on
                    a busy machine not at all, then sleep

`percuss help COMMAND` or `percuss COMMAND --help` explains a command;
`percuss version` prints the version. docs/deck.md describes the deck.
)";

inline constexpr const char* run = R"(
Always writes summary.json. The deck's `output` selects fields.vtkhdf, with
fields.xdmf2 (ParaView) and fields.xdmf (VisIt) beside it, and history.csv.
Results go to the folder of --out, by default out/SCENE in the current folder.
SCENE is the deck's file name without extension, or the name of its folder if
the deck is called deck.yaml. A folder that is not empty is refused unless
--force is given, which overwrites an earlier run's files and nothing else. A
folder of an active run is always refused; run.lock in it names that run.

Ctrl-C, SIGTERM, SIGUSR1, SIGHUP and SIGXCPU stop the run after the current
step; it first writes a checkpoint. A second Ctrl-C ends it at once. Under
mpirun use `kill -USR1 PID_OF_MPIRUN`: mpirun passes it on at once and waits for
the ranks. After Ctrl-C Open MPI 4 waits one second before it signals its ranks,
and one more before it kills them. The option `--mca
odls_base_sigkill_timeout 10` of mpirun extends both waits to ten seconds.
During the run summary.json says `running`; if no run is active then, it was
killed. The run leaves a checkpoint at its end; `output.checkpoint` in the deck
writes more during it.

--restart continues from a checkpoint, on any number of ranks and threads. The
results are bit-identical to those of an uninterrupted run. It appends to
history and fields in the checkpoint's folder, or starts new ones in the empty
folder given by --out. time.end may be later than before;
the last step before the earlier end was shortened to end there. A restart that
would delete results beyond its own end is refused, unless --force is given.

Examples:
  percuss run inputs/taylor_bar/deck.yaml
  percuss run deck.yaml --out slow --set time.step_scale=0.5
  percuss run deck.yaml --restart out/deck/checkpoint.h5
  OMP_NUM_THREADS=4 percuss run deck.yaml --quiet
  OMP_NUM_THREADS=2 mpirun -n 8 --map-by slot:PE=2 percuss run deck.yaml

docs/output.md describes what a run writes.
)";

inline constexpr const char* check = R"(
Reads the deck, generates or reads its meshes, resolves every name, sums the
masses, computes the first time step and reports overlap at the start. Runs
nothing and writes no file.

--report runs a few steps in a temporary folder and writes one HTML page: the
scene with parts, sets, conditions, walls, velocities and overlaps, its masses
and steps by part, the predicted steps, time, memory and disk, and all warnings.

Examples:
  percuss check inputs/brick_wall/deck.yaml
  percuss check deck.yaml --set 'parts.rod.cylinder.cells=[16, 64]'
  percuss check deck.yaml --report --out before.html

docs/checks.md explains the warnings.
)";

inline constexpr const char* plan = R"(
Predicts on one process, without mpirun, how the scene would be divided among
ranks: elements and contact surfaces of each rank, messages and memory. From a
few figures of the machine it estimates the time of a step, the parallel
efficiency, the run time and the core hours. The table has a column for each
number of ranks. Runs nothing and writes no file; needs memory for the whole
mesh.

Examples:
  percuss plan inputs/brick_wall/deck.yaml --ranks 1,8,64
  percuss plan deck.yaml --ranks 512 --set 'parts.rod.cylinder.cells=[16, 64]'
  percuss plan deck.yaml --ranks 8,64 --latency 30e-6 --bandwidth 1e8

docs/plan.md explains every line.
)";

inline constexpr const char* schema = R"(
A JSON Schema (draft 2020-12) for editors: all keys with their meaning and
values, and which are required. Only percuss check finds errors that involve
several keys. Editors for YAML schemas, such as VS Code with its YAML extension,
look for a comment in the deck:

  # yaml-language-server: $schema=percuss.schema.json

Examples:
  percuss schema > percuss.schema.json
)";

inline constexpr const char* info = R"(
FILE is a summary.json, a fields.vtkhdf, a checkpoint.h5, a folder of results,
or a mesh file (docs/mesh.md).

Examples:
  percuss info out/brick_wall
  percuss info mesh.e
)";

}  // namespace percuss::help_texts
