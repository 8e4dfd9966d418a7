"""Mutations are found where code is, and nowhere else; the tests nearest to a file come first; what is cut off leaves no module out."""

import contextlib
import io
import itertools
import os
import pathlib
import sys
import tempfile
import types
import unittest
import unittest.mock

FOLDER = pathlib.Path(__file__).resolve().parent
sys.path[:0] = [str(FOLDER), str(FOLDER.parent / "faults"), str(FOLDER.parent)]

import nearest  # noqa: E402
import sites  # noqa: E402

runner = types.ModuleType("runner")
runner.__file__ = str(FOLDER / "try.py")
exec(compile((FOLDER / "try.py").read_text(encoding="utf-8"), runner.__file__, "exec"), runner.__dict__)


def mutations(line):
    return [site.becomes for site in sites.sites("a.hpp", line)]


class Sites(unittest.TestCase):
    def test_operators_relations_and_constants_become_others(self):
        self.assertEqual(mutations("  if (a < b && c) return 0.5;"),
                         ["if (a <= b && c) return 0.5;", "if (a < b || c) return 0.5;", "if (a < b && c) return 1.0;"])
        self.assertEqual(mutations("  return a + 2 * b;"),
                         ["return a - 2 * b;", "return a + 2 / b;", "return a + 3 * b;"])

    def test_a_statement_is_dropped_but_no_declaration_and_no_jump(self):
        self.assertIn("", mutations("  sum += x;"))
        self.assertIn("", mutations("  list_near();"))
        for line in ("  return f(x);", "  const double a = b;", "  auto f = g(x);", "  break;"):
            self.assertNotIn("", mutations(line))

    def test_words_comments_directives_and_laws_of_the_compiler_are_left(self):
        for line in ('  // a + b', '#include "a + b"', "  static_assert(a + 1 == b);", "template <int n = 1>", "using A = B<2>;"):
            self.assertEqual(mutations(line), [])
        self.assertEqual(mutations('  throw Bad("1 + 1");'), [])

    def test_one_line_of_the_file_changes(self):
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "a.hpp"
            file.write_text("x = a + b;\n  x = a + b;\n", encoding="utf-8")
            site = sites.Site("a.hpp", 2, "x = a + b;", "x = a - b;", "arithmetic")
            (change,) = site.as_fault(pathlib.Path(folder)).changes
            self.assertEqual(change.new, "x = a + b;\n  x = a - b;\n")


class Nearest(unittest.TestCase):
    def setUp(self):
        self.known = nearest.Nearest.__new__(nearest.Nearest)
        self.known.source = pathlib.Path("/s")
        self.known.headers = {"lib/all_of_judge.dir/a.o": {"/s/vnv/judge/a.cpp"}, "t/vnv_judge_test.dir/t.o": {"/s/vnv/judge/t.cpp"},
                              "t/vnv_gate_test.dir/t.o": {"/s/vnv/gate/t.cpp"}, "c/flow.dir/flow.o": {"/s/vnv/cases/flow.cpp", "/s/vnv/judge/a.hpp"},
                              "lib/methods.dir/m.o": {"/s/vnv/methods/m.cpp", "/s/vnv/judge/a.hpp"}}
        self.known.compile_seconds = {"lib/all_of_judge.dir/a.o": 2, "c/flow.dir/flow.o": 9}
        everything = frozenset(self.known.headers)
        self.known.programs = [nearest.Program("vnv/vnv_gate_test", everything, 1), nearest.Program("vnv/flow", everything, 1),
                               nearest.Program("vnv/vnv_judge_test", everything, 5)]

    def names(self, file):
        return [program.name for program in self.known.of(file)]

    def test_are_those_of_its_own_folder_whatever_its_library_is_called_and_then_the_cheapest(self):
        self.assertEqual(self.names("vnv/judge/a.cpp"), ["vnv_judge_test", "flow"])

    def test_of_what_no_folder_with_tests_is_made_from_are_all_that_it_is_linked_into(self):
        self.assertEqual(self.names("vnv/methods/m.cpp"), ["vnv_gate_test", "flow", "vnv_judge_test"])

    def test_are_missed_where_no_program_is_made_from_a_folder(self):
        with tempfile.TemporaryDirectory() as folder:
            self.known.source = pathlib.Path(folder)
            self.known.headers = {"lib/m.o": {f"{folder}/vnv/methods/m.cpp"}}
            self.known.programs = [nearest.Program("vnv/vnv_gate_test", frozenset(self.known.headers), 1)]
            for file in ("vnv/methods/m.cpp", "reports/pages/index.cpp", "reports/main.cpp"):
                (self.known.source / file).parent.mkdir(parents=True, exist_ok=True)
                (self.known.source / file).touch()
            self.assertEqual(self.known.folders_without(), ["reports/pages"])


class AMutant(unittest.TestCase):
    def test_of_what_no_program_is_made_from_does_not_survive(self):
        worker = runner.Worker.__new__(runner.Worker)
        worker.nearest = unittest.mock.Mock(of=lambda file: [])
        change = runner.seeded.Fault("a", "A", False, (), (runner.seeded.Change("vnv/a.hpp", "a", "b", 1),))
        self.assertEqual(worker.tried(change)[0], runner.UNTESTED)


class EachFolderOfSources(unittest.TestCase):
    def test_has_tests_that_may_notice_and_belongs_to_a_module(self):
        build = pathlib.Path(os.environ.get("TOUCHSTONE_BUILD", "/nowhere"))
        programs = {nearest.program_of_tests(str(file.relative_to(runner.ROOT)))
                    for room in nearest.TOPS for file in (runner.ROOT / room).rglob("*_test.cpp")}
        if any(not (build / program.split("_")[0] / program).is_file() for program in programs):
            self.skipTest("not all programs of unit tests are built")
        known = nearest.Nearest(runner.ROOT, build, ())
        self.assertEqual(known.folders_without(), [])
        for folder in nearest.folders_of_sources(runner.ROOT):
            self.assertIsNotNone(runner.module_of(f"{folder}/a.hpp"), folder)
        for module, sites_of_module in runner.all_sites(runner.ROOT).items():
            self.assertTrue(any(known.compiled_into(file) for file in {site.file for site in sites_of_module}), module)


class ASample(unittest.TestCase):
    def test_takes_its_modules_in_turn(self):
        self.assertEqual(runner.in_turn([[1, 2, 3], [], [4, 5]]), [1, 4, 2, 5, 3])
        with tempfile.TemporaryDirectory() as folder:
            _, fresh = runner.Trials(runner.options_of(["--scratch", folder, "--seed", "0"])).sample()
        modules = [runner.module_of(site.file) for site in fresh]
        self.assertEqual(modules[:len(runner.SAMPLE)], list(runner.SAMPLE))
        self.assertEqual([modules.count(module) for module in runner.SAMPLE], list(runner.SAMPLE.values()))


class SeededFaults(unittest.TestCase):
    TITLE = "A law is another\n\n"
    CHANGE = "in law.hpp\n- nu;\n+ 2 * nu;\n"

    def setUp(self):
        held = tempfile.TemporaryDirectory()
        self.addCleanup(held.cleanup)
        self.folder = pathlib.Path(held.name)
        (self.folder / "law.hpp").write_text("x = nu;\ny = lambda;\n", encoding="utf-8")
        self.worker = unittest.mock.Mock()
        self.worker.return_value.tried.side_effect = lambda fault: (runner.NOTICED, "unit.law") if fault.name == "a" else (runner.SURVIVES, "")
        replaced = unittest.mock.patch.multiple(runner, ROOT=self.folder, Worker=self.worker)
        replaced.start()
        self.addCleanup(replaced.stop)

    def write(self, name, text):
        (self.folder / name).write_text(text, encoding="utf-8")

    def tried(self, *more):
        with contextlib.redirect_stdout(io.StringIO()) as said:
            passed = runner.try_faults(runner.options_of(["--faults", str(self.folder), "--scratch", str(self.folder), *more]))
        return passed, said.getvalue()

    def test_need_not_say_who_notices(self):
        self.write("a.fault", self.TITLE + self.CHANGE)
        passed, said = self.tried()
        self.assertTrue(passed)
        self.assertEqual(said, "noticed: a: A law is another  [unit.law]\n1 of 1 noticed\n")

    def test_that_do_not_fit_are_refused_before_anything_is_built(self):
        for text, words in (("", "no fault in it"), (self.TITLE, "nothing is changed"), (self.TITLE + self.CHANGE.replace("- nu", "- mu"), "found 0 times")):
            if text:
                self.write("a.fault", text)
            with self.assertRaises(runner.BadInput) as refused:
                self.tried()
            self.assertIn(words, str(refused.exception))
        self.worker.assert_not_called()

    def test_left_when_the_time_is_over_are_tried_by_the_next_command(self):
        self.write("a.fault", self.TITLE + self.CHANGE)
        self.write("b.fault", self.TITLE + self.CHANGE.replace("nu", "lambda"))
        self.assertEqual(self.tried("--minutes", "0"), (False, "2 of 2 left: the same command goes on with them\n0 of 0 noticed\n"))
        self.worker.assert_not_called()
        with unittest.mock.patch.object(runner.time, "monotonic", itertools.count(0, 30).__next__):
            self.assertIn("1 of 2 left", self.tried("--minutes", "1")[1])
        self.assertEqual(self.tried(), (False, "survives: b: A law is another  []\n1 of 2 noticed\n"))
        self.assertEqual(self.tried("--survivors"), (False, "survives: b: A law is another  []\n1 of 2 noticed\n"))


if __name__ == "__main__":
    unittest.main()
