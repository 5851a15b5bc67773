"""What python/percuss reads of a run: readers_test.py ROOT PERCUSS. Exit code 77 (skipped) without NumPy or h5py."""

import json
import os
import re
import shutil
import tempfile
import unittest

from given import PERCUSS, ROOT, require

require("h5py", "numpy")

import h5py
import numpy as np

import percuss  # noqa: E402
import sample_run  # noqa: E402
from percuss.results.deck import Deck  # noqa: E402
from percuss.results.history import History  # noqa: E402
from percuss.results.units import DIMENSIONS, Units, find_powers, find_units, name_quantity  # noqa: E402


def make_folder(test):
    folder = tempfile.TemporaryDirectory()
    test.addCleanup(folder.cleanup)
    return folder.name


def read_text(path):
    with open(path, encoding="utf-8") as file:
        return file.read()


class OfARun(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.folder.cleanup)
        cls.out = sample_run.run(PERCUSS, cls.folder.name)

    def copy(self):
        folder = os.path.join(make_folder(self), "copy")
        shutil.copytree(self.out, folder)
        return folder

    def test_history_has_every_number_of_the_file(self):
        history = percuss.read(self.out).history
        with open(os.path.join(self.out, "history.csv"), encoding="utf-8") as file:
            lines = file.read().splitlines()
        self.assertEqual(history.names, lines[0].split(","))
        self.assertEqual(len(history), len(lines) - 1)
        for row in (0, len(history) // 2, -1):
            wanted = [float(word) for word in lines[1:][row].split(",")]
            self.assertEqual([history[name][row] for name in history], wanted)

    def test_accelerations_are_means_between_rows(self):
        names = ["time", "dt", "tip_x", "tip_vx", "body_vx:ram", "wall_speed:lid", "odd_vx"]
        time, dt = np.array([0, 1, 1.5, 3]), np.array([0, 0.2, 0.1, 0.4])
        velocity = 3 * (time - dt / 2) ** 2  # half a step earlier than the row
        table = np.column_stack([time, dt, time, velocity, 2 * velocity, -velocity, velocity])
        sidecar = {"dt": {"dimension": "time"}, "tip_vx": {"dimension": "length time^-1", "meaning": "velocity in x of 'tip'"},
                   "wall_speed:lid": {"dimension": "length time^-1", "meaning": "speed of wall 'lid', along its normal or direction"}}
        history = History(names, table, Units("mm, kg, ms"), sidecar)
        self.assertEqual((list(history), history.derived), (names, ["tip_ax", "body_ax:ram", "wall_acceleration:lid"]))
        middle = time - dt / 2
        exact = 3 * (middle[1:] + middle[:-1])  # the mean of 6 t
        for name, factor in (("tip_ax", 1), ("body_ax:ram", 2), ("wall_acceleration:lid", -1)):
            np.testing.assert_allclose(history[name], factor * np.array([0, *exact]), rtol=1e-14)
        self.assertEqual((history.unit("tip_ax"), history.dimension("tip_ax")), ("mm/ms\u00b2", "acceleration"))
        self.assertEqual(history.meaning("tip_ax"), "acceleration in x of 'tip', mean since the row before")
        self.assertEqual(history.label("wall_acceleration:lid"), "acceleration of wall 'lid'")
        np.testing.assert_allclose(history.in_units(Units("m, kg, s"))["tip_ax"], 1e3 * history["tip_ax"])
        self.assertNotIn("odd_ax", history)
        self.assertIn("tip_ax", history)

    def test_walls_are_where_they_are_at_the_time_of_a_frame(self):
        walls = "[{point: [0, 0, -0.002], normal: z}, {name: lid, point: [-0.01, -0.01, 0.05], normal: -z, speed: 30, " \
                "rectangle: {along: x, size: [0.04, 0.05]}}]"
        run = percuss.read(sample_run.run(PERCUSS, make_folder(self), "--set", f"walls={walls}"))
        displacement = np.interp(run.fields.times, run.history["time"], run.history["wall_displacement:lid"])
        self.assertGreater(displacement[-1], 0.9 * 30 * run.fields.times[-1])
        for frame, by in enumerate(displacement):
            floor, lid = run.fields.walls_at(frame)
            np.testing.assert_array_equal(floor[0], [0, 0, -0.002])
            self.assertIsNone(floor[2])
            np.testing.assert_allclose(lid[0], [-0.01, -0.01, 0.05 - by], atol=1e-9)
            np.testing.assert_array_equal(lid[1], [0, 0, -1])
            np.testing.assert_allclose(lid[2], [[0.04, 0, 0], [0, -0.05, 0]], atol=1e-15)

    def test_cylinders_and_spheres_are_where_they_are_at_the_time_of_a_frame(self):
        walls = "[{name: ball, point: [0, 0, 0.2], sphere: {radius: 0.01}, direction: -z, speed: 20}, " \
                "{point: [0, 0, -0.02], cylinder: {axis: y, radius: 0.01, length: 0.03}}, " \
                "{name: lid, point: [0, 0, 0.3], normal: -z, speed: 30}, {point: [0, 0, -0.1], cylinder: {axis: x, radius: 0.02}}]"
        run = percuss.read(sample_run.run(PERCUSS, make_folder(self), "--set", f"walls={walls}"))
        moved = {name: np.interp(run.fields.times, run.history["time"], run.history[f"wall_displacement:{name}"])
                 for name in ("ball", "lid")}
        for frame in range(len(run.fields.times)):
            pole, endless, ball = run.fields.round_walls_at(frame)
            np.testing.assert_array_equal(pole[0], [0, 0, -0.02])
            np.testing.assert_array_equal(pole[1], [0, 1, 0])
            self.assertEqual(pole[2:], (0.01, 0.03))
            self.assertEqual(endless[2:], (0.02, None))
            np.testing.assert_allclose(ball[0], [0, 0, 0.2 - moved["ball"][frame]], atol=1e-9)
            self.assertIsNone(ball[1])
            np.testing.assert_allclose(run.fields.walls_at(frame)[0][0], [0, 0, 0.3 - moved["lid"][frame]], atol=1e-9)
        self.assertGreater(moved["ball"][-1], 0.9 * 20 * run.fields.times[-1])

    def test_every_column_has_a_dimension_and_its_unit(self):
        history = percuss.read(self.out).history
        self.assertEqual([name for name in history if history.dimension(name) is None], [])
        units = {"time": "s", "kinetic": "J", "momentum_z": "kg\u00b7m/s", "angular_x": "kg\u00b7m\u00b2/s", "wall_force_z": "N",
                 "contacts": "", "kinetic:block": "J", "mass:plate": "kg", "contact:surfaces": "J", "dt_element": ""}
        self.assertEqual({name: history.unit(name) for name in units}, units)

    def test_dimensions_units_and_meanings_are_those_of_columns_json(self):
        folder = self.copy()
        energy = "mass length^2 time^-2"
        columns = [{"name": "kinetic", "unit": "kJ", "dimension": energy, "meaning": "kinetic energy, of all"},
                   {"name": "kinetic:block", "unit": "J", "dimension": energy, "meaning": "kinetic energy of part 'block'"},
                   {"name": "contacts", "unit": "", "dimension": "1", "meaning": "interactions"},
                   {"name": "dt", "unit": None, "dimension": "time", "meaning": "step"}]
        with open(os.path.join(folder, "columns.json"), "w", encoding="utf-8") as file:
            json.dump({"units": "m, kg, s", "columns": columns}, file)
        os.remove(os.path.join(folder, "fields.vtkhdf"))
        history = percuss.read(folder).history
        self.assertEqual((history.unit("kinetic"), history.dimension("kinetic")), ("kJ", "energy"))
        self.assertEqual((history.meaning("kinetic"), history.label("kinetic")), ("kinetic energy, of all", "kinetic energy"))
        self.assertEqual(history.meaning("kinetic:block"), "kinetic energy of part 'block'")
        self.assertEqual((history.unit("contacts"), history.dimension("contacts"), history.unit("dt")), ("", "-", ""))
        self.assertEqual((history.unit("internal"), history.dimension("internal"), history.meaning("internal")), ("", None, "internal"))
        other = history.in_units(Units("mm, t, s"))
        self.assertAlmostEqual(other["kinetic"][0] / history["kinetic"][0], 1000)
        self.assertEqual(other.unit("kinetic"), "mJ")

    def test_summary_status_warnings_and_deck(self):
        run = percuss.read(self.out)
        self.assertEqual(run.status, "completed")
        self.assertEqual(len(run.summary["state_hash"]), 16)
        self.assertIsInstance(run.warnings, list)
        self.assertEqual(run.deck.get("parts.block.box.cells"), [2, 2, 2])
        self.assertEqual(run.deck.get("materials.steel.density"), 7850)
        self.assertEqual(run.title, "A block falls on a plate & <wall>")
        self.assertEqual(run.ranks[0]["elements"], run.summary["elements"])

    def test_fields_have_times_points_cells_and_values_by_name(self):
        run = percuss.read(self.out)
        fields = run.fields
        self.assertEqual(fields.part_names, ["block", "plate"])
        self.assertEqual(fields.times[0], 0)
        self.assertEqual(fields.times[-1], run.summary["time"])
        self.assertEqual(fields.steps[-1], run.summary["steps"])
        self.assertEqual([len(corners) for corners in fields.cells()], [8] * 8 + [4] * 16)
        self.assertEqual(fields.data("velocity", -1).shape, (fields.nodes, 3))
        np.testing.assert_array_equal(fields.positions(-1), fields.positions(len(fields.times) - 1))
        np.testing.assert_allclose(fields.positions(-1) - fields.positions(0), fields.data("displacement", -1), atol=1e-15)
        self.assertEqual(fields.unit_of("von_mises"), "Pa")
        with self.assertRaisesRegex(KeyError, "no field 'temperature'"):
            fields.data("temperature", 0)

    def test_units_agree_with_those_that_percuss_writes(self):
        for number, text in enumerate(("mm, t, s", "mm, kg, ms", "cm, g, us", "in, lbf s2/in, s", "ft, slug, s")):
            out = sample_run.run(PERCUSS, self.folder.name, "--set", "time.max_steps=1", units=text, name=f"units{number}")
            run = percuss.read(out)
            for field, quantity in (("velocity", "velocity"), ("von_mises", "pressure"), ("displacement", "length")):
                self.assertEqual(run.fields.unit_of(field), run.units.name_of(quantity), text)

    def test_a_line_that_is_half_written_is_left_out(self):
        folder = self.copy()
        whole = len(percuss.read(folder).history)
        with open(os.path.join(folder, "history.csv"), "ab") as file:
            file.write(b"0.0003,17,1e-")
        self.assertEqual(len(percuss.read(folder).history), whole)

    def test_a_run_that_goes_on_is_told_from_one_that_was_killed(self):
        folder = self.copy()
        path = os.path.join(folder, "summary.json")
        with open(path, encoding="utf-8") as file:
            text = file.read().replace('"completed"', '"running"')
        with open(path, "w", encoding="utf-8") as file:
            file.write(text)
        self.assertEqual(percuss.read(folder).status, "killed")
        start = read_text("/proc/self/stat").rpartition(")")[2].split()[19]
        boot = read_text("/proc/sys/kernel/random/boot_id").strip()
        lock = f"boot: {boot}\npid_namespace: {os.readlink('/proc/self/ns/pid')}\nprocess: {os.getpid()}\nprocess_start: "
        with open(os.path.join(folder, "run.lock"), "w", encoding="utf-8") as file:
            file.write(f"{lock}{start}\n")
        self.assertEqual(percuss.read(folder).status, "running")
        with open(os.path.join(folder, "run.lock"), "w", encoding="utf-8") as file:
            file.write(f"{lock}1\n")  # another process with this id
        self.assertEqual(percuss.read(folder).status, "killed")

    def test_the_deck_is_kept_with_what_was_set(self):
        out = sample_run.run(PERCUSS, self.folder.name, "--set", "time.end=3e-5", "-s", "contact.friction=0.25", name="set")
        deck = percuss.read(out).deck
        self.assertEqual((deck.get("time.end"), deck.get("contact.friction")), (3e-5, 0.25))
        self.assertEqual(deck.settings, ["time.end=3e-5", "contact.friction=0.25"])
        self.assertEqual(os.path.basename(deck.file), "deck.yaml")
        os.remove(os.path.join(out, "summary.json"))
        self.assertEqual(percuss.read(out).deck.values, deck.values)  # of the checkpoint

    def test_a_restart_in_another_folder_follows_the_first_run(self):
        other = sample_run.run(PERCUSS, self.folder.name, "--restart", os.path.join(self.out, "checkpoint_previous.h5"), name="later")
        first, later = percuss.read(self.out, other)
        whole = first.history.followed_by(later.history)
        for name in first.history:
            np.testing.assert_array_equal(whole[name], first.history[name], err_msg=name)
        self.assertEqual(later.summary["state_hash"], first.summary["state_hash"])
        self.assertLess(len(later.history), len(first.history))

    def test_becomes_a_table_of_pandas(self):
        try:
            import pandas  # noqa: F401
        except ImportError as error:
            self.skipTest(error)
        history = percuss.read(self.out).history
        frame = history.to_pandas()
        self.assertEqual(frame.index.name, "time")
        self.assertEqual(frame.attrs["units"]["kinetic"], "J")
        self.assertEqual(frame["kinetic"].iloc[-1], history["kinetic"][-1])

    def test_messages_name_what_is_there(self):
        with self.assertRaisesRegex(KeyError, "no column 'kinetics'.*kinetic"):
            percuss.read(self.out).history["kinetics"]
        empty = make_folder(self)
        with self.assertRaisesRegex(percuss.NotResults, "there are no results of percuss"):
            percuss.read(empty)
        with h5py.File(os.path.join(empty, "fields.vtkhdf"), "w"):
            pass
        with self.assertRaisesRegex(percuss.NotResults, "this is no fields file of percuss"):
            percuss.read(empty).fields
        with open(os.path.join(empty, "history.csv"), "w", encoding="utf-8") as file:
            file.write("time,step\n0,zero\n")
        with self.assertRaisesRegex(percuss.NotResults, "this is no row of 2 numbers: .0,zero"):
            percuss.read(empty).history


class OfUnits(unittest.TestCase):
    def test_are_those_of_the_table_in_the_docs(self):
        with open(os.path.join(ROOT, "docs/deck.md"), encoding="utf-8") as file:
            text = file.read()
        table = re.search(r"\| units \| force \| stress \| energy \| velocity \|\n\|[-|]+\|\n((?:\|.*\n)+)", text)[1]
        rows = [[cell.strip() for cell in line.strip("|").split("|")] for line in table.splitlines()]
        self.assertGreaterEqual(len(rows), 8)
        for name, *wanted in rows:
            units = find_units(name.replace(" (or SI)", ""))
            self.assertEqual([units.name_of(q) for q in ("force", "pressure", "energy", "velocity")], wanted, name)

    def test_of_a_quantity_by_its_product(self):
        self.assertEqual(find_powers("mass length^2 / time^2"), DIMENSIONS["energy"])
        self.assertEqual(find_powers("mass length^2 / time"), DIMENSIONS["angular momentum"])
        self.assertEqual([name_quantity(q) for q in ("mass length time^-2", "mass length^-1 time^-2", "1", "length^5", "force")],
                         ["force", "pressure", "-", "length^5", "force"])
        self.assertIsNone(find_powers("colour"))
        self.assertEqual(Units("mm, kg, ms").name_of("moment"), "kN\u00b7mm")
        self.assertEqual(Units("in, lbf-s^2/in, s, C").name_of("temperature"), "C")
        self.assertIsNone(find_units("m, kg"))


class OfADeck(unittest.TestCase):
    def test_values_are_written_as_yaml_that_percuss_reads_back(self):
        values = {"title": "yes", "name": "a: b # c", "time": {"end": 1e-3, "max_steps": 12}, "flag": True, "none": None, "tiny": 5e-324,
                  "parts": {f"part {i}": {"size": [1, -2e3, 3.5], "material": "null"} for i in range(9)}, "list": [{"a": "1e5"}, "x y"] * 20}
        try:
            import yaml
        except ImportError as error:
            self.skipTest(error)
        self.assertEqual(yaml.safe_load(Deck(values).text.replace("5e-324", "5.0e-324")), values)

    def test_a_value_is_found_by_its_path(self):
        deck = Deck({"time": {"end": 2e-3}, "initial": [{"part": "a"}], "parts": 3})
        self.assertEqual((deck.get("time.end"), deck.get("initial.0.part"), deck.get("time.start", 5)), (2e-3, "a", 5))
        self.assertEqual((deck.get_map("parts"), deck.get_list("time"), deck.get_list("initial")), ({}, [], [{"part": "a"}]))


if __name__ == "__main__":
    unittest.main()
