"""The tests nearest to a source file: those whose programs are made from it, the cheapest to compile and run first."""

import dataclasses
import pathlib
import re
import resource
import subprocess

from seeded import TOPS, program_of_tests
from shared import BadInput, run

MEMORY = 8 * 2**30  # bytes; a mutant may ask for any amount
CALLED_BY_NO_TEST = re.compile(r"vnv/(trials|cases|bench/instructions|doors/(examples|client|read/fuzz))(/|$)|reports(/browser)?$")


def folders_of_sources(root):
    """All but those of programs, and of what selftests compile."""
    files = (file for room in TOPS for end in ("cpp", "hpp") for file in (root / room).rglob(f"*.{end}") if "test" not in file.name)
    return {folder for file in files if not CALLED_BY_NO_TEST.match(folder := str(file.relative_to(root).parent))}


@dataclasses.dataclass
class Program:
    path: str  # below the build folder, as ninja names it
    objects: frozenset
    seconds: float  # to run its tests

    @property
    def is_case(self):
        return not self.path.endswith("_test")

    @property
    def name(self):
        return pathlib.PurePath(self.path).name


def with_limited_memory():
    resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))


class Nearest:
    """What a complete build knows of its programs: the named cases, and all of unit tests."""

    def __init__(self, source, build, cases):
        self.source, self.build = source.resolve(), build
        self.headers = self.files_of_objects()
        self.compile_seconds = self.seconds_of_objects()
        paths = sorted(str(file.relative_to(build)) for room in TOPS for file in (build / room).glob("*_test"))
        self.programs = [Program(path, self.objects(path), 0) for path in [*paths, *(f"vnv/{case}" for case in cases)]]

    def changed_objects(self, file):
        """Those that a file is compiled into."""
        path = str(self.source / file)
        return {name for name, files in self.headers.items() if path in files}

    def is_of_its_folder(self, name, program):
        """Whether an object is made from sources in the folder whose tests the program has, or from these tests."""
        root = f"{self.source}/"
        return any(file.endswith(".cpp") and file.startswith(root) and program_of_tests(file.removeprefix(root)) == program.name
                   for file in self.headers.get(name, ()))

    def compiled_into(self, file):
        """The programs of which the tests, or the sources that they are of, are compiled anew, and cases of which anything
        is; where there are none, as of what main functions alone call, those that any such object is linked into."""
        changed = self.changed_objects(file)
        linked = [program for program in self.programs if program.objects & changed]
        near = [program for program in linked
                if program.is_case or any(self.is_of_its_folder(name, program) for name in program.objects & changed)]
        return near if any(not program.is_case for program in near) else linked

    def folders_without(self):
        """Folders of sources of which no file is compiled into any of the programs."""
        root = f"{self.source}/"
        reached = {str(pathlib.PurePath(file.removeprefix(root)).parent) for program in self.programs for name in program.objects
                   for file in self.headers.get(name, ()) if file.startswith(root)}
        return sorted(folders_of_sources(self.source) - reached)

    def files_of_objects(self):
        found, current = {}, None
        for line in run(["ninja", "-C", self.build, "-t", "deps"]).stdout.splitlines():
            if ": #deps" in line:
                current = found.setdefault(line.split(":")[0], set())
            elif line.startswith("    ") and current is not None:
                current.add(str((self.build / line.strip()).resolve()))
        if not found:
            raise BadInput(f"{self.build}: ninja knows of no files that objects are made from, expected a complete build")
        return found

    def seconds_of_objects(self):
        rows = (line.split("\t") for line in (self.build / ".ninja_log").read_text(encoding="utf-8").splitlines()[1:])
        return {row[3]: (int(row[1]) - int(row[0])) / 1000 for row in rows}

    def objects(self, program):
        listed = run(["ninja", "-C", self.build, "-t", "inputs", program]).stdout.splitlines()
        return frozenset(line for line in listed if line.endswith(".o"))

    def measure(self, timeout):
        """Runs all tests of an unchanged build, which have to pass, and keeps how long they take."""
        for program in self.programs:
            failed, program.seconds = self.failing_test(program, timeout)
            if failed:
                raise BadInput(f"{failed}: fails without a mutation, expected all tests to pass")

    def of(self, file):
        """Programs that a file is compiled into: those of its own folder's tests first, then by their cost."""
        changed = self.changed_objects(file)
        cost = lambda program: program.seconds + sum(self.compile_seconds.get(name, 0) for name in program.objects & changed)
        own = program_of_tests(file)
        return sorted(self.compiled_into(file), key=lambda program: (program.name != own, cost(program)))

    def failing_test(self, program, timeout):
        """The name of the first test that fails, or nothing, and the seconds that it took."""
        began = resource.getrusage(resource.RUSAGE_CHILDREN)
        words, where = [f"./{program.name}", "--gtest_fail_fast", "--gtest_brief=1"], self.build / pathlib.PurePath(program.path).parent
        if program.is_case:
            words = ["ctest", "--test-dir", self.build, "-L", "^acceptance$", "-R", f"^{program.name}[.]", "-FA", ".",
                     "--stop-on-failure", "--timeout", timeout]
        try:
            done = run(words, timeout=4 * timeout if program.is_case else timeout, cwd=where, preexec_fn=with_limited_memory)
            said, failed = done.stdout, done.returncode != 0
        except subprocess.TimeoutExpired:
            said, failed = "", True
        ended = resource.getrusage(resource.RUSAGE_CHILDREN)
        seconds = ended.ru_utime + ended.ru_stime - began.ru_utime - began.ru_stime
        if not failed:
            return "", seconds
        named = re.search(r"\[  FAILED  \] ([\w/<>]+\.[\w/]+)|Test +#\d+: (\S+) \.+.*(?:Failed|Timeout|Exception|Not Run)", said)
        room = pathlib.PurePath(program.path).parts[0]
        name = named[2] or f"unit.{room}.{named[1]}" if named else f"{program.name} ({'crashes' if said else 'does not end'})"
        return name, seconds
