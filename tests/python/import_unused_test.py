"""percuss import, the report names each card once, and none that the deck does not have: import_unused_test.py ROOT PERCUSS."""

import re
import unittest
from collections import Counter

import import_decks as decks
import import_test
from percuss.importing.ledger import ELSEWHERE, Status

# One of each kind that nothing refers to; ids that no card of the deck has.
UNUSED = """\
*HOURGLASS
901,4,0.05
*SECTION_SHELL
902,2
3.0,3.0,3.0,3.0
*SECTION_SOLID
903,1
904,2
*SECTION_TSHELL
905,1
*SECTION_BEAM
906,1,1.0,2.0,1
2.0,2.0
*SECTION_DISCRETE
907,0
*INTEGRATION_BEAM
908,0,0,8
2.0
*MAT_ELASTIC
909,7850.0,2e11,0.3
*MAT_SPRING_ELASTIC
910,100.0
*EOS_LINEAR_POLYNOMIAL
911,0.0,1.0
*MAT_ADD_EROSION
912,0
*PART
nothing
913,903,909
*DEFINE_CURVE
914
0,1
1,1
*DEFINE_CURVE_SMOOTH
915,0,1.0,0.0,1.0,0.1
*DEFINE_TABLE_2D
916
0,914
*DEFINE_FUNCTION
917
f(x)=x
*DEFINE_VECTOR
918,0,0,0,1,0,0
*DEFINE_BOX
919,0,1,0,1,0,1
*DEFINE_COORDINATE_SYSTEM
920,0,0,0,1,0,0
0,1,0
*DEFINE_COORDINATE_VECTOR
921,1,0,0,0,1,0
*DEFINE_COORDINATE_NODES
922,1,2,4
*DEFINE_PLANE
923,0,0,0,1,0,0
*DEFINE_FRICTION
924,0.1
*DEFINE_SD_ORIENTATION
925,0,1,0,0
*DEFINE_TRANSFORMATION
926
TRANSL,1,0,0
*SET_NODE_LIST
927
1,2
*SET_PART_LIST
928
3
*SET_SEGMENT
929
1,2,3,4
*SET_SHELL_LIST
930
500
*SET_SOLID
931
500
*SET_BEAM
932
1
*SET_DISCRETE
933
1
*LOAD_BLAST
1.0,0,0,9,0,2,2
*INITIAL_DETONATION
3,0,0,0
*SENSOR_DEFINE_NODE
936,1,0,X,,COORD
*CONTROL_CONTACT
0
*CONTROL_HOURGLASS
4,0.05
*PARAMETER
R unused,1.0
*DATABASE_RCFORC
1e-6
*DATABASE_DEFORC
1e-6
"""

UNUSED_OF_ABAQUS = """\
*NSET, NSET=no_nodes
1, 2
*ELSET, ELSET=no_elements
*ELSET, ELSET=some
1
*SURFACE, NAME=no_surface
some, S1
*ORIENTATION, NAME=no_axes
1., 0., 0., 0., 1., 0.
*SOLID SECTION, ELSET=no_elements, MATERIAL=steel
*SHELL SECTION, ELSET=no_elements, MATERIAL=steel
0.1
*BEAM SECTION, ELSET=no_elements, MATERIAL=steel, SECTION=CIRC
0.1
*MEMBRANE SECTION, ELSET=no_elements, MATERIAL=steel
0.1
*SECTION CONTROLS, NAME=no_controls, HOURGLASS=ENHANCED
*MATERIAL, NAME=no_material
*DENSITY
7850.
*ELASTIC
2e11, 0.3
*PLASTIC
2e8, 0.
*MATERIAL, NAME=no_layer
*ELASTIC
2e11, 0.3
*SURFACE INTERACTION, NAME=no_interaction
*FRICTION
0.3
*SURFACE BEHAVIOR
*AMPLITUDE, NAME=no_amplitude
0., 0., 1., 1.
*DISTRIBUTION TABLE, NAME=no_table
LENGTH
*DISTRIBUTION, NAME=no_thickness, LOCATION=ELEMENT, TABLE=no_table
, 0.1
"""
FRAME = {"KEYWORD", "END"}
NUMBER = re.compile(r"_(TITLE|ID)$")


def list_cards(text, is_abaqus):
    """First and last line of each card, with its keyword."""
    lines = text.split("\n")
    starts = [i for i, line in enumerate(lines, 1) if line.startswith("*") and not line.startswith("**")]
    for start, after in zip(starts, [*starts[1:], len(lines) + 1]):
        keyword = lines[start - 1][1:].split(",")[0].split("\n")[0].strip().upper()
        yield start, after - 1, keyword if is_abaqus else NUMBER.sub("", keyword.split()[0])


def list_silent(text, ledger, is_abaqus=False):
    """Cards without an entry at their lines, but those of a keyword whose rows count as many cards as the deck has."""
    rows, cards = ledger.list_rows(), list(list_cards(text, is_abaqus))
    lines = {entry.first.line for entry in rows}
    told = Counter[str]()
    for entry in rows:
        told[re.split(r"[.,]", entry.card)[0]] += entry.count
    given = Counter(keyword for *_, keyword in cards)
    return [f"{start}: {keyword}" for start, last, keyword in cards
            if keyword not in FRAME and not lines & set(range(start, last + 1)) and told[keyword] < given[keyword]]  # fmt: skip


def list_invented(text, ledger, is_abaqus=False):
    """Entries of cards that the deck does not have, and which are not named as a default."""
    heads = {keyword.split(" " if is_abaqus else "_")[0] for _, _, keyword in list_cards(text, is_abaqus)}
    return [entry.card for entry in ledger.list_rows()
            if re.split(r"[._, ]", entry.card)[0] not in heads and not entry.card.endswith("(none)")]  # fmt: skip


class Report(import_test.InFolder):
    def told(self, ledger, card):
        return [(entry.status, entry.text, entry.first.line) for entry in ledger.list_rows() if entry.card == card]

    def test_every_card_that_nothing_uses_is_in_the_report(self):
        text = decks.FULL.replace("*END", UNUSED + "*END")
        _, ledger = self.read(text, "all")
        self.assertEqual(list_silent(text, ledger), [])
        for card in ("HOURGLASS", "SECTION_SHELL", "SECTION_TSHELL", "SECTION_BEAM", "SECTION_DISCRETE"):
            found = [told for told in self.told(ledger, card) if told[1] == "no part uses it"]
            self.assertEqual([status for status, _, _ in found], [Status.IGNORED], card)
        self.assertEqual(self.told(ledger, "INTEGRATION_BEAM")[0][1], "no section of beams uses it")
        solid = [told for told in self.told(ledger, "SECTION_SOLID") if told[0] is Status.IGNORED]
        self.assertEqual([words for _, words, _ in solid], ["no element is of the parts that use it", "no part uses it"])

    def test_every_keyword_of_abaqus_that_nothing_uses_is_in_the_report(self):
        text = decks.ABAQUS_RIGID.replace("*MATERIAL", UNUSED_OF_ABAQUS + "*MATERIAL", 1)
        _, ledger = self.read_abaqus(text, "all")
        self.assertEqual(list_silent(text, ledger, True), [])
        self.assertEqual(self.told(ledger, "SURFACE INTERACTION")[0][:2], (Status.IGNORED, "no contact names it"))
        self.assertIn((Status.IGNORED, "no section with elements uses it"), [told[:2] for told in self.told(ledger, "MATERIAL")])
        self.assertEqual(self.told(ledger, "SECTION CONTROLS")[0][:2], (Status.IGNORED, "no section names it"))
        for kind in ("SHELL", "BEAM", "MEMBRANE"):
            self.assertEqual(self.told(ledger, f"{kind} SECTION")[0][:2], (Status.IGNORED, "its element set has no element"), kind)

    def test_cards_of_all_decks_are_in_the_report_and_no_others(self):
        for name in ("FULL", "SMALL", "STRESSED", "BOLTS", "ROUND_WALLS", "TEN_NODES", "RIGID", "TWO_PARTS", "JOINTED", "SPRINGS", "BEAMS"):
            text = getattr(decks, name)
            _, ledger = self.read(text, "all")
            self.assertEqual((list_silent(text, ledger), list_invented(text, ledger)), ([], []), name)
            self.assertNotIn(ELSEWHERE, [entry.text for entry in ledger.list_rows()], name)
        for name in ("ABAQUS", "ABAQUS_STRESSED", "ABAQUS_BODIES", "ABAQUS_ROLLER", "ABAQUS_BEAMS", "ABAQUS_RIGID", "ABAQUS_RATES"):
            text = getattr(decks, name)
            _, ledger = self.read_abaqus(text, "all")
            self.assertEqual((list_silent(text, ledger, True), list_invented(text, ledger, True)), ([], []), name)
            self.assertNotIn(ELSEWHERE, [entry.text for entry in ledger.list_rows()], name)

    def test_defaults_of_absent_cards_are_named_as_such(self):
        _, ledger = self.read(decks.FULL)
        self.assertEqual(self.told(ledger, "CONTROL_CONTACT.ENMASS"), [])
        self.assertIn("the default", self.told(ledger, "CONTROL_CONTACT (none)")[0][1])
        text = decks.FULL.replace("*END", "*CONTROL_CONTACT\n0.1\n*END")
        _, ledger = self.read(text)
        line = text.split("\n").index("*CONTROL_CONTACT") + 2
        self.assertEqual([place for _, _, place in self.told(ledger, "CONTROL_CONTACT.ENMASS")], [line])
        unused = decks.SMALL.replace("*END", "*HOURGLASS\n9,4\n*END")
        _, ledger = self.read(unused)
        self.assertEqual(self.told(ledger, "HOURGLASS")[0][1], "no part uses it")
        self.assertEqual(len(self.told(ledger, "HOURGLASS (none)")), 1)

    def test_forces_of_contact_need_two_sides(self):
        single = decks.SMALL.replace("*END", "*CONTACT_AUTOMATIC_SINGLE_SURFACE\n0,0,5,0\n\n\n*DATABASE_RCFORC\n1e-6\n*DATABASE_RWFORC\n1e-6\n*END")
        model, ledger = self.read(single)
        self.assertNotIn("forces", model.deck["output"]["history"])
        self.assertRegex(self.told(ledger, "DATABASE_RCFORC")[0][1], "a surface with itself.* has no two sides")
        self.assertIn("no rigid wall", self.told(ledger, "DATABASE_RWFORC")[0][1])
        model, ledger = self.read(decks.FULL.replace("*END", "*DATABASE_RCFORC\n1e-6\n*END"))
        self.assertIn(Status.TRANSLATED, [status for status, _, _ in self.told(ledger, "DATABASE_RCFORC")])
        self.assertTrue(any("contact" in force for force in model.deck["output"]["history"]["forces"]))


class Sizes(import_test.InFolder):
    """A size that must be positive: the message has its line, its name and its value."""

    def test_of_shells(self):
        line = decks.FULL.split("\n").index("       0.1       0.1       0.1       0.1       1.0") + 1
        for old, new, words in (("       0.1       0.1       0.1       0.1       1.0", "      -1.2       0.1       0.1       0.1       1.0", "T1 of *SECTION_SHELL is '-1.2' (must be positive)"),
                                ("       0.1       0.1       0.1       0.1       1.0", "       0.1       0.1      -0.2       0.1       1.0", "T3 of *SECTION_SHELL is '-0.2' (must be positive)"),
                                ("       0.1       0.1       0.1       0.1       1.0", "       0.0       0.0       0.0       0.0       1.0", "T1 is 0 or blank")):  # fmt: skip
            self.fails(decks.FULL.replace(old, new), f"deck.k:{line}:", words)

    def test_of_beams(self):
        for lines, words in (("1,1.0,2.0,1\n-0.1,0.1", "TS1 of *SECTION_BEAM is '-0.1' (must be positive)"), ("1,1.0,2.0,0\n0.1,0.1,-0.2", "TT1 of *SECTION_BEAM is '-0.2' (must be positive)"),
                             ("1,1.0,2.0,1\n0.1,0.1,0.3", "TT1 of *SECTION_BEAM is '0.3' (it must be below TS1"), ("2\n-1e-3,1e-7,1e-7", "A of *SECTION_BEAM is '-1e-3' (must be positive)"),
                             ("2\n1e-3,1e-7,-1e-7", "ITT of *SECTION_BEAM is '-1e-7' (must be positive)"), ("3\n-1e-4", "A of *SECTION_BEAM is '-1e-4' (must be positive)")):  # fmt: skip
            start, _, rest = decks.BEAMS.partition("*SECTION_BEAM")
            first = next(i for i, line in enumerate(rest.split("\n")) if re.match(r"\s+21\s", line))
            lines_of = rest.split("\n")
            text = start + "*SECTION_BEAM" + "\n".join([*lines_of[:first], *f"21,{lines}".split("\n"), *lines_of[first + 2 :]])
            self.fails(text, words, f"deck.k:{text.split(chr(10)).index(lines.split(chr(10))[1]) + 1}:")

    def test_of_abaqus(self):
        for old, new, words in (("0.02, 0.04", "0.02, -0.04", "number 2 of the dimensions of this beam section is -0.04 (it must be positive)"),
                                ("1e-4", "-1e-4", "the area of this truss is -0.0001 (it must be positive)")):
            self.assertIn(old, decks.ABAQUS_BEAMS)
            with self.assertRaises(import_test.BadInput) as caught:
                self.read_abaqus(decks.ABAQUS_BEAMS.replace(old, new))
            self.assertIn(words, str(caught.exception))


if __name__ == "__main__":
    unittest.main()
