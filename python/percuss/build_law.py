"""Compiles a material law as a library for model: library. percuss build-law --help says how."""

import argparse
import os
import re
import shlex
import subprocess
import sys
import tempfile
from typing import NoReturn

from percuss.help_format import HelpFormatter
from percuss.terminal import fail as end
from percuss.terminal import print_text

EPILOG = """\
LAW.hpp holds a law as those of kernels/material/laws are written: a struct with
name, Constants, keys(), history_count, moduli() and update(). The program
compiles it for this machine with the compiler in CXX, or c++. The library
belongs to this version of percuss: make it again after an update. The deck uses
it with {model: library, law: hardening.so, constants: {...}}.

Examples:
  percuss build-law hardening.hpp                     makes hardening.so
  percuss run deck.yaml --allow-library hardening.so

Exit codes:
  0    the library is made
  2    the input is wrong, or the law does not compile
  4    there is no compiler, or no file can be written

Needs Python 3 and a C++20 compiler. docs/user_laws.md describes laws.
"""
# What the headers of laws use of Kokkos: its words for functions.
MARKS = """\
#pragma once
#define KOKKOS_FUNCTION
#define KOKKOS_INLINE_FUNCTION inline
#define KOKKOS_FORCEINLINE_FUNCTION inline __attribute__((always_inline))
"""


def parse_arguments(words: list[str]) -> argparse.Namespace:
    parser = argparse.ArgumentParser(prog="percuss build-law", epilog=EPILOG,
                                     formatter_class=HelpFormatter,
                                     description="Compile a material law of your own as a library.")
    add = parser.add_argument
    add("law", metavar="LAW.hpp", help="the header of the law")
    add("--out", metavar="FILE", help="the library to write (default: LAW.so in the current folder)")
    add("--law", dest="name", metavar="NAME", help="the struct of the law, where the header has several")
    add("--quiet", action="store_true", help="say nothing when all is well")
    return parser.parse_args(words)


def fail(message: object, code: int = 2) -> NoReturn:
    end("percuss build-law", message, code)


def find_law(path: str, wanted: str | None) -> str:
    """The struct that is the law: the wanted one, or the one that has a table of keys."""
    try:
        with open(path, encoding="utf-8") as file:
            text = file.read()
    except (OSError, UnicodeDecodeError) as error:
        fail(f"cannot read {path} ({getattr(error, 'strerror', None) or 'it is no text'})")
    if wanted:
        if not re.fullmatch(r"\w+(::\w+)*", wanted):
            fail(f"'{wanted}' is not the name of a struct: give that of the law")
        return wanted
    parts = re.split(r"^struct\s+(\w+)[^;{]*\{", text, flags=re.MULTILINE)  # not what a struct has inside
    laws = [name for name, body in zip(parts[1::2], parts[2::2]) if re.search(r"\bkeys\s*\(\s*\)", body)]
    if len(laws) != 1:
        found = f"it has the laws {', '.join(laws)}" if laws else "it has no struct with keys()"
        fail(f"{path} holds no single law ({found}): name its struct with --law")
    return laws[0]


def find_headers() -> str:
    """The folder that holds kernels/material: of the checkout or the installation that this package belongs to."""
    root = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
    if not os.path.exists(os.path.join(root, "kernels", "material", "user", "export_law.hpp")):
        fail(f"there are no headers of laws in {root} (they belong to the checkout or installation of percuss): "
             "start the program there", 4)
    return root


def find_flags() -> list[str]:
    """The compiler's options that decide how a point is laid out, which must be those of the program."""
    flags = os.environ.get("PERCUSS_LAW_FLAGS")
    if flags is None:
        fail("the options of the program's compiler are not known: start this as percuss build-law")
    return shlex.split(flags or "")


def compile_law(source: str, name: str, out: str) -> None:
    root, flags = find_headers(), find_flags()
    with tempfile.TemporaryDirectory() as folder:
        with open(os.path.join(folder, "Kokkos_Core.hpp"), "w", encoding="utf-8") as file:
            file.write(MARKS)
        code = os.path.join(folder, "law.cpp")
        with open(code, "w", encoding="utf-8") as file:
            file.write(f'#include "{os.path.basename(source)}"\n#include "kernels/material/user/export_law.hpp"\n'
                       f"using namespace percuss;\nPERCUSS_EXPORT_LAW({name})\n")
        made = os.path.join(folder, "law.so")
        compiler = shlex.split(os.environ.get("CXX", "c++"))
        words = [*compiler, "-std=c++20", "-O3", "-DNDEBUG", "-shared", "-fPIC", "-fvisibility=hidden", *flags, "-I",
                 folder, "-I", os.path.dirname(os.path.abspath(source)), "-I", root, "-o", made, code]
        try:
            done = subprocess.run(words, capture_output=True, text=True, errors="replace", check=False)
        except OSError as error:
            fail(f"cannot start the compiler {compiler[0]} ({error.strerror}): install g++, or name one in CXX", 4)
        if done.returncode != 0:
            print_text(done.stderr.rstrip(), sys.stderr)
            fail(f"{source} does not compile (see above)")
        try:
            with open(made, "rb") as library:
                content = library.read()
            with open(out, "wb") as file:
                file.write(content)
        except OSError as error:
            fail(f"cannot write {out} ({error.strerror})", 4)


def main(words: list[str]) -> int:
    arguments = parse_arguments(words)
    name = find_law(arguments.law, arguments.name)
    out = arguments.out or os.path.splitext(os.path.basename(arguments.law))[0] + ".so"
    if os.path.abspath(out) == os.path.abspath(arguments.law):
        fail(f"{out} is the law itself: give another file with --out")
    compile_law(arguments.law, name, out)
    if not arguments.quiet:
        print_text(f"percuss build-law: {out} has the law {name}")
    return 0
