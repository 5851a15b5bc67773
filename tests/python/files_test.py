#!/usr/bin/env python3
"""Tests of the three functions that all Python tools share: they write a file, load JSON, clean a text for a terminal."""

import io
import json
import os
import stat
import tempfile
import unittest

import given  # noqa: F401  (takes the words of the command line)
from percuss import NotResults  # noqa: E402
from percuss.files import NUMBER, TEXT, WHOLE, MapOf, Optional, Refused, load_json, make_mark, write_file  # noqa: E402
from percuss.terminal import clean, print_text  # noqa: E402


class OfAFolder(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name
        self.path = os.path.join(self.folder, "page.html")

    def put(self, text, name="page.html"):
        path = os.path.join(self.folder, name)
        with open(path, "w", encoding="utf-8") as file:
            file.write(text)
        return path

    def read(self, path=None):
        with open(path or self.path, encoding="utf-8") as file:
            return file.read()


class Writing(OfAFolder):
    def test_writes_a_new_file_with_the_rights_of_the_umask(self):
        before = os.umask(0o027)
        self.addCleanup(os.umask, before)
        write_file(self.path, "a page \u00b5", "report")
        self.assertEqual(self.read(), "a page \u00b5")
        self.assertEqual(stat.S_IMODE(os.stat(self.path).st_mode), 0o640)
        write_file(os.path.join(self.folder, "bytes"), b"\xff", "render")
        write_file(os.path.join(self.folder, "lines"), (f"{i}\n" for i in range(3)), "import")
        self.assertEqual(self.read(os.path.join(self.folder, "lines")), "0\n1\n2\n")
        self.assertEqual(sorted(os.listdir(self.folder)), ["bytes", "lines", "page.html"])

    def test_replaces_its_own_earlier_file_and_no_other(self):
        write_file(self.path, f"<meta content='{make_mark('report')}'>first", "report")
        write_file(self.path, f"<meta content='{make_mark('report')}'>second", "report")
        self.assertIn("second", self.read())
        with self.assertRaisesRegex(Refused, "is there already .percuss plot has not written it."):
            write_file(self.path, "a plot", "plot")
        self.put("notes of the user")
        with self.assertRaisesRegex(Refused, "page.html: this file is there already"):
            write_file(self.path, "third", "report")
        self.assertEqual(self.read(), "notes of the user")
        write_file(self.path, "third", "report", force=True)
        self.assertEqual(self.read(), "third")

    def test_finds_the_mark_at_the_end_of_a_long_file(self):
        self.put("x" * 200000 + make_mark("render"))
        write_file(self.path, "new", "render")
        self.assertEqual(self.read(), "new")

    def test_never_replaces_results_of_a_run(self):
        for name in ("summary.json", "history.csv", "checkpoint.h5", "fields_rim.vtkhdf", "fields.xdmf2", "run_deck.yaml"):
            path = self.put("a result", name)
            with self.assertRaisesRegex(Refused, "a result of a run"):
                write_file(path, "a page", "report", force=True)
            self.assertEqual(self.read(path), "a result")

    def test_never_follows_a_link(self):
        victim = self.put("precious", "victim")
        os.symlink(victim, self.path)
        for force in (False, True):
            with self.assertRaisesRegex(Refused, "this is a link"):
                write_file(self.path, "a page", "report", force)
        os.remove(self.path)
        os.symlink(os.path.join(self.folder, "nothing"), self.path)
        with self.assertRaisesRegex(Refused, "this is a link"):
            write_file(self.path, "a page", "report")
        self.assertEqual(self.read(victim), "precious")
        self.assertFalse(os.path.exists(os.path.join(self.folder, "nothing")))

    def test_refuses_folders_and_leaves_nothing_of_what_fails(self):
        with self.assertRaisesRegex(Refused, "no regular file"):
            write_file(self.folder, "a page", "report", force=True)

        def fail():
            yield "half"
            raise ValueError("no more")

        self.put("whole")
        with self.assertRaisesRegex(ValueError, "no more"):
            write_file(self.path, fail(), "report", force=True)
        self.assertEqual(self.read(), "whole")
        self.assertEqual(os.listdir(self.folder), ["page.html"])
        with self.assertRaises(FileNotFoundError):
            write_file(os.path.join(self.folder, "no", "page.html"), "a page", "report")


SHAPE = {"name": TEXT, "energy": {"error": NUMBER, "last": Optional(NUMBER)}, "of": [NUMBER, 3], "list": Optional([{"rule": TEXT}]),
         "times": MapOf(NUMBER), "count": WHOLE}
GOOD = {"name": "a", "energy": {"error": None}, "of": [1, 2.5, None], "times": {"x": 1.0, "y": None}, "count": 3, "more": [None]}


class Loading(OfAFolder):
    def load(self, content):
        return load_json(self.put(content if isinstance(content, str) else json.dumps(content)), SHAPE)

    def test_gives_nan_for_numbers_that_are_null(self):
        found = self.load(GOOD)
        self.assertEqual((found["name"], found["of"][:2], found["times"]["x"], found["more"]), ("a", [1, 2.5], 1.0, [None]))
        for value in (found["energy"]["error"], found["of"][2], found["times"]["y"]):
            self.assertNotEqual(value, value)

    def test_names_what_is_wrong(self):
        def change(path, value):
            content = json.loads(json.dumps(GOOD))
            place = content
            for key in path[:-1]:
                place = place[key]
            place[path[-1]] = value
            return content

        wrong = [(("name",), ["a"], "'name' is not a text"), (("energy", "error"), "1", "'energy.error' is not a number"),
                 (("energy",), [], "'energy' is not an object"), (("of",), [1, 2], "'of' is not a list of 3"), (("of", 1), {}, "'of.1' is not a number"),
                 (("list",), [{}], "'list.0.rule' is missing"), (("times", "x"), "now", "'times.x' is not a number"), (("count",), True, "'count' is not a whole"),
                 (("count",), 1.5, "'count' is not a whole"), (("count",), 10**400, "'count' is not a whole")]
        for path, value, words in wrong:
            with self.assertRaises(NotResults) as caught:
                self.load(change(path, value))
            self.assertIn(words, str(caught.exception))
            self.assertTrue(str(caught.exception).startswith(self.path + ": "))

    def test_refuses_what_is_no_json(self):
        for text in ("", "{", "[" * 200000, "\x00\xff", '{"name": "a"', "nul"):
            with self.assertRaisesRegex(NotResults, "this is no JSON"):
                self.load(text)
        for text in ("[1, 2]", "7"):
            with self.assertRaisesRegex(NotResults, "it is not an object"):
                self.load(text)
        for path, words in ((self.folder, "no regular file"), (os.path.join(self.folder, "nothing.json"), "No such file"), ("a\x00b", "null byte")):
            with self.assertRaisesRegex(NotResults, words):
                load_json(path, SHAPE)


class Cleaning(unittest.TestCase):
    def test_shows_what_a_terminal_would_obey(self):
        self.assertEqual(clean("a\x1b[2J\x07\x9b b\u202e\n"), "a\\x1b[2J\\x07\\x9b b\\u202e\\x0a")
        self.assertEqual(clean("\u00b5m \u2502 \U0001f600"), "\u00b5m \u2502 \U0001f600")

    def test_tells_in_the_encoding_of_the_terminal(self):
        stream = io.TextIOWrapper(io.BytesIO(), encoding="ascii")
        print_text("1 \u00b5m\n\x1b", stream)
        stream.flush()
        self.assertEqual(stream.buffer.getvalue(), b"1 ?m\n\\x1b\n")


if __name__ == "__main__":
    unittest.main()
