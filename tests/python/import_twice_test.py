"""percuss import, what a deck says twice, misspells or turns round: import_twice_test.py ROOT PERCUSS."""

import os
import re

import import_decks as decks
import import_test
from import_unused_test import UNUSED, list_cards
from percuss.importing.dyna.database_names import KEYWORDS
from percuss.importing.ledger import BadInput, Status
from percuss.importing.text_files import find_similar

LAST = "of several of these cards the last one counts, which is at deck.k:{}"
# Cards of UNUSED that a deck may have twice: they have no id, or percuss keeps nothing of them.
REPEATABLE = {
    "INITIAL_DETONATION": "several points", "PARAMETER": "the same value", "SENSOR_DEFINE_NODE": "not kept", "SET_DISCRETE": "not kept",
    "DEFINE_PLANE": "not kept", "DEFINE_FRICTION": "not kept", "DEFINE_SD_ORIENTATION": "not kept", "CONTROL_CONTACT": "the last one", "CONTROL_HOURGLASS": "the last one",
    "DATABASE_RCFORC": "the last one", "DATABASE_DEFORC": "the last one",
}  # fmt: skip
ABAQUS_NAMES = """\
*SURFACE, NAME=a
1, S1
*SURFACE, TYPE=NODE, NAME=b
1
*ORIENTATION, NAME=a
1., 0., 0., 0., 1., 0.
*SECTION CONTROLS, NAME=a, HOURGLASS=ENHANCED
*MATERIAL, NAME=a
*SURFACE INTERACTION, NAME=a
*AMPLITUDE, NAME=a
0., 0., 1., 1.
*DISTRIBUTION, NAME=a, LOCATION=ELEMENT, TABLE=t
, 0.1
*PARAMETER TABLE TYPE, NAME=a, PARAMETERS=1
FLOAT
*TABLE COLLECTION, NAME=a
"""
# A plate of thickness 2 whose mesh is at z = 0, and a cube that begins 1.6 above it.
OFFSET = """\
*HEADING
plate and cube
*NODE
1, 0., 0., 0.
2, 20., 0., 0.
3, 20., 20., 0.
4, 0., 20., 0.
11, 5., 5., 1.6
12, 15., 5., 1.6
13, 15., 15., 1.6
14, 5., 15., 1.6
15, 5., 5., 11.6
16, 15., 5., 11.6
17, 15., 15., 11.6
18, 5., 15., 11.6
*ELEMENT, TYPE=S4R, ELSET=plate
1, 1, 2, 3, 4
*ELEMENT, TYPE=C3D8R, ELSET=cube
2, 11, 12, 13, 14, 15, 16, 17, 18
*SURFACE, NAME=below
cube, S1
*SURFACE, NAME=on_plate
plate, SPOS
*SHELL SECTION, ELSET=plate, MATERIAL=steel{offset}
2., 5
*SOLID SECTION, ELSET=cube, MATERIAL=steel
,
*MATERIAL, NAME=steel
*DENSITY
7.85E-9,
*ELASTIC
210000., 0.3
*SURFACE INTERACTION, NAME=smooth
*BOUNDARY
1, 1, 6
*STEP
*DYNAMIC, EXPLICIT
, 1.E-4
{contact}*CLOAD
15, 3, -1.
*OUTPUT, HISTORY, TIME INTERVAL=1E-5
*END STEP
"""
EVERYTHING = "*CONTACT\n*CONTACT INCLUSIONS, ALL EXTERIOR\n"


def line_of(text, words, count=1):
    """The number of the line that has these words for the count-th time."""
    return [number for number, line in enumerate(text.split("\n"), 1) if words in line][count - 1]


def rows_of(ledger, card):
    return [(entry.status, entry.text, entry.first.line) for entry in ledger.list_rows() if entry.card == card]


class Twice(import_test.InFolder):
    def find_error(self, text, read):
        try:
            read(text, "all")
        except BadInput as error:
            return str(error)
        return ""

    def test_no_definition_with_an_id_is_given_twice(self):
        """Each card of UNUSED behind itself: an error at the second one, which names the line of the first."""
        base = decks.FULL.replace("*END", UNUSED + "*END")
        before, end = line_of(base, UNUSED.split("\n")[0], base.count(UNUSED.split("\n")[0] + "\n")) - 1, line_of(base, "*END")
        self.assertTrue("\n".join(base.split("\n")[before:]).startswith(UNUSED))
        tried = 0
        for start, last, keyword in list_cards(UNUSED, False):
            body = "\n".join(UNUSED.split("\n")[start - 1 : last]).rstrip("\n")
            error = self.find_error(base.replace("*END", body + "\n*END"), self.read)
            with self.subTest(keyword=keyword):
                if keyword in REPEATABLE:
                    self.assertEqual(error, "")
                    continue
                self.assertRegex(error, r"error: there are two .* \(ids must be unique; the first is at .*\): renumber or remove one")
                second, first = (int(number) for number in re.findall(r"deck\.k:(\d+)", error))
                self.assertIn(first, range(before + start, before + last + 1))
                self.assertIn(second, range(end, end + last - start + 1))
                tried += 1
        self.assertGreater(tried, 25)

    def test_ids_are_of_all_cards_of_a_kind(self):
        for first, second, what in (
            ("*SECTION_SHELL\n77,2\n1.0\n", "*SECTION_SOLID\n77,1\n", "sections 77"), ("*DEFINE_CURVE\n77\n0,1\n1,1\n", "*DEFINE_TABLE_2D\n77\n0,9\n", "curves or tables 77"),
            ("*DEFINE_TABLE\n77\n0\n*DEFINE_CURVE\n78\n0,1\n1,1\n", "*DEFINE_CURVE_SMOOTH\n77,0,1.0,0.0,1.0,0.1\n", "curves or tables 77"),
            ("*DEFINE_CURVE\n77\n0,1\n1,1\n", "*DEFINE_FUNCTION\n77\nf(t)=t\n", "curves or tables 77"), ("*DEFINE_COORDINATE_NODES\n77,1,2,4\n", "*DEFINE_COORDINATE_VECTOR\n77,1,0,0,0,1,0\n", "*DEFINE_COORDINATE 77"),
            ("*DEFINE_BOX\n77,0,1,0,1,0,1\n", "*DEFINE_BOX_LOCAL\n77,0,1,0,1,0,1\n1,0,0,0,1,0\n0,0,0\n", "*DEFINE_BOX 77"), ("*HOURGLASS\n77,4\n", "*HOURGLASS\n77,5\n", "*HOURGLASS 77"),
            ("*MAT_ADD_EROSION\n3\n0.1\n", "*MAT_ADD_EROSION\n3\n0.2\n", "*MAT_ADD_EROSION of material 3"), ("*EOS_JWL\n77,1.0\n", "*EOS_LINEAR_POLYNOMIAL\n77,0,1\n", "equations of state 77"),
            ("*LOAD_BLAST_ENHANCED\n77,1,0,0,9,0,2,2\n", "*LOAD_BLAST_ENHANCED\n77,2,0,0,9,0,2,2\n", "*LOAD_BLAST_ENHANCED 77"),
            ("*DATABASE_CROSS_SECTION_PLANE_ID\n77,a\n0,0,0,0,0,0,1\n", "*DATABASE_CROSS_SECTION_PLANE_ID\n77,b\n0,0,0,0,1,0,0\n", "*DATABASE_CROSS_SECTION 77"),
            ("*CONSTRAINED_NODAL_RIGID_BODY\n77,0,60\n", "*CONSTRAINED_NODAL_RIGID_BODY\n77,0,61\n", "*CONSTRAINED_NODAL_RIGID_BODY 77"),
            ("", "*ELEMENT_SHELL\n500,8,21,22,23,24\n", "shells 500"), ("", "*ELEMENT_SOLID\n500,3,1,2,3,4,11,12,13,14\n", "solids 500"),
        ):  # fmt: skip
            with self.subTest(what=what, second=second):
                self.fails(decks.FULL.replace("*END", first + second + "*END"), f"there are two {what} (ids must be unique; the first is at ")

    def test_damping_of_all_nodes_is_given_once(self):
        text = decks.FULL.replace("*END", "*DAMPING_GLOBAL\n0,100.0\n*DAMPING_GLOBAL\n0,300.0\n*END")
        self.fails(text, f"deck.k:{line_of(text, '0,300')}: error: there are two *DAMPING_GLOBAL (one can hold; the first is at ", f"deck.k:{line_of(text, '0,100')})")

    def test_an_included_file_replaces_nothing(self):
        """IDROFF 0: its section 3 would take the place of that of the main file."""
        moved = decks.SMALL.replace("*KEYWORD", "*KEYWORD\n*INCLUDE_TRANSFORM\npart.k\n1000,1000,1000,1000,1000,1000,1000\n\n\n\n", 1)
        self.write(decks.BLOCK.split("*NODE", 1)[0] + "*NODE" + decks.BLOCK.split("*NODE", 1)[1], "part.k")
        error = self.find_error(moved, self.read)
        self.assertRegex(error, r"two sections 3 \(ids must be unique; the first is at .*part\.k:")

    def test_a_plane_without_an_id_takes_none_of_another(self):
        planes = "*DATABASE_CROSS_SECTION_PLANE\n0,0,0,0.5,0,0,1\n*DATABASE_CROSS_SECTION_PLANE_ID\n1,across\n0,0.5,0,0,1,0,0\n"
        model, _ = self.read(decks.SMALL.replace("*END", planes + "*END"))
        normals = [force["section"]["normal"] for force in model.deck["output"]["history"]["forces"]]
        self.assertEqual([[abs(c) for c in normal] for normal in normals], [[0, 0, 1], [1, 0, 0]])

    def test_a_node_at_two_places_has_both_lines(self):
        text = decks.FULL.replace("*END", "*NODE\n2,1.5,0.0,0.0\n*END")
        self.fails(text, f"deck.k:{line_of(text, '2,1.5')}: error: node 2 is defined twice", f"deck.k:{line_of(text, '       2   ')})")

    def test_of_several_controls_the_last_one_counts(self):
        """All of it: what the last one does not say is its default."""
        text = decks.FULL.replace("*END", "*CONTROL_TERMINATION\n3e-4,0\n*CONTROL_TERMINATION\n2e-4\n*CONTROL_TIMESTEP\n0,0.5\n*DATABASE_BINARY_D3PLOT\n1e-5\n*DATABASE_BINARY_D3PLOT\n2e-5\n*END")
        text = text.replace("1.0E-04         0      0.01", "1.0E-04         7      0.01")
        model, ledger = self.read(text)
        self.assertEqual({key: model.deck["time"].get(key) for key in ("end", "max_steps", "collapse_ratio", "step_scale")}, {"end": 2e-4, "max_steps": None, "collapse_ratio": None, "step_scale": 0.5})
        self.assertEqual(model.deck["output"]["fields"]["every"], 2e-5)
        for card, count in (("CONTROL_TERMINATION", 3), ("CONTROL_TIMESTEP", 2), ("DATABASE_BINARY_D3PLOT", 3)):
            told = [row for row in rows_of(ledger, card) if row[0] is Status.IGNORED]
            self.assertEqual(len(told), count - 1, card)
            self.assertIn(f"deck.k:{line_of(text, '*' + card, 2)}", told[0][1])
            self.assertEqual(told[0][2], line_of(text, "*" + card, 1))

    def test_a_blast_knows_the_end_of_the_run_wherever_it_stands(self):
        blast = "*LOAD_BLAST_ENHANCED\n9,1.0,0,0,9,0,2,2\n0,0,0,0,0,1e-5\n"
        for text in (decks.SMALL.replace("*CONTROL_TERMINATION", blast + "*CONTROL_TERMINATION", 1), decks.SMALL.replace("*END", blast + "*END")):
            self.assertIn("LOAD_BLAST_ENHANCED.DEATH", self.refusals(text))

    def test_a_card_has_the_values_that_stand_before_it(self):
        """Whenever it is read: loads and controls wait for all definitions."""
        load = "*LOAD_NODE_POINT\n11,3,95,&v\n"
        text = decks.SMALL.replace("*END", "*DEFINE_CURVE\n95\n0,1\n1,1\n*PARAMETER_MUTABLE\nR v,2.0\n" + load + "*PARAMETER_MUTABLE\nR v,3.0\n" + load.replace("11", "12") + "*PARAMETER_MUTABLE\nR v,4.0\n*END")
        model, _ = self.read(text)
        self.assertEqual([entry["force"]["z"] for entry in model.deck["loads"]["nodal"]], [2.0, 3.0])
        self.fails(text.replace("*PARAMETER_MUTABLE\nR v,3.0", "*PARAMETER_EXPRESSION\nR v,1.5*2"), "parameter V has a value already")
        self.fails(decks.SMALL.replace("*END", "*LOAD_NODE_POINT\n11,3,95,&w\n*PARAMETER\nR w,1.0\n*END"), "parameter &w")

    def test_a_rigid_part_follows_one_other(self):
        text = decks.RIGID.replace("*END", "*CONSTRAINED_RIGID_BODIES\n1,3\n2,3\n*END")
        self.fails(text, "part 3 is merged with part 2 and with part 1")

    def test_abscissae_ascend_as_they_count(self):
        text = decks.SMALL.replace("*END", "*LOAD_NODE_POINT\n11,3,95,1.0\n*DEFINE_CURVE\n95,0,{sfa},1.0\n{rows}*END")
        self.fails(text.format(sfa="-1.0", rows="0,0\n1,1\n"), f"deck.k:{line_of(text.format(sfa='-1.0', rows=chr(48) + ',0' + chr(10) + '1,1' + chr(10)), '1,1', 1)}", "must ascend after SFA, which is -1")
        self.fails(text.format(sfa="1.0", rows="0,0\n-1,1\n"), "must ascend: -1 follows 0")
        model, _ = self.read(text.format(sfa="-1.0", rows="0,0\n-1,1\n"))
        self.assertEqual(model.deck["loads"]["nodal"][0]["force"]["z"]["table"][-1], [1e-4, 1e-4])
        self.fails(decks.SMALL.replace("*END", "*DEFINE_TABLE_2D\n96,-1.0\n0,95\n1,95\n*END"), "VALUE of *DEFINE_TABLE_2D is '1'", "must ascend after SFA")


class Misspelt(import_test.InFolder):
    def test_every_database_card_is_known_and_no_other(self):
        """Two letters change places: such a card is refused, with the real one as the remedy."""
        wrong = []
        for keyword in sorted(KEYWORDS):
            letters = list(keyword)
            letters[-1], letters[-2] = letters[-2], letters[-1]
            swapped = "".join(letters)
            if swapped in KEYWORDS or letters[-1] == letters[-2] or "CROSS_SECTION" in keyword:
                continue
            text = decks.SMALL.replace("*END", f"*{keyword}\n\n*{swapped}\n1e-6\n*END")
            refused = self.refusals(text)
            if set(refused) != {swapped} or "an unknown card" not in refused[swapped] or (find_similar(swapped, [keyword]) and "did you mean *DATABASE_" not in refused[swapped]):
                wrong.append((keyword, refused))
        self.assertEqual(wrong, [])
        for word, meant in (("BINARY_D3PLT", "BINARY_D3PLOT"), ("HISTORY_NODES", "HISTORY_NODE"), ("CROSS_SECTION_PLAN", "CROSS_SECTION_PLANE"), ("RWFROC", "RWFORC")):
            refused = self.refusals(decks.SMALL.replace("*END", f"*DATABASE_{word}\n1e-6\n*END"))
            self.assertIn(f"did you mean *DATABASE_{meant}?", refused[f"DATABASE_{word}"])
        self.assertIn("DATABASE_FOO", self.refusals(decks.SMALL.replace("*END", "*DATABASE_FOO\n1e-6\n*END")))

    def test_options_of_abaqus_output_are_known_and_no_others(self):
        for line, card, meant in (("*OUTPUT, HISTRY", "OUTPUT.HISTRY", "HISTORY"), ("*OUTPUT, FIELD, TIM INTERVAL=1e-5", "OUTPUT.TIM INTERVAL", "TIME INTERVAL"),
                                  ("*OUTPUT, HISTORY\n*NODE OUTPUT, NSETS=all\nU", "NODE OUTPUT.NSETS", "NSET"), ("*OUTPUT, HISTORY\n*ELEMENT OUTPUT, ELST=all\nS", "ELEMENT OUTPUT.ELST", "ELSET"),
                                  ("*OUTPUT, HISTORY\n*CONTACT OUTPUT, SURFCE=s\nCFN", "CONTACT OUTPUT.SURFCE", "SURFACE")):  # fmt: skip
            _, ledger = self.read_abaqus(decks.ABAQUS_RIGID.replace("*END STEP", f"{line}\n*END STEP"))
            refused = {entry.card: entry.text for entry in ledger.list_refused()}
            self.assertIn(f"did you mean {meant}?", refused.get(card, ""), line)
        known = "*OUTPUT, HISTORY, FREQUENCY=5, NAME=a, OP=NEW, VARIABLE=PRESELECT\n*OUTPUT, FIELD, TIME MARKS=YES, NUMBER INTERVAL=3\n*NODE OUTPUT, EXTERIOR\nU\n"
        _, ledger = self.read_abaqus(decks.ABAQUS_RIGID.replace("*END STEP", f"{known}*END STEP"))
        self.assertEqual(ledger.list_refused(), [])


class AbaqusTwice(import_test.InFolder):
    def find_error(self, text):
        try:
            self.read_abaqus(text, "all")
        except BadInput as error:
            return str(error)
        return ""

    def test_no_name_is_given_twice(self):
        base = decks.ABAQUS_RIGID.replace("*MATERIAL", ABAQUS_NAMES + "*MATERIAL", 1)
        self.assertEqual(self.find_error(base), "")
        for start, last, keyword in list_cards(ABAQUS_NAMES, True):
            body = "\n".join(ABAQUS_NAMES.split("\n")[start - 1 : last])
            text = base.replace("*SURFACE INTERACTION", f"{body}\n*SURFACE INTERACTION", 1) if keyword == "SURFACE INTERACTION" else base.replace(ABAQUS_NAMES, f"{ABAQUS_NAMES}{body}\n")
            first, second = (line_of(text, body.split("\n")[0], count) for count in (1, 2))
            with self.subTest(keyword=keyword):
                self.assertRegex(self.find_error(text), rf"deck\.inp:{second}: error: there are two .* '[AB]' \(names must be unique; the first is at .*deck\.inp:{first}\): rename or remove one")

    def test_kinds_of_surfaces_share_their_names_and_parts_have_their_own(self):
        text = decks.ABAQUS_RIGID.replace("*MATERIAL", ABAQUS_NAMES + "*SURFACE, NAME=b\n1, S1\n*MATERIAL", 1)
        self.assertIn("there are two surfaces 'B'", self.find_error(text))
        part = "*PART, NAME={0}\n*NODE\n1, 0., 0., 0.\n2, 1., 0., 0.\n3, 1., 1., 0.\n4, 0., 1., 0.\n*ELEMENT, TYPE=S4R, ELSET=e\n1, 1, 2, 3, 4\n*SURFACE, NAME=s\ne, SPOS\n*SHELL SECTION, ELSET=e, MATERIAL=m\n0.1\n*END PART\n"
        rest = "*ASSEMBLY, NAME=a\n*INSTANCE, NAME=i, PART=p\n*END INSTANCE\n*INSTANCE, NAME=j, PART=q\n0., 0., 5.\n*END INSTANCE\n*END ASSEMBLY\n*MATERIAL, NAME=m\n*DENSITY\n7800.\n*ELASTIC\n2e11, 0.3\n*STEP\n*DYNAMIC, EXPLICIT\n, 1e-5\n*END STEP\n"
        head = "*HEADING\ntwo parts\n"
        self.assertEqual(self.find_error(head + part.format("p") + part.format("q") + rest), "")
        self.assertIn("there are two parts 'P'", self.find_error(head + part.format("p") + part.format("p") + rest))
        self.assertIn("there are two instances 'I'", self.find_error(head + part.format("p") + part.format("q") + rest.replace("NAME=j", "NAME=i")))

    def test_nodes_and_elements_are_given_once(self):
        """Sets go on where they are given again, as in Abaqus; so may a node at the same place."""
        base = OFFSET.format(offset="", contact="")
        twice = base.replace("*SHELL SECTION", "*NODE\n2, 20., 0., 3.\n*SHELL SECTION", 1)
        self.assertRegex(self.find_error(twice), rf"deck\.inp:{line_of(twice, '2, 20., 0., 3.')}: error: node 2 is defined twice, and differs \(the first is at .*deck\.inp:{line_of(twice, '2, 20., 0., 0.')}\)")
        twice = base.replace("*SHELL SECTION", "*ELEMENT, TYPE=S4R, ELSET=plate\n1, 1, 2, 3, 13\n*SHELL SECTION", 1)
        self.assertRegex(self.find_error(twice), rf"element 1 is defined twice, and differs \(the first is at .*deck\.inp:{line_of(twice, '1, 1, 2, 3, 4')}\)")
        same = base.replace("*SHELL SECTION", "*NODE\n2, 20., 0., 0.\n*NSET, NSET=n\n1\n*NSET, NSET=n\n2\n*SHELL SECTION", 1)
        model, _ = self.read_abaqus(same.replace("*CLOAD\n15", "*CLOAD\nn"))
        self.assertEqual(model.node_sets["N"] if "N" in model.node_sets else model.node_sets["n"], [1, 2])

    def test_a_node_that_a_line_gives_is_not_moved_by_rule(self):
        """Nodes 1 and 3 are 2 apart: the one between them may be given at 1 before, or at 1.5 afterwards, but not before."""
        deck = OFFSET.format(offset="", contact="")
        ends, middle, rule = "*NODE\n201, 0., 0., 9.\n203, 2., 0., 9.\n", "*NODE\n202, {}, 0., 9.\n", "*NGEN\n201, 203, 1\n"
        for before, after in ((middle.format("1.0000001"), ""), ("", middle.format("1.5"))):
            self.assertEqual(self.find_error(deck.replace("*SHELL SECTION", ends + before + rule + after + "*SHELL SECTION", 1)), "")
        text = deck.replace("*SHELL SECTION", ends + middle.format("1.5") + rule + "*SHELL SECTION", 1)
        self.assertRegex(self.find_error(text), rf"\*NGEN makes node 202 at another place \(the first is at .*deck\.inp:{line_of(text, '202, 1.5')}\)")

    def test_a_load_that_another_replaces_is_reported_as_such(self):
        """No row says that what becomes of it stands elsewhere."""
        text = OFFSET.format(offset="", contact="").replace("*OUTPUT", "*CLOAD, OP=NEW\n15, 1, 2.\n*OUTPUT", 1)
        model, ledger = self.read_abaqus(text)
        self.assertEqual([load["force"] for load in model.deck["loads"]["nodal"]], [{"x": 2.0}])
        self.assertIn((Status.IGNORED, "another one takes its place before it acts", line_of(text, "15, 3, -1.")), rows_of(ledger, "CLOAD"))
        later = OFFSET.format(offset="", contact="") + "*STEP\n*DYNAMIC, EXPLICIT\n, 1.E-4\n*CLOAD\n15, 3, -2.\n*END STEP\n"
        _, ledger = self.read_abaqus(later)
        told = [status for status, _, line in rows_of(ledger, "CLOAD") if line == line_of(later, "15, 3, -2.")]
        self.assertEqual(told, [Status.TRANSLATED])


class Offsets(import_test.InFolder):
    def find_row(self, offset, contact):
        _, ledger = self.read_abaqus(OFFSET.format(offset=offset, contact=contact))
        self.assertEqual(ledger.list_refused(), [])
        rows = rows_of(ledger, "SHELL SECTION.OFFSET")
        self.assertTrue(all(status is Status.APPROXIMATED for status, _, _ in rows))
        return [text for _, text, _ in rows]

    def test_contact_of_shells_with_an_offset_has_its_place_and_size_in_the_report(self):
        """The nodes lie on the top of SPOS: the middle surface of Abaqus is half the thickness of 2 below them."""
        pair = "*CONTACT PAIR, INTERACTION=smooth\nbelow, on_plate\n"
        for offset, height, way in ((", OFFSET=SPOS", "1", "against"), (", OFFSET=SNEG", "1", "along"), (", OFFSET=0.25", "0.5", "against")):
            for contact in (EVERYTHING, pair, "*CONTACT\n*CONTACT INCLUSIONS\nbelow, on_plate\n"):
                rows = self.find_row(offset, contact)
                self.assertEqual(rows, [f"contact: both sides lie at half the thickness, 1, from the mesh; in Abaqus they lie {height} further {way} the normal"])
        for contact in (EVERYTHING + "*SURFACE PROPERTY ASSIGNMENT, PROPERTY=OFFSET FRACTION\n, 0.\n", "", "*CONTACT\n*CONTACT INCLUSIONS\nbelow, \n".replace("below, ", "below, below")):
            self.assertEqual(self.find_row(", OFFSET=SPOS", contact), [])
        self.assertEqual(self.find_row("", EVERYTHING), [])
        self.assertEqual(self.find_row(", OFFSET=SPOS", pair + EVERYTHING + "*SURFACE PROPERTY ASSIGNMENT, PROPERTY=OFFSET FRACTION\n, 0.\n"), rows[:0] + self.find_row(", OFFSET=SPOS", pair))

    def test_the_gap_of_percuss_is_the_one_that_the_report_says(self):
        """1.6 to the mesh, of which half the thickness is 1; Abaqus has a gap of 1.6, as its plate lies below the mesh."""
        path = self.write(OFFSET.format(offset=", OFFSET=SPOS", contact=EVERYTHING), "deck.inp")
        done = self.percuss("import", path, "--out", "out")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertRegex(done.stdout, r"smallest gaps: 0\.6 between")
        with open(os.path.join(self.folder, "out/import_report.md"), encoding="utf-8") as file:
            self.assertTrue(re.search(r"`\*SHELL SECTION\.OFFSET` \| contact: both sides lie .* deck\.inp:\d+", file.read()))

    def test_contact_at_the_offset_of_lsdyna_is_refused_and_that_at_the_mesh_is_not(self):
        """CNTCO 0, the default, ignores NLOC as percuss does."""
        plate = decks.FULL.replace("*END", "*CONTROL_SHELL\n\n\n0,0,{}\n*END")
        self.assertNotIn("CONTROL_SHELL.CNTCO", self.refusals(plate.format(0)))
        self.assertIn("lies 0.5 of their thickness off the mesh", self.refusals(plate.format(1))["CONTROL_SHELL.CNTCO"])


if __name__ == "__main__":
    import unittest

    unittest.main()
