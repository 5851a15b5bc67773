"""Runs random scenes and checks them. scripts/fuzz_scenes --help says how."""

import argparse
import os
import shlex
import shutil
import sys
from collections import Counter
from concurrent.futures import ThreadPoolExecutor

from percuss.libraries import MissingLibrary, require

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.realpath(__file__))))

EPILOG = """\
A seed makes a scene: 2 to 500 bodies of all generated shapes and most materials that strike each other at up to 2 km/s, with
friction, walls and one of the enforcements. It fails if

  run       the exit code is not 0              momentum   its error is above 1e-10
  end       the end is not reached              gain       contact gave more than 1e-4 of the initial energy
  depth     a body is in another by more than 0.01 of an element, 0.1 with penalty, for edges, and beyond 5 % of the wave speed
  inverted  corners are inverted                ranks, threads, restart   the state_hash is another one

Depth and corners are measured from fields.vtkhdf, without the code of contact. A scene that fails is made smaller as long as
it fails in the same way, and printed as a deck.

examples:
  scripts/fuzz_scenes 1-20                                the scenes of the test
  scripts/fuzz_scenes 17 --deck                           prints the scene of a seed, without running it
  scripts/fuzz_scenes 1-200 --no-shrink                   a table of what fails
  scripts/fuzz_scenes 1-120 --no-shrink --set elements.resist_folding=true   the same with another default
  scripts/fuzz_scenes 1-20 --known FILE                   what FILE lists may fail, and must
  scripts/fuzz_scenes 1-40 --bits                         bits of scenes over all keys

With --bits the scenes are others: few elements of every family, joined in every way, that rest, are struck, driven, loaded or
relaxed, with keys drawn from the schema of decks. Each fails unless state_hash, history.csv, the data of fields.vtkhdf, warnings and
figures of summary.json are the same on 1 x 2, 2 x 1 and 3 x 1 ranks x threads, after a restart at a random step on another number of
ranks, and with each switch by which the program does what it would skip (elements.skip_resting, contact.reuse_search, ...).

FILE has a line for each seed that fails today: the seed, the kinds of failure (a comma between them), the cause.

Exit codes: 0 nothing fails, or exactly what is known; 1 something else; 2 a wrong option, or a library is missing.
Needs Python 3 with NumPy and h5py (scripts/install_dependencies --report).
"""


def parse_arguments():
    parser = argparse.ArgumentParser(prog="scripts/fuzz_scenes", epilog=EPILOG,
                                     description="Runs random scenes and checks them.",
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    add = parser.add_argument
    add("seeds", metavar="SEED", nargs="+", help="a number, or a range as 1-20")
    add("--percuss", metavar="FILE", default=os.path.join(ROOT, "build/release/percuss"), help="the program")
    add("--jobs", metavar="N", type=int, default=1, help="scenes at the same time (default 1)")
    add("--set", dest="settings", metavar="KEY=VALUE", action="append", default=[],
        help="a setting of every scene, as of percuss run")
    add("--known", metavar="FILE", help="seeds that fail today")
    add("--most", metavar="N", type=int, default=0, help="as many scenes may fail beyond those known (default 0)")
    add("--no-shrink", dest="shrink", action="store_false", help="leave failing scenes as they are")
    add("--deck", action="store_true", help="print the decks only")
    add("--bits", action="store_true", help="compare bits, of scenes of all families and keys")
    add("--ranks", metavar="N", type=int, default=3, help="with --bits: at most so many ranks (default 3)")
    arguments = parser.parse_args()
    try:
        arguments.seeds = [seed for text in arguments.seeds for seed in read_range(text)]
    except ValueError:
        parser.error("a seed is a number or a range as 1-20")
    return arguments


def read_range(text):
    first, _, last = text.partition("-")
    return range(int(first), int(last or first) + 1)


def read_known(path):
    """{seed: kinds}; # begins a comment."""
    known = {}
    with open(path, encoding="utf-8") as file:
        for line in file:
            words = line.partition("#")[0].split(maxsplit=2)
            if words:
                known[int(words[0])] = set(words[1].split(","))
    return known


def find_mpirun():
    """As the tests give it, else Open MPI's on any number of cores."""
    given = os.environ.get("PERCUSS_MPIRUN")
    return (shlex.split(given) if given
            else [shutil.which("mpirun") or "mpirun", "--oversubscribe", "--bind-to", "none", "-n"])


def examine(program, seed, shrinks):
    """What fails, the figures, and the smallest deck that fails in the same way (None without failure)."""
    from fuzzing.judging import judge
    from fuzzing.scene import make_scene
    from fuzzing.shrinking import shrink

    deck = make_scene(seed)
    failures, figures = judge(program, deck)
    if not failures or not shrinks:
        return failures, figures, deck if failures else None
    kind = next(iter(failures))
    with_bits = kind in ("ranks", "threads", "restart")
    return failures, figures, shrink(deck, lambda smaller: kind in judge(program, smaller, with_bits)[0])


def compare_seeds(program, arguments):
    """The scenes of --bits; how many fail."""
    from fuzzing.comparing import Scenes, compare_scene
    from fuzzing.scene import write_deck

    scenes, failed, counts = Scenes(program), 0, Counter()
    with ThreadPoolExecutor(arguments.jobs) as pool:
        results = pool.map(lambda seed: (seed, *compare_scene(program, scenes, seed, arguments.ranks)), arguments.seeds)
        for seed, failures, figures, deck in results:
            print(f"seed {seed}: {'FAILS' if failures else 'ok'}: "
                  + " ".join(f"{key} {value:.3g}" for key, value in figures.items()))
            for kind, text in failures.items():
                print(f"  {kind}: {text}")
            if failures:
                print("  deck:\n    " + write_deck(deck).replace("\n", "\n    ").rstrip())
            failed += bool(failures)
            counts.update({"refused" if "refused" in figures else "rests" if figures["rests"] > 0 else "moves": 1})
            sys.stdout.flush()
    print(f"{len(arguments.seeds)} scenes, {failed} fail; "
          f"{', '.join(f'{kind} {count}' for kind, count in sorted(counts.items()))}")
    return failed


def report_seed(seed, failures, figures, deck, known, shrinks):
    """Prints a seed; whether it is as it is known."""
    from fuzzing.judging import add_output
    from fuzzing.scene import write_deck

    expected = known.get(seed, set())
    kinds = set(failures)
    verdict = "ok" if kinds == expected else "NOT AS KNOWN" if known else "FAILS"
    values = " ".join(f"{key} {value:.3g}" for key, value in figures.items() if isinstance(value, (int, float)))
    print(f"seed {seed}: {verdict}{' (fails as known)' if kinds and verdict == 'ok' else ''}: {values}")
    for kind, text in failures.items():
        print(f"  {kind}: {text}")
    for kind in sorted(expected - kinds):
        print(f"  {kind}: does not fail any more; remove it from the list of known failures")
    if deck and kinds - expected:
        print("  " + ("smallest deck found:" if shrinks else "deck:"))
        print("    " + write_deck(add_output(deck)).replace("\n", "\n    ").rstrip())
    sys.stdout.flush()
    return kinds == expected


def main():
    arguments = parse_arguments()
    try:
        require("scenes need", ("numpy", "h5py"))
    except MissingLibrary as error:
        print(f"fuzz_scenes: error: {error}", file=sys.stderr)
        sys.exit(2)
    from fuzzing.judging import Program
    from fuzzing.scene import make_scene, write_deck

    if arguments.deck and not arguments.bits:
        for seed in arguments.seeds:
            print(write_deck(make_scene(seed)))
        return
    if not os.access(arguments.percuss, os.X_OK):
        print(f"fuzz_scenes: error: there is no program {arguments.percuss}: run scripts/build", file=sys.stderr)
        sys.exit(2)
    known = read_known(arguments.known) if arguments.known else {}
    program = Program(arguments.percuss, find_mpirun(), arguments.settings)
    if arguments.bits:
        sys.exit(1 if compare_seeds(program, arguments) else 0)
    with ThreadPoolExecutor(arguments.jobs) as pool:
        results = pool.map(lambda seed: (seed, *examine(program, seed, arguments.shrink and seed not in known)),
                           arguments.seeds)
        verdicts, counts = [], Counter()
        for seed, failures, figures, deck in results:
            verdicts.append(report_seed(seed, failures, figures, deck, known, arguments.shrink))
            counts.update(failures.keys())
    wrong = verdicts.count(False)
    print(f"{len(verdicts)} scenes, {wrong} not as expected; "
          f"failures: {', '.join(f'{k} {n}' for k, n in sorted(counts.items())) or 'none'}")
    sys.exit(0 if wrong <= arguments.most else 1)


if __name__ == "__main__":
    main()
