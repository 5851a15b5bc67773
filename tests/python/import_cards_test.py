"""percuss import, cards that public models use: import_cards_test.py ROOT PERCUSS."""

import unittest

import import_decks as decks
import import_test
from percuss.importing.curves import differentiate
from percuss.importing.dyna.read import read_keyword_deck
from percuss.importing.ledger import Ledger, Status
from percuss.importing.rates import fit_cowper_symonds, scale_stress, thin_curves

InFolder = import_test.InFolder
TABLE = "*MAT_024\n1,7850.0,2.0e11,0.3,1.0,1.0,1e21\n0,0,50\n0\n0\n"
CURVES = "*DEFINE_CURVE\n51\n0,2e8\n0.5,3e8\n*DEFINE_CURVE\n52\n0,4e8\n0.5,6e8\n*DEFINE_CURVE\n53\n0,6e8\n0.5,9e8\n"


def outcomes(ledger, status):
    return {entry.card for entry in ledger.list_rows() if entry.status is status}


class Rates(InFolder):
    def test_the_fit_gives_back_the_law_that_made_the_factors(self):
        law = (40.0, 5.0)
        found = fit_cowper_symonds([(rate, scale_stress(law, rate)) for rate in (1.0, 40.0, 1000.0)])
        self.assertAlmostEqual(found[0], 40.0)
        self.assertAlmostEqual(found[1], 5.0)
        self.assertEqual(scale_stress(law, 40.0), 2.0)
        self.assertIsNone(fit_cowper_symonds([(1.0, 1.0), (2.0, 0.9)]))

    def read_law(self, text, read=None):
        model, ledger = (read or self.read)(text)
        self.assertEqual(ledger.list_refused(), [])
        return next(iter(model.materials.values()))

    def test_a_table_of_rates_stays_a_table(self):
        for table in ("*DEFINE_TABLE_2D\n50\n0,51\n10,52\n20,53\n" + CURVES, "*DEFINE_TABLE\n50\n0\n10\n20\n" + CURVES):
            law = self.read_law(decks.make_block(TABLE + table, "", True))
            self.assertEqual(law["model"], "rate_table_plasticity")
            self.assertNotIn("rate_interpolation", law)
            self.assertEqual([rate for rate, _ in law["hardening_at_rates"]], [0.0, 10.0, 20.0])
            # rows, then the last slope on to a plastic strain of 1.5
            self.assertEqual(law["hardening_at_rates"][1][1], [[0.0, 4e8], [0.5, 6e8], [1.5, 1e9]])

    def test_rates_whose_first_is_negative_are_logarithms(self):
        law = self.read_law(decks.make_block(TABLE + "*DEFINE_TABLE_2D\n50\n-2.302585093,51\n0,52\n2.302585093,53\n" + CURVES, "", True))
        self.assertEqual(law["rate_interpolation"], "logarithmic")
        for (rate, _), expected in zip(law["hardening_at_rates"], (0.1, 1.0, 10.0)):
            self.assertAlmostEqual(rate, expected, 8)

    def test_log_interpolation_needs_rates_above_0(self):
        table = TABLE.replace("*MAT_024", "*MAT_PIECEWISE_LINEAR_PLASTICITY_LOG_INTERPOLATION")
        law = self.read_law(decks.make_block(table + "*DEFINE_TABLE_2D\n50\n1,51\n10,52\n" + CURVES, "", True))
        self.assertEqual(law["rate_interpolation"], "logarithmic")
        self.assertIn("a rate of 0", str(self.refusals(decks.make_block(table + "*DEFINE_TABLE_2D\n50\n0,51\n10,52\n" + CURVES, "", True))))

    def test_factors_over_the_rate_scale_the_curve(self):
        for card in ("*MAT_024\n1,7850.0,2.0e11,0.3,2e8,2e10\n0,0,0,54\n0\n0\n", "*MAT_123\n1,7850.0,2.0e11,0.3,2e8,2e10\n0,0,0,54\n0\n0\n"):
            law = self.read_law(decks.make_block(card + "*DEFINE_CURVE\n54\n0,1\n100,1.5\n", "", True))
            (low, first), (high, second) = law["hardening_at_rates"]
            self.assertEqual((low, high), (0.0, 100.0))
            slope = 2e11 * 2e10 / (2e11 - 2e10)
            self.assertEqual(first, [[0.0, 2e8], [1.0, 2e8 + slope]])
            self.assertEqual(second, [[0.0, 3e8], [1.0, 1.5 * (2e8 + slope)]])

    def test_two_curves_for_a_rate_are_wrong(self):
        with self.assertRaisesRegex(Exception, "two curves are for the rate 10"):
            self.read(decks.make_block(TABLE + "*DEFINE_TABLE_2D\n50\n10,51\n10,52\n" + CURVES, "", True))

    def test_long_tables_are_thinned_and_their_error_is_told(self):
        curves = [(float(rate), [(i / 99, 1 + rate / 40 + (i / 99) ** 0.5) for i in range(100)]) for rate in range(20)]
        kept, error = thin_curves(curves, False)
        self.assertEqual(len(kept), 12)
        self.assertLessEqual(sum(len(points) for _, points in kept), 240)
        self.assertEqual((kept[0][0], kept[-1][0]), (0.0, 19.0))
        self.assertGreater(error, 1e-6)
        self.assertLess(error, 0.01)  # straight in the rate, a root in the strain
        short = [(0.0, [(0.0, 1.0)]), (1.0, curves[3][1])]
        self.assertEqual(thin_curves(short, False), (short, 0.0))  # 101 rows have room

    def test_tables_of_abaqus_stay_tables(self):
        law = self.read_law(decks.ABAQUS_RATES, self.read_abaqus)
        self.assertEqual(law["hardening_at_rates"], [[0.0, [[0.0, 2e8], [0.5, 3e8]]], [10.0, [[0.0, 4e8], [0.5, 6e8]]], [20.0, [[0.0, 6e8], [0.5, 9e8]]]])

    def test_yield_ratios_of_abaqus_scale_the_table(self):
        start = decks.ABAQUS_RATES.index("*PLASTIC, RATE=10.")
        end = decks.ABAQUS_RATES.index("*STEP")
        text = decks.ABAQUS_RATES[:start] + "*RATE DEPENDENT, TYPE=YIELD RATIO\n1., 0.\n1.5, 10.\n" + decks.ABAQUS_RATES[end:]
        law = self.read_law(text, self.read_abaqus)
        self.assertEqual(law["hardening_at_rates"], [[0.0, [[0.0, 2e8], [0.5, 3e8]]], [10.0, [[0.0, 3e8], [0.5, 4.5e8]]]])

    def test_a_fit_on_request_tells_its_error_between_and_beyond_the_rates(self):
        # factors 2 and 3 at the rates 10 and 20 fit C = 10, P = 1; at 200 the law gives 21 and the table 3
        text = decks.make_block(TABLE + "*DEFINE_TABLE_2D\n50\n0,51\n10,52\n20,53\n" + CURVES, "", True)
        with open(self.write(text)) as file:
            ledger = Ledger(fits_rates=True)
            model = read_keyword_deck(file.name, ledger)
        law = next(iter(model.materials.values()))
        self.assertAlmostEqual(law["cowper_symonds_rate"], 10.0)
        self.assertAlmostEqual(law["cowper_symonds_exponent"], 1.0)
        self.assertEqual(law["hardening"][0], [0.0, 2e8])
        told = next(entry.text for entry in ledger.list_rows() if entry.card.endswith(".table"))
        self.assertIn("6e+02 % off the table at 200", told)


class Cards(InFolder):
    def test_ties_that_break_by_stress_are_translated(self):
        sides = "3,8,3,3\n0,0,0,0,0,0\n1\n"
        for card in ("*CONTACT_TIEBREAK_SURFACE_TO_SURFACE\n" + sides + "2e7,1.5e7\n",
                     "*CONTACT_AUTOMATIC_ONE_WAY_SURFACE_TO_SURFACE_TIEBREAK\n" + sides + "2,2e7,1.5e7\n"):  # fmt: skip
            model, ledger = self.read(decks.FULL.replace("*END", card + "*END"))
            tie = model.deck["contact"]["ties"][-1]
            self.assertEqual(tie["failure"], {"normal": 2e7, "shear": 1.5e7})
            self.assertEqual(ledger.list_refused(), [])
            goes_on = any("TIEBREAK" in name for name in outcomes(ledger, Status.TRANSLATED))  # as contact
            self.assertEqual(goes_on, "AUTOMATIC" in card)
        for line, words in (("9,2e7,1.5e7", "OPTION 9 without CN"), ("2,2e7,1.5e7,0,1.0", "ERATEN is 1.0")):  # a damage law; energies of cracks
            (refusal,) = self.refusals(decks.FULL.replace("*END", card.replace("2,2e7,1.5e7", line) + "*END")).values()
            self.assertIn(words, refusal)

    def test_slopes_have_steps(self):
        rows = differentiate([(0.0, 0.0), (1.0, 2.0), (3.0, 0.0)])
        self.assertEqual([y for _, y in rows], [2.0, 2.0, -1.0, -1.0])

    def test_local_axes_along_those_of_space_are_turned(self):
        system = "*DEFINE_COORDINATE_SYSTEM\n5,0,0,0,0,1,0\n-1,0,0\n"
        cards = "*LOAD_BODY_Y\n9,4.,0,0,0,0,5\n*DEFINE_CURVE\n9\n0,1\n1,1\n" + system + "*END"
        text = decks.make_block(decks.LAWS["table"][1], "", True)
        model, ledger = self.read(text.replace("*END", cards))
        self.assertEqual(outcomes(ledger, Status.REFUSED), set())
        self.assertEqual(model.deck["loads"]["gravity"], [4.0, 0.0, 0.0])  # its y is -x of space, and bodies feel the opposite
        skew, _ = self.read(text.replace("*END", cards.replace("-1,0,0", "-1,0,1")).replace("0,0,0,0,1,0", "0,0,0,0,1,1"))
        for found, right in zip(skew.deck["loads"]["gravity"], (8, 4, -4)):  # against y = (-2, -1, 1) / sqrt(6)
            self.assertAlmostEqual(found, right / 6**0.5)

    def test_nodes_on_a_plane_are_held(self):
        text = decks.make_block(decks.LAWS["table"][1], "", True)
        model, _ = self.read(text.replace("*END", "*CONSTRAINED_GLOBAL\n3,7,1,0,0,0,0.01\n*END"))
        self.assertEqual(model.deck["conditions"][-1], {"nodes": "plane_x", "fixed": ["z", "rx", "ry", "rz"]})
        self.assertEqual({model.nodes[node][0] for node in model.node_sets["plane_x"]}, {0.0})

    def test_a_condition_without_directions_is_passed_over(self):
        text = decks.make_block(decks.LAWS["table"][1], "", True)
        _, ledger = self.read(text.replace("*END", "*BOUNDARY_SPC_SET\n0,0,0,0,0,0,0,0\n*END"))
        self.assertIn("BOUNDARY_SPC_SET.none", outcomes(ledger, Status.IGNORED))

    def test_the_first_case_acts(self):
        cases = "*CASE_BEGIN_3\n*TITLE\nthree\n*CASE_END_3\n*CASE_BEGIN_4\n*TITLE\nfour\n*CASE_END_4\n*END"
        text = decks.make_block(decks.LAWS["table"][1], "", True).replace("*END", cases)
        self.assertIn("CASE", self.refusals(text))
        model, ledger = self.read(text, "CASE")
        self.assertEqual(model.title, "three")
        self.assertIn("CASE.TITLE", outcomes(ledger, Status.IGNORED))

    def test_messages_about_cohesive_elements_and_the_implementation_of_tetrahedra_change_nothing(self):
        plain, _ = self.read(decks.FULL)
        for value in (1, 10):
            model, ledger = self.read(decks.FULL.replace("*END", f"*CONTROL_SOLID\n1,0,0,0\n0\n1,1,{value}\n*END"))
            self.assertEqual(ledger.list_refused(), [])
            self.assertEqual(model.deck, plain.deck)

    def test_the_step_is_limited_by_the_least_value_of_its_curve(self):
        text = decks.make_block(decks.LAWS["table"][1], "", True)
        cards = "*DEFINE_CURVE\n77\n0,3e-7\n1,2e-7\n*CONTROL_TIMESTEP\n0,0.9,0,0,0,77\n*END"
        self.assertEqual(self.read(text.replace("*END", cards))[0].deck["time"]["max_step"], 2e-7)

    def test_accelerometers_are_followed(self):
        cards = "*ELEMENT_SEATBELT_ACCELEROMETER\n7,1,2,4,1,1,0.25\n8,2,1,4\n*DATABASE_HISTORY_NODE\n2\n*END"
        text = decks.make_block(decks.LAWS["table"][1], "", False).replace("*END", cards)
        model, ledger = self.read(text)
        self.assertEqual(outcomes(ledger, Status.REFUSED), set())
        self.assertIn("ELEMENT_SEATBELT_ACCELEROMETER", outcomes(ledger, Status.APPROXIMATED))  # INTOPT = 0 of the second
        history = model.deck["output"]["history"]
        self.assertEqual(history["nodes"], [{"name": f"node_{id}", "id": id} for id in (2, 1, 4)])
        self.assertEqual(history["accelerometers"], [
            {"name": "accelerometer_7", "nodes": ["node_1", "node_2", "node_4"], "gravity": "remove"},
            {"name": "accelerometer_8", "nodes": ["node_2", "node_1", "node_4"]}])
        self.assertEqual([mass["mass"] for mass in model.deck["added_mass"]], [0.25])
        self.assertIn("ELEMENT_SEATBELT_ACCELEROMETER.IGRAV", self.refusals(text.replace("7,1,2,4,1,1", "7,1,2,4,-3,1")))
        self.assertIn("ELEMENT_SEATBELT_ACCELEROMETER.nodes", self.refusals(text.replace("7,1,2,4,1,1", "7,1,2,99,1,1")))

    def test_a_section_by_sets_is_a_force(self):
        sets = "*SET_NODE_LIST\n81\n1,2,3,4\n*SET_SOLID_LIST\n82\n500\n*SET_BEAM\n83\n7\n"
        card = "*DATABASE_CROSS_SECTION_SET_ID\n5,foot of the block\n81,82\n*DATABASE_CROSS_SECTION_SET\n81,0,83\n*END"
        text = decks.FULL.replace("*END", sets + card)
        model, ledger = self.read(text)
        self.assertEqual(
            [force for force in model.deck["output"]["history"]["forces"] if "section" in force],
            [{"name": "foot_of_the_block", "section": {"nodes": "nodes_81", "elements": ["elements_82"]}}],
        )
        self.assertIn("DATABASE_CROSS_SECTION_SET", outcomes(ledger, Status.IGNORED))
        self.accept(text)

    def test_forces_of_surfaces_are_written(self):
        faces = "*SET_SEGMENT\n84\n11,12,13,14\n"
        contact = "*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE\n84,8,0,3\n0\n0\n*DATABASE_RCFORC\n1e-6\n*END"
        text = decks.FULL.replace("*END", faces + contact)
        model, _ = self.read(text)
        sides = [force["contact"] for force in model.deck["output"]["history"]["forces"] if "contact" in force]
        self.assertIn("sides_84", [side[0] for side in sides])
        self.accept(text)

    def test_beams_are_turned_by_a_vector(self):
        text = decks.BEAMS
        first = text.index("*ELEMENT_BEAM")
        rows = text[first:].split("\n*", 1)[0].splitlines()
        beams = [line[:32] + "       0" + line[40:] + "\n         0         1         0" for line in rows[1:] if not line.startswith("$")]
        turned = text.replace("\n".join(rows), "\n".join(["*ELEMENT_BEAM_ORIENTATION", *beams]))
        model, ledger = self.read(turned.replace("*ELEMENT_BEAM\n", "*ELEMENT_BEAM_ORIENTATION\n") if turned == text else turned)
        self.assertEqual(outcomes(ledger, Status.REFUSED), set())
        self.assertIn([0.0, 1.0, 0.0], [block.keys.get("toward") for block in model.blocks])


# Cards that may have a title or an id in a line of their own, beside those of decks.FULL.
WITH_TITLES = """\
*HOURGLASS
6,5,0.05
*DEFINE_BOX
4,-1.0,9.0,-1.0,9.0,-1.0,9.0
*DEFINE_VECTOR
5,0,0,0,1.0,0,0
*DEFINE_COORDINATE_SYSTEM
7,0,0,0,1.0,0,0
0,1.0,0
*DEFINE_TABLE
90
0
1
*DEFINE_CURVE
91
0,3e8
0.5,3e8
*DEFINE_CURVE
92
0,4e8
0.5,4e8
*CONSTRAINED_NODAL_RIGID_BODY
33,0,60
*CONSTRAINED_SPOTWELD
24,14
*CONSTRAINED_NODE_SET
61,1
*SET_NODE_LIST
61
2,3
*MAT_ADD_EROSION
3,0
0,9e9
*RIGIDWALL_GEOMETRIC_SPHERE
0
0,0,9
1.5
*CONTACT_TIED_NODES_TO_SURFACE
61,8,4,3


*DATABASE_CROSS_SECTION_SET
61,88
*SET_SOLID_LIST
88
500
"""
TITLED = (
    "SECTION_SOLID MAT_PIECEWISE_LINEAR_PLASTICITY SECTION_SHELL HOURGLASS DEFINE_BOX DEFINE_VECTOR DEFINE_COORDINATE_SYSTEM DEFINE_TABLE DEFINE_CURVE SET_PART_LIST SET_NODE_LIST SET_SOLID_LIST "
    "MAT_ADD_EROSION CONSTRAINED_NODAL_RIGID_BODY CONTACT_AUTOMATIC_SURFACE_TO_SURFACE CONTACT_TIED_NODES_TO_SURFACE"
).split()
WITH_ID = (
    "BOUNDARY_SPC_SET BOUNDARY_PRESCRIBED_MOTION_NODE LOAD_SEGMENT LOAD_NODE_SET CONSTRAINED_SPOTWELD CONSTRAINED_NODE_SET RIGIDWALL_GEOMETRIC_SPHERE CONTACT_AUTOMATIC_SURFACE_TO_SURFACE "
    "CONTACT_TIED_NODES_TO_SURFACE DATABASE_CROSS_SECTION_SET"
).split()


class Titles(InFolder):
    def describe(self, text):
        model, ledger = self.read(text, "all")
        return {**model.deck, "materials": model.materials, "sets": model.node_sets}, [(row.card, row.status, row.text, row.count) for row in ledger.list_rows()]

    def test_a_blank_line_of_a_title_or_an_id_is_that_line(self):
        """Without the option and with it the model and the report are one."""
        text = decks.FULL.replace("*END", WITH_TITLES + "*END")
        right = self.describe(text)
        for option, names in (("TITLE", TITLED), ("ID", WITH_ID)):
            for name in names:
                for blank in ("", "     "):
                    with self.subTest(name=name, option=option, blank=blank):
                        self.assertIn(f"*{name}\n", text)
                        self.assertEqual(self.describe(text.replace(f"*{name}\n", f"*{name}_{option}\n{blank}\n")), right)

    def test_one_constant_of_cowper_and_symonds_is_in_the_report(self):
        for card, field, text in (
            ("*MAT_024\n1,7850.0,2.0e11,0.3,2e8,2e10\n40.4,0\n0\n0\n", "MAT_PIECEWISE_LINEAR_PLASTICITY.C", "C without P"),
            ("*MAT_024\n1,7850.0,2.0e11,0.3,2e8,2e10\n,5.0\n0\n0\n", "MAT_PIECEWISE_LINEAR_PLASTICITY.P", "P without C"),
            ("*MAT_123\n1,7850.0,2.0e11,0.3,2e8,2e10\n40.4,-5.0\n0\n0\n", "MAT_MODIFIED_PIECEWISE_LINEAR_PLASTICITY.C", "C or P below 0"),
            ("*MAT_081\n1,7850.0,2.0e11,0.3,2e8,2e10\n40.4\n0\n0\n", "MAT_PLASTICITY_WITH_DAMAGE.C", "C without P"),
            ("*MAT_003\n1,7850.0,2.0e11,0.3,2e8,2e10,0.5\n40.4\n", "MAT_PLASTIC_KINEMATIC.SRC", "SRC without SRP"),
            ("*MAT_018\n1,7850.0,2.0e11,0.3,6e8,0.2,,5.0\n3e8\n", "MAT_POWER_LAW_PLASTICITY.SRP", "SRP without SRC"),
            ("*MAT_153\n1,7850.0,2.0e11,0.3,2e8,1e8,10.0\n1e9,5.0,0,0,40.4\n0\n0\n", "MAT_DAMAGE_3.SRC", "SRC without SRP"),
            ("*MAT_036\n1,7850.0,2.0e11,0.3,1,1e9,2e8\n2,1.0,1.0,1.0\n0,40.4\n\n\n", "MAT_3-PARAMETER_BARLAT.C", "C without P"),
        ):
            with self.subTest(card=card):
                model, ledger = self.read(decks.make_block(card, "", True))
                rows = [row for row in ledger.list_rows() if row.card == field]
                self.assertEqual([(row.status, row.text.split(":")[0]) for row in rows], [(Status.IGNORED, text)])
                self.assertNotIn("cowper_symonds_rate", next(iter(model.materials.values())))
        both = decks.make_block("*MAT_024\n1,7850.0,2.0e11,0.3,2e8,2e10\n40.4,5.0,0,54\n0\n0\n*DEFINE_CURVE\n54\n0,1\n100,1.5\n", "", True)
        self.assertIn("MAT_PIECEWISE_LINEAR_PLASTICITY.C", outcomes(self.read(both)[1], Status.IGNORED))


class Instances(InFolder):
    def test_a_mesh_within_an_instance_is_its_own(self):
        start = decks.ABAQUS_RATES.index("*MATERIAL")
        mesh = decks.ABAQUS_RATES[:start]
        text = f"*PART, NAME=p\n*END PART\n*ASSEMBLY, NAME=a\n*INSTANCE, NAME=i, PART=p\n0., 0., 3.\n{mesh}*END INSTANCE\n"
        text += "*NSET, NSET=low, INSTANCE=i\n1, 2, 3, 4\n*END ASSEMBLY\n" + decks.ABAQUS_RATES[start:].replace("all, 3", "low, 3")
        model, ledger = self.read_abaqus(text)
        self.assertEqual(outcomes(ledger, Status.REFUSED), set())
        self.assertEqual(model.nodes[5], (0.0, 0.0, 4.0))
        self.assertEqual(model.node_sets["low"], [1, 2, 3, 4])


class Rigid(InFolder):
    def test_a_rigid_body_of_abaqus_is_a_rigid_part(self):
        model, ledger = self.read_abaqus(decks.ABAQUS_RIGID)
        self.assertEqual(outcomes(ledger, Status.REFUSED), set())
        self.assertEqual(model.blocks[0].keys["rigid"], {"fixed": ["x", "y", "rx", "ry", "rz"]})
        self.assertEqual(model.deck["conditions"][0]["velocity"], {"z": -2.0})
        self.accept(decks.ABAQUS_RIGID, "rigid.inp")

    def test_a_body_that_moves_along_an_axis_and_turns_freely_is_refused(self):
        text = decks.ABAQUS_RIGID.replace("9, 4, 6\n", "")
        self.assertIn("BOUNDARY.reference", outcomes(self.read_abaqus(text)[1], Status.REFUSED))

    def test_masses_are_scaled(self):
        text = decks.ABAQUS_RIGID.replace("*RIGID BODY, REF NODE=9, ELSET=cube\n", "").replace("9, 1, 2\n9, 4, 6\n", "all, 1\n")
        scaled = "*VARIABLE MASS SCALING, DT=1e-5, TYPE=BELOW MIN, FREQUENCY=1\n*BOUNDARY, TYPE"
        model, ledger = self.read_abaqus(text.replace("9, 3, 3", "all, 3, 3").replace("*BOUNDARY, TYPE", scaled))
        self.assertEqual(outcomes(ledger, Status.REFUSED), set())
        self.assertEqual(model.blocks[0].keys["mass_scaling"], {"step": 1e-5, "max_added": 1e6, "every": 1})

    def test_numerics_of_the_step_are_told(self):
        _, ledger = self.read_abaqus(decks.ABAQUS_RIGID)
        self.assertIn("DYNAMIC.DIRECT USER CONTROL", outcomes(ledger, Status.IGNORED))


if __name__ == "__main__":
    unittest.main()
