"""Damaged decks for percuss import: import_fuzz.py ROOT [--seconds N | --count N] [--first SEED] [--keep DIR].

Each mutant must become a deck of finite numbers or be refused by a message with exit code 2: no traceback, no hang, no memory by a number in it.
"""

import argparse
import contextlib
import io
import os
import random
import re
import signal
import sys
import tempfile
import time
import traceback

NO_NUMBER = re.compile(r"[-:\[,\s][-+]?\.?(nan|inf|infinity)\s*($|[,\]}\s])", re.IGNORECASE)
LIMIT = 20  # seconds for one mutant, of which a sound one takes 10 ms
MEMORY = 2 << 30
WORDS = ["0", "-1", "1e308", "1e-308", "nan", "inf", "ALL",
         "99999999999999999999", "1000000000000000", "*", "*END", "&a", "&", ",", ",,,,", "",
         "-", "1-400", "$", "\t", "\u00e9", "2147483648", "<a+1>", "*INCLUDE", "../x", "part.k", "*INCLUDE_TRANSFORM", "*CASE_BEGIN_1", "+", "MIRROR", "*KEYWORD LONG=Y", "*NODE", "*PART", "=", "**"]  # fmt: skip


def mutate(text: str, others: list[str], random_: random.Random) -> str:
    """A few changes of lines, fields and characters."""
    lines = text.split("\n")
    for _ in range(random_.choice((1, 1, 2, 3, 6))):
        at = random_.randrange(len(lines))
        kind = random_.randrange(9)
        if kind == 0:
            del lines[at]
        elif kind == 1:
            lines.insert(at, random_.choice(lines))
        elif kind == 2:
            lines[at] = replace_field(lines[at], random_)
        elif kind == 3:
            lines[at] = lines[at][: random_.randrange(len(lines[at]) + 1)]
        elif kind == 4:
            lines[at] = change_character(lines[at], random_)
        elif kind == 5:
            lines.insert(at, random_.choice(WORDS))
        elif kind == 6:
            other = random_.choice(others).split("\n")
            start = random_.randrange(len(other))
            lines[at:at] = other[start : start + random_.randrange(1, 12)]
        elif kind == 7:
            del lines[at : at + random_.randrange(1, 8)]
        else:
            lines = lines[: at + 1]
        lines = lines or [""]
    return "\n".join(lines)


def replace_field(line: str, random_: random.Random) -> str:
    word = random_.choice(WORDS)
    if "," in line:
        words = line.split(",")
        words[random_.randrange(len(words))] = word
        return ",".join(words)
    width = random_.choice((8, 10, 10, 16))
    start = width * random_.randrange(max(len(line) // width, 1))
    return f"{line[:start]:{start}}{word:>{width}}{line[start + width:]}"


def change_character(line: str, random_: random.Random) -> str:
    at = random_.randrange(len(line) + 1)
    return line[:at] + chr(random_.choice((*range(32, 127), 9, 0, 233))) + line[at + random_.randrange(2) :]


class TooLong(Exception):
    """A mutant took longer than it may."""


def try_mutant(text: str, folder: str, ending: str) -> str:
    """Imports it in this process; what is wrong, or an empty text."""
    from percuss.importing.command import import_model
    from percuss.importing.ledger import BadInput

    path = os.path.join(folder, "mutant" + ending)
    with open(path, "w", encoding="utf-8", newline="") as file:
        file.write(text)
    arguments = argparse.Namespace(model=path, out=os.path.join(folder, "out"), units="", allow=["all"], check=False, force=True, quiet=False, fit_rates=False, case="", allow_library="")
    signal.signal(signal.SIGPROF, stop)
    signal.setitimer(signal.ITIMER_PROF, LIMIT)  # of its own time: a busy machine is no hang
    output, errors = io.StringIO(), io.StringIO()
    try:
        with contextlib.redirect_stdout(output), contextlib.redirect_stderr(errors):
            code = import_model(arguments)
        if code == 0:
            return find_nonsense(os.path.join(folder, "out"))
        return "" if code == 2 and "error:" in errors.getvalue() else f"exit code {code} without a message"
    except BadInput as error:
        return "" if path in str(error) or folder in str(error) or ".k" in str(error) or ".inp" in str(error) else f"no place: {error}"
    except Exception:  # noqa: BLE001  (any other is a finding)
        return traceback.format_exc()
    finally:
        signal.setitimer(signal.ITIMER_PROF, 0)


def find_nonsense(folder: str) -> str:
    """A number of the written deck or mesh that is none, or an empty text."""
    for name in ("deck.yaml", "mesh.k"):
        with open(os.path.join(folder, name), encoding="utf-8") as file:
            for number, line in enumerate(file, 1):
                if NO_NUMBER.search(line) and not line.lstrip().startswith(("#", "$", "title:")):
                    return f"{name}:{number} has no number: {line.strip()}"
    return ""


def stop(*_: object) -> None:
    raise TooLong


def list_seeds() -> list[tuple[str, str]]:
    """Decks and their endings."""
    import import_decks as decks
    import proofs

    texts = [text for name, text in vars(decks).items() if name.isupper() and isinstance(text, str) and text.startswith("*KEYWORD")]
    texts += [decks.make_block(cards, state, shells) for _, cards, state, shells in decks.LAWS.values()]
    seeds = [(text, ".k") for text in texts] + [(decks.ABAQUS, ".inp")] * 4 + [(decks.ABAQUS_ROLLER, ".inp"), (decks.ABAQUS_STRESSED, ".inp")]
    rows = [proof for proof in proofs.load()[0] if isinstance(proof.deck, str)]
    return seeds + [(proof.deck, ".inp" if proof.is_abaqus() else ".k") for proof in rows]


def write_files(folder: str) -> None:
    """Files that seeds include."""
    import proofs

    for proof in proofs.load()[0]:
        for name, text in proof.files.items():
            with open(os.path.join(folder, name), "w", encoding="utf-8") as file:
                file.write(text)


def fuzz(count: int, seconds: float, first: int, keep: str) -> int:
    """Tries mutants; how many findings there are."""
    seeds = list_seeds()
    findings, number, end = 0, first, time.monotonic() + seconds
    with tempfile.TemporaryDirectory() as folder:
        write_files(folder)
        while number < first + count and (not seconds or time.monotonic() < end):
            random_ = random.Random(number)
            text, ending = seeds[number % len(seeds)]
            mutant = mutate(text, [other for other, its in seeds if its == ending], random_)
            wrong = try_mutant(mutant, folder, ending)
            if wrong:
                findings += 1
                print(f"mutant {number}: {wrong}", file=sys.stderr)
                if keep:
                    with open(os.path.join(keep, f"import_{number}{ending}"), "w", encoding="utf-8", newline="") as file:
                        file.write(mutant)
            number += 1
    print(f"fuzz: import: {number - first} mutants, {findings} findings")
    return findings


def main() -> int:
    parser = argparse.ArgumentParser()
    parser.add_argument("root")
    parser.add_argument("--count", type=int, default=10**9)
    parser.add_argument("--seconds", type=float, default=0.0)
    parser.add_argument("--first", type=int, default=0)
    parser.add_argument("--keep", default="")
    arguments = parser.parse_args()
    limit_memory()
    return 1 if fuzz(arguments.count, arguments.seconds, arguments.first, arguments.keep) else 0


def limit_memory() -> None:
    import resource

    resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))


if __name__ == "__main__":
    sys.exit(main())
