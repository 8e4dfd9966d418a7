"""Mutations are found where code is, and nowhere else; the tests nearest to a file come first."""

import pathlib
import sys
import tempfile
import unittest

FOLDER = pathlib.Path(__file__).resolve().parent
sys.path[:0] = [str(FOLDER), str(FOLDER.parent / "faults"), str(FOLDER.parent)]

import nearest  # noqa: E402
import sites  # noqa: E402


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
        self.known.headers = {"lib/vnv_judge.dir/a.o": {"/s/vnv/judge/a.cpp"}, "t/vnv_judge_test.dir/t.o": {"/s/vnv/judge/t.cpp"},
                              "t/vnv_gate_test.dir/t.o": {"/s/vnv/gate/t.cpp"}, "c/flow.dir/flow.o": {"/s/vnv/judge/a.hpp"}}
        self.known.compile_seconds = {"lib/vnv_judge.dir/a.o": 2, "c/flow.dir/flow.o": 9}
        everything = frozenset(self.known.headers)
        self.known.programs = [nearest.Program("vnv/vnv_gate_test", everything, 1), nearest.Program("vnv/flow", everything, 1),
                               nearest.Program("vnv/vnv_judge_test", everything, 5)]

    def test_are_those_of_its_own_folder_and_then_the_cheapest(self):
        self.assertEqual([program.name for program in self.known.of("vnv/judge/a.cpp")], ["vnv_judge_test", "flow"])
        self.assertEqual([program.name for program in self.known.of("vnv/judge/a.hpp")], ["flow"])


if __name__ == "__main__":
    unittest.main()
