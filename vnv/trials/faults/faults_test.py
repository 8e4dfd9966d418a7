"""Files of faults are read or refused in one line; what is tried is undone; survivors stand first."""

import pathlib
import random
import signal
import tempfile
import time
import types
import unittest
import unittest.mock

import matrix
import scratch
import seeded
import shared

runner = types.ModuleType("runner")
runner.__file__ = str(pathlib.Path(__file__).with_name("try.py"))
exec(compile(pathlib.Path(runner.__file__).read_text(encoding="utf-8"), runner.__file__, "exec"), runner.__dict__)

TEXT = "Too viscous\n\nnoticed by flow.mpm\nin law.hpp\n- nu;\n+ 2 * nu;\n"


class InAFolder(unittest.TestCase):
    def setUp(self):
        self.held = tempfile.TemporaryDirectory()
        self.addCleanup(self.held.cleanup)
        self.folder = pathlib.Path(self.held.name)
        (self.folder / "harmless").mkdir()

    def write(self, name, text):
        file = self.folder / name
        file.write_text(text, encoding="utf-8")
        return file

    def fault(self, text=TEXT, name="thick.fault"):
        return seeded.read(self.write(name, text))

    def copy(self):
        """One that lies here, of which nothing is made equal to the sources."""
        copy = scratch.Scratch.__new__(scratch.Scratch)
        copy.source, copy.jobs = self.folder, 1
        return copy

    def line(self, name, conclusion=matrix.NOTICED, margin=-1.0, failed=True, **more):
        """Of results: one test was run."""
        test = {"failed": failed, "margin": margin, "sentence": 'flow.mpm: L2 = 5, "x":\n FAILS'}
        return {"fault": name, "title": name.upper(), "harmless": False, "files": ["a", "b"], "conclusion": conclusion,
                "why": "", "tests": {"flow.mpm": test}, "revision": "abc", "finished_at": "2026-11-23T02:00:00Z",
                "digest": "00ff"} | more

    def assert_refused(self, words, work):
        with self.assertRaises(shared.BadInput) as refused:
            work()
        self.assertIn(words, str(refused.exception))
        self.assertNotIn("\n", str(refused.exception))


class AFaultFile(InAFolder):
    def test_is_a_title_a_test_and_a_change(self):
        fault = self.fault()
        self.assertEqual((fault.name, fault.title, fault.tests), ("thick", "Too viscous", ("flow.mpm",)))
        self.assertEqual(fault.changes, (seeded.Change("law.hpp", "nu;", "2 * nu;", 5),))

    def test_may_change_several_lines_in_several_files(self):
        fault = self.fault("A\n\nnoticed by x\nin a\n- one\n-   two\n+ 1\nin b\n- three\n")
        changes = [(change.file, change.old, change.new) for change in fault.changes]
        self.assertEqual(changes, [("a", "one\n  two", "1"), ("b", "three", "")])

    def test_that_is_harmless_may_be_of_how_it_is_built_or_run(self):
        fault = self.fault("A\n\nunnoticed by x\nconfigure -DA=B\nenvironment C=D\n", "harmless/a.fault")
        self.assertTrue(fault.harmless)
        self.assertEqual((fault.configure, fault.environment), (("-DA=B",), ("C=D",)))

    def test_may_say_why_it_survives_and_is_the_same_fault(self):
        given = self.fault(TEXT.replace("in law", "survives because no flow\nsurvives because is seen there\nin law"))
        self.assertEqual(given.why, "no flow is seen there")
        self.assertEqual(given.text, self.fault().text)
        self.assert_refused(":4: 'survives", lambda: self.fault("A\n\nunnoticed by x\nsurvives because y\n",
                                                                "harmless/a.fault"))

    def test_is_refused_by_its_line(self):
        for text, words in (("", ":1: no title"), ("A\nfoo\n", ":2: 'foo', expected"),
                            ("A\nnoticed by x\n- b\n", ":3: text to find and no file"),
                            ("A\nnoticed by x\nin b\n- c\n+ c\n", ":4: nothing is changed"),
                            ("A\nin b\n- c\n", "no test is named"), ("A\nnoticed by x\n", "nothing is changed"),
                            ("A\nnoticed by (\nin b\n- c\n", "expected a regular expression"),
                            ("A\nnoticed by x\nconfigure -DA=B\n", ":3: 'configure")):
            self.assert_refused(words, lambda text=text: self.fault(text))

    def test_names_files_of_the_sources_only(self):
        for file in ("../law.hpp", "/etc/hosts", "a/../../b"):
            self.assert_refused(f":4: in {file}", lambda file=file: self.fault(TEXT.replace("law.hpp", file)))

    def test_of_any_bytes_is_read_or_refused_in_one_line(self):
        chosen, taken = random.Random(1), 0
        samples = [file.read_bytes() for file in sorted(pathlib.Path(__file__).parent.rglob("*.fault"))]
        pieces = (b"\xff", b"\x1b[2J", b"(" * 5000, b"a{99999999999999}", b"\n- ", b"\n+ ", b"\nin ../", b"\nnoticed by (", b"\r", b"\0", b"")
        for sample in samples * 10:
            at, until = sorted(chosen.randrange(len(sample) + 1) for _ in range(2))
            file = self.folder / "any.fault"
            file.write_bytes(sample[:at] + chosen.choice(pieces) + sample[chosen.choice((at, at + 1, until)):])
            try:
                seeded.read(file)
                taken += 1
            except shared.BadInput as refusal:
                self.assertTrue(str(refusal).startswith(str(file)) and str(refusal).isprintable(), str(refusal))
        self.assertGreater(taken, 100)


class AChange(InAFolder):
    def test_is_of_a_text_that_stands_once(self):
        self.write("law.hpp", "x = nu;\n")
        self.assertEqual(seeded.changed(self.fault(), self.folder), {"law.hpp": ("x = nu;\n", "x = 2 * nu;\n")})

    def test_of_a_text_that_is_gone_or_stands_twice_is_refused(self):
        fault = self.fault()
        self.assert_refused("no file law.hpp", lambda: seeded.changed(fault, self.folder))
        for text, words in (("x\n", "found 0 times"), ("nu; nu;\n", "found 2 times")):
            self.write("law.hpp", text)
            self.assert_refused(words, lambda: seeded.changed(fault, self.folder))

    def test_is_undone_also_when_the_trial_breaks_off(self):
        self.write("law.hpp", "x = nu;\n")
        with self.assertRaises(KeyboardInterrupt), self.copy().with_change(self.fault()):
            self.assertEqual((self.folder / "law.hpp").read_text(encoding="utf-8"), "x = 2 * nu;\n")
            raise KeyboardInterrupt
        self.assertEqual((self.folder / "law.hpp").read_text(encoding="utf-8"), "x = nu;\n")


class AProgram(InAFolder):
    def test_that_is_broken_off_writes_nothing_later(self):
        def break_off(*_):
            raise KeyboardInterrupt

        self.addCleanup(signal.signal, signal.SIGALRM, signal.signal(signal.SIGALRM, break_off))
        signal.setitimer(signal.ITIMER_REAL, 0.2)
        with self.assertRaises(KeyboardInterrupt):
            shared.run(["sh", "-c", f"(sleep 0.5; echo late > {self.folder}/late) & wait"])
        time.sleep(0.5)
        self.assertFalse((self.folder / "late").exists())


class AUnitTest(InAFolder):
    def test_is_built_with_the_program_of_its_folder_and_else_with_its_module(self):
        (self.folder / "solvers" / "sph").mkdir(parents=True)
        self.write("solvers/sph/pair_test.cpp", "TEST(Pairs, Meet) {}\nTEST_F(Walls, Hold) {}\n")
        self.write("solvers/fit_test.cpp", "TEST(Fit, IsExact) {}\nTYPED_TEST(FitOf, IsExact) {}\n")
        for pattern, expected in (("unit.solvers.Pairs.*", {"solvers_sph_test"}),
                                ("unit.solvers.FitOf.*", {"solvers_test"}),
                                ("unit.solvers.(Walls|Fit).*", {"solvers_sph_test", "solvers_test"}),
                                ("unit.solvers.of_a_script", {"solvers_unit"})):
            self.assertEqual(scratch.programs_of_tests(self.folder, pattern), expected)


class ABuild(InAFolder):
    def test_keeps_no_program_of_an_earlier_trial(self):
        vnv = self.folder / "vnv"
        vnv.mkdir()
        for name in ("couette", "poiseuille", "vnv", "vnv_run_test", "couette_tests.cmake", "libvnv.a"):
            self.write(f"vnv/{name}", "").chmod(0o644 if "." in name else 0o755)
        left = lambda targets: self.copy().remove_others(self.folder, targets) or {file.name for file in vnv.iterdir()}
        self.assertEqual(left(["poiseuille", "vnv_unit", "vnv_command"]), {"poiseuille", "vnv", "vnv_run_test", "libvnv.a"})
        self.assertEqual(left(["poiseuille"]), {"poiseuille", "libvnv.a"})

    def test_is_not_named_in_what_the_compiler_says(self):
        said = f"{self.folder}/solvers/a.hpp:1:2: error: static assertion failed\n"
        with unittest.mock.patch.object(scratch, "run", lambda words: types.SimpleNamespace(returncode=1, stdout=said)):
            self.assertEqual(self.copy().compile(self.folder / "build", ["all"]), "solvers/a.hpp:1:2: error: static assertion failed")


class ATrial(InAFolder):
    def conclusion(self, failures, text=TEXT, name="thick.fault"):
        tests = {test: {"failed": failed} for test, failed in failures.items()}
        return runner.conclusion_of(self.fault(text, name), tests)

    def test_is_noticed_by_any_test_of_the_day(self):
        self.assertEqual(self.conclusion({"a": False, "b": True}), matrix.NOTICED)
        self.assertEqual(self.conclusion({"a": False, "nightly.b": True}), matrix.AT_NIGHT)
        self.assertEqual(self.conclusion({"a": False}), matrix.SURVIVED)

    def test_that_does_not_compile_is_none_unless_the_build_has_to_notice(self):
        broken = {seeded.THE_BUILD: True}
        self.assertEqual(self.conclusion(broken), matrix.NO_FAULT)
        self.assertEqual(self.conclusion(broken, TEXT.replace("flow.mpm", "the build")), matrix.NOTICED)

    def test_in_a_language_that_is_not_installed_is_none(self):
        fault = self.fault("A\n\nunnoticed by x\nenvironment LC_ALL=tlh_QO\n", "harmless/a.fault")
        self.assert_refused("a: LC_ALL=tlh_QO: unsupported locale setting, expected", lambda: runner.require_locale(fault))

    def test_of_a_harmless_change_that_is_noticed_is_a_false_alarm(self):
        text = TEXT.replace("noticed", "unnoticed")
        self.assertEqual(self.conclusion({"a": True}, text, "harmless/a.fault"), matrix.FALSE_ALARM)
        self.assertEqual(self.conclusion({"a": False}, text, "harmless/a.fault"), matrix.GREEN)


class Results(InAFolder):
    def test_forget_a_line_that_was_cut_off(self):
        file = self.write("results.jsonl", '{"key": "a"}\n{"key":')
        self.assertEqual(runner.read_results(file), [{"key": "a"}])
        self.assertEqual(file.read_text(encoding="utf-8"), '{"key": "a"}\n')

    def test_that_are_none_are_refused(self):
        self.assert_refused("expected a line of JSON a trial", lambda: runner.read_results(self.write("r.jsonl", "a\n")))

    def test_are_a_line_for_a_person_and_a_table_for_the_report(self):
        lines = [self.line("far", matrix.NOTICED, -9.0), self.line("lives", matrix.SURVIVED, 0.5, False),
                 self.line("nan", matrix.NOTICED, float("-inf")), self.line("unit", matrix.NOTICED, None)]
        self.assertEqual(matrix.summary(lines), "4 faults: 3 noticed by day (75.0 %), 3 in all; not as expected: lives")
        matrix.write(lines, self.folder / "results.csv", {"revision": "abc"})
        rows = (self.folder / "results.csv").read_text(encoding="utf-8").splitlines()
        self.assertEqual(rows[0], "# revision: abc")
        self.assertEqual(rows[2], 'far,FAR,a b,noticed,,flow.mpm,yes,-9.0,"flow.mpm: L2 = 5, ""x"": FAILS",abc,'
                                  '2026-11-23T02:00:00Z,00ff')
        self.assertEqual([row.split(",")[6:8] for row in rows[3:]], [["no", "0.5"], ["yes", "-inf"], ["yes", ""]])

    def test_are_read_as_they_were_written(self):
        lines = [self.line("far", matrix.NOTICED, -9.0), self.line("nan", matrix.NOTICED, float("-inf")),
                 self.line("unit", matrix.SURVIVED, None, False)]
        matrix.write(lines, self.folder / "results.csv", {"machine": "m: 2", "tests": "all"})
        given = lambda line: line["tests"]["flow.mpm"] | {"sentence": 'flow.mpm: L2 = 5, "x": FAILS'}
        expected = [line | {"tests": {"flow.mpm": given(line)}} for line in lines]
        self.assertEqual(matrix.read(self.folder / "results.csv"), ({"machine": "m: 2", "tests": "all"}, expected))
        self.assert_refused("r.csv:2: other columns", lambda: matrix.read(self.write("r.csv", "# a: b\nfault,title\n")))

    def test_of_a_part_of_the_tests_are_not_kept(self):
        self.assert_refused("expected a trial of all tests", lambda: runner.options_of(["--keep", "--tests", "sph"]))


class WhatIsKept(InAFolder):
    def setUp(self):
        super().setUp()
        in_the_folder = unittest.mock.patch.multiple(runner, FOLDER=self.folder, KEPT=self.folder / "trials.csv")
        in_the_folder.start()
        self.addCleanup(in_the_folder.stop)
        self.thick = self.fault()
        self.thin = self.fault(TEXT.replace("2 *", "0 *").replace("viscous", "thin"), "thin.fault")

    def kept(self, *arguments):
        return runner.LastTrials(runner.options_of(["--keep", *arguments]))

    def line_of(self, fault, finished_at):
        return self.line(fault.name, finished_at=finished_at, digest=runner.own_digest(fault))

    def test_keeps_of_each_fault_the_last_trial(self):
        self.kept().renew([self.line_of(self.thick, "1"), self.line_of(self.thin, "2")])
        self.kept().renew([self.line_of(self.thick, "3")])
        last = self.kept()
        self.assertEqual((last.tried_at(self.thick), last.tried_at(self.thin)), ("3", "2"))

    def test_forgets_a_fault_that_is_gone_or_is_another_now(self):
        self.kept().renew([self.line_of(self.thick, "1"), self.line_of(self.thin, "2")])
        self.fault(TEXT.replace("2 *", "3 *"))
        (self.folder / "thin.fault").unlink()
        self.assertEqual(self.kept().lines, {})

    def test_is_begun_anew_where_other_tests_are_run(self):
        self.kept().renew([self.line_of(self.thick, "1")])
        self.assertEqual(self.kept("--suite", "nightly").lines, {})

    def test_is_not_written_unless_that_is_asked_for(self):
        runner.LastTrials(runner.options_of([])).renew([self.line_of(self.thick, "1")])
        self.assertFalse(runner.KEPT.exists())


class AMargin(InAFolder):
    def test_is_the_smallest_but_for_counts_that_are_met(self):
        (self.folder / "acceptance").mkdir()
        given = (("holds", 0), ("holds", 0.3), ("holds", 0.2), ("fails", -2), ("fails", "nan"))
        verdicts = [{"outcome": outcome, "margin": margin, "sentence": ""} for outcome, margin in given]
        for failed, some, expected in ((False, verdicts[:3], 0.2), (False, verdicts[:1], 0), (True, verdicts[:4], -2),
                                     (True, verdicts, float("-inf"))):
            self.write("acceptance/flow.mpm.json", runner.json.dumps({"verdicts": some}))
            self.assertEqual(runner.margin_of("flow.mpm", self.folder, failed, "")["margin"], expected)


if __name__ == "__main__":
    unittest.main()
