#!/usr/bin/env python3
"""What the trials of a disturbed program ask is seen to fail where it should. Run as `works_test.py`."""

import contextlib
import io
import pathlib
import tempfile
import types
import unittest

import works
from shared import Failure, Trials, refusal, said_by, well


def shell(script):
    return ["sh", "-c", script]


class Writes(works.Work):
    """Writes a word, and ends as its script says."""

    expected = "old"

    def __init__(self, script):
        self.script = script

    def prepare(self, folder):
        (folder / "word").write_text("none", encoding="utf-8")

    def words(self, folder):
        return shell(f"cd {folder}; {self.script}")

    def found(self, folder):
        return (folder / "word").read_text(encoding="utf-8").strip()


class Met(works.Trouble):
    def run(self, words, folder, amount):
        return *said_by(words), True


class InAFolder(unittest.TestCase):
    def setUp(self):
        held = tempfile.TemporaryDirectory()
        self.addCleanup(held.cleanup)
        self.folder = pathlib.Path(held.name)

    def assert_fails(self, words, work, *given):
        with self.assertRaises(Failure) as found:
            work(*given)
        self.assertIn(words, str(found.exception))

    def test_what_is_cut_off_is_torn_and_what_is_hidden_is_left(self):
        for name, whole in (("records/a.json", '{"verdicts": []}'), ("site/a/index.html", "<p></html>\n"), ("site/a.svg", "<svg></svg>"),
                            ("nights/a.jsonl", '{"lines": 1}\n{}\n'), ("site/a.csv", "a")):
            file = self.folder / name
            file.parent.mkdir(parents=True, exist_ok=True)
            file.write_text(whole, encoding="utf-8")
            works.require_whole(self.folder)
            file.write_text(whole.strip()[:-1], encoding="utf-8")
            self.assert_fails(f"{file} is torn", works.require_whole, self.folder)
            file.rename(file.with_name(f".{file.name}.part"))
        self.assertEqual(len(works.half_written(self.folder)), 5)

    def test_a_refusal_is_one_line_of_a_program_that_ends_by_itself_and_changes_nothing(self):
        self.assertEqual(refusal(shell("echo at: no; echo no; exit 3"), "at", "no"), "at: no")
        for words, script in (("2 lines say", "echo at: no; echo at: no; exit 1"), ("0 lines say", "exit 1"), ("status 0", "echo at: no"),
                              ("status -9", "echo at: no; kill -KILL $$")):
            self.assert_fails(words, refusal, shell(script), "at", "no")
        self.assert_fails("something was written", works.refused_and_unchanged,
                          shell(f"echo a > {self.folder}/a; echo {self.folder}: no; exit 1"), self.folder, "no")
        self.assert_fails("status 3, expected 0", well, shell("exit 3"))

    def test_a_disturbed_program_does_its_work_or_says_why_and_goes_on(self):
        self.assertEqual(works.disturbed(Writes("echo old > word"), self.folder, Met(), 1), ("", True))
        fails_once = "[ -e again ] || { touch again; echo word: full; exit 1; }; echo %s > word"
        self.assertEqual(works.disturbed(Writes(fails_once % "old"), self.folder, Met(), 1), ("word: full", True))
        (self.folder / "again").unlink()
        for words, script in (("leaves something else", fails_once % "new"), ("without having done its work", "echo new > word"),
                              ("does not say why", "echo old > word; exit 1"), ("ended by signal", "kill -KILL $$"),
                              ("status 1, expected 0", "echo word: full; exit 1"), (".part is left", "touch .word.part; echo old > word")):
            self.assert_fails(words, works.disturbed, Writes(script), self.folder, Met(), 1)

    def test_trials_that_fail_are_counted_and_said(self):
        with Trials(types.SimpleNamespace(build=self.folder)) as trials, contextlib.redirect_stdout(io.StringIO()) as said:
            trials.attempt("one", str, "found")
            trials.attempt("another", well, shell("exit 1"))
            self.assertEqual(trials.conclude(), 1)
        self.assertRegex(said.getvalue(), "^passed one: found\nFAILED another: .*\n2 trials, 1 failed\n$")
        self.assertFalse(trials.scratch.exists())


if __name__ == "__main__":
    unittest.main()
