"""The tables of docs/import.md name what the importer knows, and nothing else: import_page_test.py ROOT PERCUSS.

A word in backticks names a card. `*A_B` is one; `_C` behind it, or a bare `C` in the same row, is A_B_C, A_C or C. What handles any
ending, such as ELEMENT_, is on the page where a longer name is.
"""

import re
import unittest
from pathlib import Path

import given
from percuss.importing.abaqus import mesh, outputs  # noqa: E402
from percuss.importing.abaqus import read as abaqus  # noqa: E402
from percuss.importing.abaqus.options import KNOWN, OF_MATERIALS, OTHERS  # noqa: E402
from percuss.importing.dyna import contact_cards, control_cards, mesh_cards, output_cards, part_cards  # noqa: E402
from percuss.importing.dyna import read as dyna  # noqa: E402
from percuss.importing.dyna.forms import ANY, OPTIONS, find_form  # noqa: E402
from percuss.importing.dyna.materials.choice import LAWS, name_law  # noqa: E402
from percuss.importing.dyna.materials.names import NUMBERS, OF_77, SPRINGS  # noqa: E402
from percuss.importing.dyna.materials.states import STATES  # noqa: E402

ROOT = Path(given.ROOT)
PAGE = (ROOT / "docs/import.md").read_text(encoding="utf-8")
DYNA, ABAQUS = PAGE.split("\n## From LS-DYNA\n")[1].split("\n## From Abaqus\n")
SOURCE = "\n".join(path.read_text(encoding="utf-8") for path in (ROOT / "python/percuss/importing").rglob("*.py"))
# Read before the tables of cards are asked: by the reader of files, and by the names of other cards.
BY_READER = {"INCLUDE", "INCLUDE_PATH", "INCLUDE_TRANSFORM", "PARAMETER", "PARAMETER_EXPRESSION", "PARAMETER_LOCAL", "DEFINE_TRANSFORMATION",
             "CASE", "CASE_BEGIN", "CASE_END", "KEYWORD", "END"}  # fmt: skip
# Kinds of cards of which none is read: the page says so.
NOT_READ = {"AIRBAG", "CONSTRAINED_INTERPOLATION", "INTEGRATION"}


def list_rows(text):
    """Rows of tables as lists of cells, without heads; and paragraphs as one cell each."""
    for line in text.split("\n"):
        if line.startswith("|") and not re.match(r"\|( keyword| card| `\*MAT_` \||-)", line):
            yield [cell.strip() for cell in line.strip("|").split(" | ")]
    for paragraph in re.split(r"\n\s*\n", text):
        if not paragraph.startswith("|"):
            yield [paragraph]


def expand(words):
    """What the words of a row may name: a list of names for each."""
    last = ""
    for word in words:
        if word.startswith("*"):
            last = word[1:].split(",")[0].strip()
            yield word, [last.rstrip("_")]
        elif re.fullmatch(r"_?[A-Z0-9][A-Z0-9_/-]*_?", word):
            pieces, end = last.rstrip("_").split("_") if last else [], word.strip("_")
            last = last or word  # of a law, whose row has no star
            yield word, ["_".join([*pieces[:count], end]) for count in range(len(pieces), -1, -1)]


def list_words(cell):
    return re.findall(r"`([^`]+)`", cell)


def name_all(text):
    """Every name that the page may mean."""
    return {name for row in list_rows(text) for _, names in expand(word for cell in row for word in list_words(cell)) for name in names}


def list_dyna():
    """Names of the importer, with the options that it reads or refuses by name."""
    names = {*dyna.DEFINITIONS, *dyna.ACTIONS, *dyna.IGNORED, *dyna.MODIFIERS_READ, *STATES, *(f"DATABASE_{name}" for name in output_cards.ASCII)}
    names |= {f"CONTACT_{name}" for name in contact_cards.FAMILIES} | {f"CONTACT_{name}" for name in contact_cards.OPTIONS}
    names |= {f"CONTROL_{name}" for name in (*control_cards.HARMLESS, *control_cards.WITHOUT)}
    names |= {f"ELEMENT_{name}" for name in mesh_cards.OTHERS} | {f"SECTION_{name}" for name in part_cards.OTHER_SECTIONS - {"IGA", "POINT"}}
    names |= {f"{name.rstrip('_')}_{word}" for name, words in OPTIONS.items() if words != ANY and not name.startswith("SET_") for word in words.replace("|", " ").split()}
    return {name for name in names if not name[-1].isdigit() or name == "CONTROL_HOURGLASS_936"}


def is_named(name, page):
    """By itself; what has no meaning without an ending, by a longer name."""
    stem = name.rstrip("_")
    is_stem = name.endswith("_") or OPTIONS.get(name, "") not in ("", ANY) or name == "CONSTRAINED_GENERALIZED_WELD"
    return stem in page or (is_stem and any(other.startswith(f"{stem}_") for other in page))


def is_known(name):
    """Whether the importer knows a name, or the beginning of names that it knows."""
    if find_form([*dyna.DEFINITIONS, *dyna.ACTIONS], name)[0] or name in BY_READER | NOT_READ | set(dyna.IGNORED):
        return True
    return any(other.startswith(f"{name}_") for other in (*OPTIONS, *dyna.IGNORED)) or name in ("MAT", "EOS", "SET", "DEFINE", "DAMPING")


class ImportPage(unittest.TestCase):
    maxDiff = None

    def test_every_card_of_lsdyna_is_on_the_page(self):
        page = name_all(DYNA)
        self.assertEqual([name for name in sorted(list_dyna()) if not is_named(name, page)], [])

    def test_every_law_of_lsdyna_is_on_the_page(self):
        names = name_all(DYNA)
        laws = {*LAWS, *SPRINGS.values(), "RIGID", "ADD_EROSION", "ADD_DAMAGE_GISSMO", "ADD_DAMAGE_DIEM"}
        laws -= {name for name in LAWS if name.startswith("MODIFIED_PIECEWISE")}  # under its number, 123
        self.assertEqual(sorted(name for name in laws if not {name, f"MAT_{name}"} & names), [])
        table = DYNA.split("| `*MAT_` | law |")[1]
        numbers = {int(number) for row in re.findall(r"^\| ([^|]*)", table, re.MULTILINE) for number in re.findall(r"\b\d{3}(?!\d)", row)}
        read = {number for number, name in NUMBERS.items() if name in {*LAWS, "RIGID"}} | {int(name[:3]) for name in OF_77 if name.startswith("077")}
        self.assertEqual(numbers, read)

    def test_numbers_of_laws_are_those_of_their_names(self):
        table = DYNA.split("| `*MAT_` | law |")[1]
        for cell in re.findall(r"^\| ([0S][^|]*)", table, re.MULTILINE):
            for number, name in re.findall(r"\b(S?\d{2,3}(?:_[HO])?) `([^`]+)`", cell):
                self.assertEqual(name_law(f"MAT_{number}").removeprefix("MODIFIED_"), name.removeprefix("MODIFIED_"), cell)

    def test_the_page_names_no_card_of_lsdyna_that_the_importer_does_not_know(self):
        for row in list_rows(DYNA.split("| `*MAT_` | law |")[0]):
            words = list_words(row[0]) if len(row) > 1 else []
            unknown = [word for word, names in expand(words) if word.startswith(("*", "_")) and "..." not in word and not any(map(is_known, names))]
            self.assertEqual(unknown, [], row[0])

    def test_every_keyword_of_abaqus_is_on_the_page(self):
        page = name_all(ABAQUS) | set(re.findall(r"`\*([A-Z][A-Z -]+)", ABAQUS))
        known = {*abaqus.METHODS, *abaqus.ACTIONS, *abaqus.IGNORED, *KNOWN, *outputs.FOLLOWERS}
        of_materials = {name for name in OF_MATERIALS if f'"{name}"' in SOURCE} - {"VISCOUS"}  # which code asks for; that is a kind of *SECTION CONTROLS
        self.assertEqual(sorted(name for name in known | of_materials if name not in page), [])

    def test_the_page_names_no_keyword_of_abaqus_that_the_importer_does_not_know(self):
        known = {*abaqus.METHODS, *abaqus.ACTIONS, *abaqus.IGNORED, *outputs.FOLLOWERS, *OF_MATERIALS, *OTHERS, "INCLUDE", "PARAMETER"}
        begun = {name.split()[0] for name in OTHERS}  # such as CONNECTOR: all that begin so
        named = {name.strip() for name in re.findall(r"`\*([A-Z][A-Z -]+)", ABAQUS)}
        self.assertEqual(sorted(named - known - begun - {"CONTACT_TIED_"} - {name for name in named if name.endswith("_")}), [])

    def test_every_type_of_elements_of_abaqus_is_on_the_page(self):
        types = {*mesh.SOLIDS, *mesh.SHELLS, *mesh.BEAMS, *mesh.SPRINGS, *mesh.COHESIVE}
        self.assertEqual(sorted(kind for kind in types if not re.search(rf"\b{kind}\b", ABAQUS)), [])

    def test_every_field_on_the_page_is_one_of_the_importer(self):
        """Words in capitals of a row: fields, options and values of cards."""
        read = set(re.findall(r"[A-Z0-9]+", SOURCE.upper()))
        stems = {word.rstrip("0123456789") for word in read}  # numbered fields, such as SHRFAC1 and TRVEC6
        for row in list_rows(PAGE):
            words = [word for cell in row[:3] for word in re.findall(r"\b[A-Z][A-Z0-9]{2,}\b", cell)] if len(row) > 1 else []
            lost = [word for word in words if word not in read and word.rstrip("0123456789") not in stems and word not in ("RAX2", "SAX1", "C3D8RT")]
            self.assertEqual(lost, [], row[0])

    def test_finds_a_card_that_is_not_on_the_page(self):
        page = name_all("| card | x |\n| `*LOAD_NODE_SET`, `_POINT` | - |")
        self.assertTrue({"LOAD_NODE_SET", "LOAD_NODE_POINT"} <= page)
        self.assertFalse(is_named("LOAD_RIGID_BODY", page))
        self.assertTrue(is_named("LOAD_NODE_", page))
        self.assertFalse(is_known("LOAD_NODES"))


if __name__ == "__main__":
    unittest.main()
