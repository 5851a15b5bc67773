"""percuss import, the table of proofs: import_proofs_test.py ROOT PERCUSS [--rows | --more] [FAMILY...]. --rows: each row once;
--more: rows once more, in other units and with all output. The page in proofs/__init__.py says how it works."""

import contextlib
import csv
import io
import json
import math
import multiprocessing
import os
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
from dataclasses import replace

import proofs
from given import PERCUSS, WORDS
from import_command import call_command  # noqa: E402
from percuss.importing.abaqus import read as abaqus  # noqa: E402
from percuss.importing.abaqus.options import KNOWN  # noqa: E402
from percuss.importing.dyna import read as dyna  # noqa: E402
from percuss.importing.dyna.contact_cards import FAMILIES, split_name  # noqa: E402
from percuss.importing.dyna.forms import ANY, OPTIONS, find_form  # noqa: E402
from percuss.importing.dyna.materials.choice import LAWS, SPRINGS, name_law  # noqa: E402
from percuss.importing.dyna.materials.states import STATES  # noqa: E402
from percuss.importing.fields import Row  # noqa: E402
from percuss.importing.ledger import BadInput, Ledger  # noqa: E402

TRIALS = (1, 2, 7)
UNITS = {"mass": 1e3, "time": 1e3, "length": 1e-3}  # factors from t, s, mm to kg, ms, m
TABLE, NOT_PHYSICS = proofs.load()
FAMILIES_ASKED = [word for word in WORDS if not word.startswith("--")]
PROOFS = [proof for proof in TABLE if not FAMILIES_ASKED or proof.family in FAMILIES_ASKED]
# One element needs one thread, and a run alone no messages between computers.
os.environ |= {"OMP_NUM_THREADS": "1", "OMP_PROC_BIND": "false", "OMPI_MCA_pml": "ob1", "OMPI_MCA_btl": "self", "PERCUSS_PROGRAM": PERCUSS}


def write(folder, proof, text=None):
    """The deck of a row, or another text in its place, with its files."""
    path = os.path.join(folder, "deck.inp" if proof.is_abaqus() else "deck.k")
    text = text if text is not None else proof.deck
    with open(path, "wb") as file:
        file.write(text if isinstance(text, bytes) else text.encode())
    for name, more in proof.files.items():
        with open(os.path.join(folder, name), "w", encoding="utf-8") as file:
            file.write(more)
    return path


def compile_code(proof, folder):
    """The options that allow the user code of a row."""
    if not proof.code:
        return []
    with open(os.path.join(folder, "law.c"), "w", encoding="utf-8") as file:
        file.write(proof.code)
    subprocess.run(["cc", "-O1", "-shared", "-fPIC", "-o", "law.so", "law.c", "-lm"], cwd=folder, check=True)
    return ["--allow-library", "law.so"]


def run_deck(folder, allowed=()):
    words = [PERCUSS, "run", "m/deck.yaml", "--out", "r", "--quiet", *allowed]
    done = subprocess.run(words, capture_output=True, text=True, errors="replace", timeout=120, cwd=folder, check=False)
    return done.returncode, done.stdout + done.stderr


def prove_row(number):
    """A row of PROOFS, by a process of the pool."""
    with tempfile.TemporaryDirectory() as folder:
        return prove(PROOFS[number], folder)


def prove(proof, folder):
    """Imports, runs and compares; what is wrong, or an empty text."""
    if proof.code and not shutil.which("cc"):
        return ""
    path, allowed = write(folder, proof), compile_code(proof, folder)
    options = [*allowed, *(["--allow", proof.allow] if proof.allow else []), *(["--case", proof.case] if proof.case else []), *([] if proof.refused else ["--no-check"])]  # the run checks
    done = call_command([os.path.basename(path), "--out", "m", "--quiet", *options], folder)
    code, text = done.returncode, done.stdout + done.stderr
    if proof.refused:
        count = text.count(": error: ")
        if code == 2 and proof.refused in text and proof.messages in (0, count):
            return ""
        return f"import ends with {code} and {count} errors, and should say '{proof.refused}':\n{text}"
    if code:
        return f"import ends with {code}:\n{text}"
    code, text = run_deck(folder, allowed)
    if (code, proof.fails in text) != ((3, True) if proof.fails else (0, True)):
        return f"run ends with {code}:\n{text}"
    history = read_history(folder)
    if "whole.k" in proof.files:
        history = restore_units(folder, history)
    return "\n".join(filter(None, (compare(right, history) for right in proof.rights)))


def convert(number):
    """Proves a row of PROOFS once more with its deck in a file of *INCLUDE_TRANSFORM, in other units: the same values in the units of the row.
    None where the import says that a card of it has no known units."""
    proof = PROOFS[number]
    main = f"*KEYWORD\n*INCLUDE_TRANSFORM\nwhole.k\n0\n0\n{UNITS['mass']!r},{UNITS['time']!r},{UNITS['length']!r}\n0\n*END\n"
    whole = replace(proof, deck=main, files={**proof.files, "whole.k": proof.deck})
    with tempfile.TemporaryDirectory() as folder:
        wrong = prove(whole, folder)
    return None if "a card in a file whose units are changed" in wrong else wrong


def is_convertible(proof):
    """Whether a row is of a keyword deck that runs; of numbers of the summary the units are not known."""
    by_summary = any(isinstance(what, str) and what.startswith("summary:") for what, *_ in proof.rights)
    return isinstance(proof.deck, str) and "*CASE" not in proof.deck and not proof.is_abaqus() and not proof.refused and not proof.fails and not by_summary


def restore_units(folder, history):
    """The columns of a converted run in the units of its row."""
    with open(os.path.join(folder, "r/columns.json"), encoding="utf-8") as file:
        columns = json.load(file)["columns"]
    factors = {column["name"]: math.prod(find_factor(word) for word in column["dimension"].split()) for column in columns}
    return {name: [value / factors[name] for value in values] for name, values in history.items() if name in factors}


def find_factor(word):
    """Of a power in a dimension, such as length^-1."""
    name, _, power = word.partition("^")
    return UNITS.get(name, 1.0) ** int(power or 1)


def read_history(folder):
    """Columns of history.csv, and numbers of summary.json under 'summary:KEY'."""
    with open(os.path.join(folder, "r/history.csv"), encoding="utf-8") as file:
        rows = list(csv.reader(file))
    history = {name: [float(row[i]) for row in rows[1:]] for i, name in enumerate(rows[0])}
    with open(os.path.join(folder, "r/summary.json"), encoding="utf-8") as file:
        summary = json.load(file)
    return history | {f"summary:{key}": [float(value)] for key, value in summary.items() if isinstance(value, (int, float))}


def pick(values, when, times):
    """The values that count."""
    if when == proofs.ALL:
        return values
    if isinstance(when, (int, float)):
        after = next((i for i, time in enumerate(times) if time >= when), len(times) - 1)
        before = max(after - 1, 0)
        share = (when - times[before]) / (times[after] - times[before]) if after > before else 0.0
        return [values[before] + share * (values[after] - values[before])]
    chosen = {proofs.FIRST: lambda: values[0], proofs.LAST: lambda: values[-1], proofs.MAX: lambda: max(values), proofs.MIN: lambda: min(values),
              proofs.LARGEST: lambda: max(values, key=abs)}  # fmt: skip
    return [chosen[when]()]


def compare(right, history):
    """What is wrong with a value, or an empty text."""
    what, when, value, tolerance = right
    if isinstance(what, str) and what not in history:
        return f"there is no column {what} (there are {' '.join(history)})"
    values = what(history) if callable(what) else history[what]
    for found in pick(values, when, history["time"]) if isinstance(values, list) else [values]:
        if not abs(found - value) <= tolerance * (abs(value) or 1.0):
            name = what if isinstance(what, str) else "the expression"
            return f"{name} ({when}) is {found:.8g}, right is {value:.8g} within {tolerance:g}"
    return ""


ASKED = ("NODOUT", "ELOUT", "GLSTAT", "MATSUM", "RCFORC", "SPCFORC", "BNDOUT", "RWFORC", "SECFORC", "SLEOUT", "DEFORC", "JNTFORC", "SWFORC", "RBDOUT", "BINARY_D3PLOT")
FOLLOWED = "".join(f"*DATABASE_HISTORY_{kind}\n1,2,3\n" for kind in ("NODE", "SOLID", "SHELL", "BEAM")) + "*DATABASE_CROSS_SECTION_PLANE\n0,5.0,5.0,4.0,5.0,5.0,9.0\n\n"


def ask_for_all(proof):
    """The deck of a row that asks for all output there is: of each of its sets, and of the whole."""
    if not proof.is_abaqus():
        head, _, tail = proof.deck.rpartition("*END")
        return f"{head}{''.join(f'*DATABASE_{name}{chr(10)}1e-6{chr(10)}' for name in ASKED)}{FOLLOWED}*END{tail}"
    sets = {kind: sorted(set(re.findall(rf"\b{kind} *= *([\w.-]+)", proof.deck, re.IGNORECASE))) for kind in ("NSET", "ELSET")}
    asked = ["*OUTPUT, HISTORY", *(line for name in sets["NSET"] for line in (f"*NODE OUTPUT, NSET={name}", "U, V, RF, RM, CF")),
             *(line for name in sets["ELSET"] for line in (f"*ELEMENT OUTPUT, ELSET={name}", "S, PEEQ", f"*ENERGY OUTPUT, ELSET={name}", "ALLKE")),
             "*CONTACT OUTPUT", "CFN", "*ENERGY OUTPUT", "ALLKE", "*OUTPUT, FIELD, VARIABLE=ALL"]  # fmt: skip
    head, _, tail = proof.deck.rpartition("*END STEP")
    return "\n".join([head.rstrip("\n"), *asked, "*END STEP"]) + tail


def check_asked(number):
    """Whether percuss check passes what a row becomes that asks for all output: words of the error, or an empty text; None where the import refuses it."""
    proof = PROOFS[number]
    with tempfile.TemporaryDirectory() as folder:
        path, allowed = write(folder, proof, ask_for_all(proof)), compile_code(proof, folder)
        options = [*allowed, *(["--allow", proof.allow] if proof.allow else []), *(["--case", proof.case] if proof.case else [])]
        done = call_command([os.path.basename(path), "--out", "m", "--quiet", *options], folder)
    is_own = done.returncode != 2 or "percuss check" in done.stderr
    return "" if done.returncode == 0 else f"import ends with {done.returncode}:\n{done.stderr}" if is_own else None


class Layouts:
    """Notes the rows of fields that a deck reaches."""

    def __init__(self):
        self.found = {}  # (card, field): whether it has a reason; the row of the table, the line, its fields and layout

    @contextlib.contextmanager
    def watch(self, key):
        original, layouts = Row.__init__, self

        def note(row, card, place, layout, texts):
            original(row, card, place, layout, texts)
            for index, word in enumerate(layout.split()):
                name = re.split("[=~]", word)[0]
                layouts.found.setdefault((card, name), ("~" in word and not word.endswith("~"), key, place.line, index, list(texts), layout))

        Row.__init__ = note
        try:
            yield
        finally:
            Row.__init__ = original


def read_in_process(proof, folder, text=None):
    """Model or error, and the ledger, without a process."""
    ledger = Ledger(allowed=[word.strip().upper() for word in proof.allow.split(",") if word.strip()], case=proof.case, user_code="law.so" if proof.code else "")
    reader = abaqus.read_abaqus_deck if proof.is_abaqus() else dyna.read_keyword_deck
    try:
        reader(write(folder, proof, text), ledger)
    except BadInput as error:
        return str(error), ledger
    return "", ledger


def change(proof, line, index, texts, layout, value):
    """The deck with another value of a field: its line is written with commas."""
    lines = proof.deck.split("\n")
    texts = [texts[i] if i < len(texts) else "" for i in range(max(len(layout.split()), index + 1))]
    is_there = any(texts)
    texts[index] = str(value)
    row = ",".join(texts) + ("," if len(texts) == 1 else "")
    lines[line - 1 : line] = [row] if is_there or not lines[line - 1].strip() else [lines[line - 1], row]
    return "\n".join(lines)


def find_group(card):
    """Cards whose lines of one layout are read by the same function: a field of one of them proves that of the others."""
    contact = split_name(card) if card.startswith("CONTACT_") else None
    if contact:
        return f"CONTACT {FAMILIES[contact[0]]}"
    if card.startswith(("MAT_", "EOS_", "SECTION_", "CONTROL_")):
        return card
    return next((name for table in (dyna.DEFINITIONS, dyna.ACTIONS) if (name := dyna.find_handler(table, card))), card)


def find_unproven_fields():
    """Fields that no row names, that have no reason, and that an import does not refuse by name."""
    proven = {name for proof in TABLE for name in proof.list_proven()}
    layouts, unproven = Layouts(), []
    with tempfile.TemporaryDirectory() as folder:
        keyword_decks = [proof for proof in TABLE if isinstance(proof.deck, str) and not proof.is_abaqus() and not proof.refused]
        for number, proof in enumerate(keyword_decks):
            with layouts.watch(number):
                read_in_process(proof, folder)
        shared = {(find_group(card), row[-1], name) for (card, name), row in layouts.found.items() if f"{card}.{name}" in proven}
        for (card, name), (has_reason, number, line, index, texts, layout) in layouts.found.items():
            if has_reason or (find_group(card), layout, name) in shared or f"{card}.{name}" in NOT_PHYSICS:
                continue
            proof = keyword_decks[number]
            for value in TRIALS:
                if (texts[index] if index < len(texts) else "") == str(value):
                    continue
                error, ledger = read_in_process(proof, folder, change(proof, line, index, texts, layout, value))
                told = error + " ".join(f"{entry.card} {entry.text}" for entry in ledger.list_refused())
                if not re.search(rf"\b{re.escape(name)}\b", told):
                    unproven.append(f"{card}.{name}")
                    break
    return sorted(set(unproven))


def list_cards():
    """Names of tables of the importer that a row must prove: keywords or their beginnings, materials, equations of state, contacts."""
    laws = {f"MAT_{name}" for name in (*LAWS, *SPRINGS.values(), "RIGID")}
    forms = {f"{name}{word}" for name, words in OPTIONS.items() if name.endswith("_") and words != ANY for word in words.partition("|")[0].split()}
    states = {name for name in STATES if not name[-1].isdigit()}
    return sorted({*dyna.DEFINITIONS, *dyna.ACTIONS, *laws, *forms, *states, *(f"CONTACT_{name}" for name in FAMILIES)})


def list_options():
    """Keywords with each option of theirs; all kinds of sets have the same."""
    names = [name for name, words in OPTIONS.items() if words != ANY and not name.endswith("_") and not name.startswith("SET_")]
    return sorted(f"{name}_{word}" for name in names for word in OPTIONS[name].replace("|", " ").split())


def has_option(card, option):
    """Whether a card of a row has a keyword with an option: BOUNDARY_SPC_NODE_BIRTH_DEATH has BOUNDARY_SPC_BIRTH_DEATH."""
    name = find_form(OPTIONS, option)[0]
    return find_form(OPTIONS, card)[0] == name and option[len(name) :] + "_" in card[len(name) :] + "_"


def list_tables_of(card):
    """The names of the tables that a card of a row proves."""
    if card.startswith("MAT_"):
        return {"MAT_", f"MAT_{name_law(card)}"}
    contact = split_name(card) if card.startswith("CONTACT_") else None
    return {card, *(dyna.find_handler(table, card) for table in (dyna.DEFINITIONS, dyna.ACTIONS)), *([f"CONTACT_{contact[0]}"] if contact else [])}


def list_keywords():
    """Keywords of Abaqus with their options."""
    names = {*abaqus.METHODS, *abaqus.ACTIONS, *KNOWN}
    options = {f"{keyword}.{word.replace('_', ' ')}" for keyword, words in KNOWN.items() for word in words.split()}
    return sorted(f"abaqus {name}" for name in names | options)


def find_unproven_cards():
    """Of both kinds of decks."""
    keyword_rows = {name for proof in TABLE if not proof.is_abaqus() for name in proof.list_proven()}
    handled = {table for name in keyword_rows if "." not in name for table in list_tables_of(name)}
    abaqus_rows = {name.replace("_", " ") for proof in TABLE if proof.is_abaqus() for name in proof.list_proven()}
    explained = {name.replace("_", " ") for name in NOT_PHYSICS}
    cards = [name for name in list_cards() if name not in handled and name not in NOT_PHYSICS]
    cards += [name for name in list_options() if name not in NOT_PHYSICS and not any(has_option(card, name) for card in keyword_rows)]
    keywords = [name for name in list_keywords() if name.removeprefix("abaqus ") not in abaqus_rows | explained]
    return cards + keywords


class Proofs(unittest.TestCase):
    def test_every_row_gives_its_values(self):
        with multiprocessing.get_context("fork").Pool(2) as pool:
            for proof, wrong in zip(PROOFS, pool.imap(prove_row, range(len(PROOFS)), 4)):
                with self.subTest(family=proof.family, proves=proof.proves):
                    self.assertFalse(wrong, f"{proof.why}\n{wrong}")

    def test_what_is_written_passes_its_check(self):
        """Whatever a deck asks for: no check refuses what the import has made of its cards."""
        numbers = [number for number, proof in enumerate(PROOFS) if isinstance(proof.deck, str) and not proof.refused and not proof.fails and "*CASE" not in proof.deck]
        with multiprocessing.get_context("fork").Pool(2) as pool:
            found = list(zip(numbers, pool.imap(check_asked, numbers, 4)))
        for number, wrong in found:
            with self.subTest(family=PROOFS[number].family, proves=PROOFS[number].proves):
                self.assertFalse(wrong, wrong)
        if not FAMILIES_ASKED:
            self.assertGreater(sum(wrong == "" for _, wrong in found), 0.9 * len(found))

    def test_units_of_a_file_convert_each_field(self):
        """FCTMAS, FCTTIM and FCTLEN: no row gives other values, but those with cards that the import refuses there."""
        numbers = [number for number, proof in enumerate(PROOFS) if is_convertible(proof)]
        with multiprocessing.get_context("fork").Pool(2) as pool:
            found = list(zip(numbers, pool.imap(convert, numbers, 4)))
        for number, wrong in found:
            with self.subTest(family=PROOFS[number].family, proves=PROOFS[number].proves):
                self.assertFalse(wrong, f"{PROOFS[number].why}\n{wrong}")
        if not FAMILIES_ASKED:
            self.assertGreater(sum(wrong == "" for _, wrong in found), 0.9 * len(found))

    def test_every_card_and_field_has_a_row(self):
        unproven = sorted({*find_unproven_cards(), *find_unproven_fields()})
        self.assertEqual(unproven, [], "these have no row: add one (proofs/__init__.py says how)")

    def test_every_row_proves_something(self):
        for proof in TABLE:
            with self.subTest(proves=proof.proves):
                self.assertTrue(proof.proves and (proof.rights or proof.refused or proof.fails))


def load_tests(loader, _tests, _pattern):
    again = ("test_what_is_written_passes_its_check", "test_units_of_a_file_convert_each_field")
    names = [name for name in loader.getTestCaseNames(Proofs) if ("--rows" if name in again else "--more") not in WORDS]
    return unittest.TestSuite(map(Proofs, names))


if __name__ == "__main__":
    if WORDS == ["--unproven"]:
        with contextlib.redirect_stderr(io.StringIO()):
            print("\n".join(sorted({*find_unproven_cards(), *find_unproven_fields()})))
        sys.exit()
    unittest.main()
