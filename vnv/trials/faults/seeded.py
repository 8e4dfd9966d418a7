"""Seeded faults and harmless changes: how their files are read, and what of them can be checked without building.

A fault lies in the folder of the module that it changes, a harmless change in `harmless`. A file is a title, who has to notice, and what is changed where:

    The fluid is 5 % too viscous

    noticed by stokes_first.mpm
    in solvers/mpm/stress.hpp
    - const Real mu = fill<Real>(fluid.viscosity)
    + const Real mu = fill<Real>(1.05 * fluid.viscosity)

The text behind `- `, of one line or of several, stands exactly once in its file. What is noticed by is a regular
expression that fits whole names of ctest, or `the build`. Of a fault that none notices `survives because WORDS` says
what is known of why. A harmless change is `unnoticed by` tests; it may also be of
how the project is built or run: `configure ARGUMENT OF CMAKE`, `environment NAME=VALUE`.
"""

import dataclasses
import pathlib
import re
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))

from shared import BadInput  # noqa: E402

THE_BUILD = "the build"
TOPS = ("solvers", "reference", "vnv", "reports")  # folders of the sources, each with tests
WHY = "survives because"
LEAST_FAULTS, LEAST_HARMLESS = 60, 15


@dataclasses.dataclass(frozen=True)
class Change:
    file: str
    old: str
    new: str
    line: int  # of the fault's file


@dataclasses.dataclass(frozen=True)
class Fault:
    name: str
    title: str
    harmless: bool
    tests: tuple  # regular expressions of names of ctest, or THE_BUILD
    changes: tuple
    configure: tuple = ()  # arguments of cmake
    environment: tuple = ()  # "NAME=VALUE"
    text: str = ""  # the whole file, but for why it survives
    why: str = ""  # no test notices it, as far as is known
    folder: str = ""


def require_pattern(where, pattern):
    try:
        re.compile(pattern)
    except (re.error, OverflowError, RecursionError) as error:
        raise BadInput(f"{where} '{pattern}': {error}, expected a regular expression") from error


def lines_of_change(lines, k, sign):
    """Text of the lines from `k` on that begin with a sign, and the line behind them."""
    found = []
    while k < len(lines) and (lines[k] == sign or lines[k].startswith(sign + " ")):
        found.append(lines[k][2:])
        k += 1
    return "\n".join(found), k


def read(file, needs_tests=True):
    where, harmless = str(file), file.parent.name == "harmless"
    try:
        text = file.read_text(encoding="utf-8")
    except UnicodeDecodeError as error:
        raise BadInput(f"{where}: {error}, expected text in UTF-8") from error
    lines = text.splitlines()
    if not lines or not lines[0].strip():
        raise BadInput(f"{where}:1: no title, expected what is wrong in one line")
    tests, changes, configure, environment, why, source = [], [], [], [], [], None
    listed = {("unnoticed by" if harmless else "noticed by"): tests}
    listed |= {"configure": configure, "environment": environment} if harmless else {WHY: why}
    k = 1
    while k < len(lines):
        line, at = lines[k], f"{where}:{k + 1}"
        if not line.strip() or line.startswith("#"):
            k += 1
        elif line.startswith("in "):
            source, k = line[3:].strip(), k + 1
            if pathlib.PurePath(source).is_absolute() or ".." in pathlib.PurePath(source).parts:
                raise BadInput(f"{at}: in {source}, expected a file of the sources")
        elif line.startswith("-"):
            if source is None:
                raise BadInput(f"{at}: text to find and no file, expected 'in FILE' above it")
            start = k + 1
            old, k = lines_of_change(lines, k, "-")
            new, k = lines_of_change(lines, k, "+")
            if not old.strip() or old == new:
                raise BadInput(f"{at}: nothing is changed, expected text to find and another to put there")
            changes.append(Change(source, old, new, start))
        else:
            word = next((word for word in listed if line.startswith(word + " ")), None)
            if word is None:
                raise BadInput(f"{at}: '{line}', expected {', '.join(listed)}, in, '- ', '+ ' or '#'")
            listed[word].append(line[len(word):].strip())
            k += 1
    for pattern in tests:
        require_pattern(f"{where}:", pattern)
    if not tests and needs_tests:
        raise BadInput(f"{where}: no test is named, expected '{next(iter(listed))} NAME'")
    if not (changes or configure or environment):
        raise BadInput(f"{where}: nothing is changed, expected 'in FILE' and what to change there")
    tried = [line for line in text.splitlines(keepends=True) if not line.startswith(WHY)]
    return Fault(file.stem, lines[0].strip(), harmless, tuple(tests), tuple(changes), tuple(configure),
                 tuple(environment), "".join(tried), " ".join(why), file.parent.name)


def read_all(folder):
    """All faults, then all harmless changes, each in the order of their names."""
    return sorted(map(read, folder.rglob("*.fault")), key=lambda fault: (fault.harmless, fault.name))


def module_of(file):
    """What the folder of faults in a file of the sources is called."""
    top, *inner = pathlib.PurePath(file).parts
    if top == "solvers":
        return f"solvers_{inner[0]}" if inner[0] in ("mpm", "sph") else top
    return inner[0] if top == "vnv" else top


def changed(fault, root):
    """The text of each changed file, as it was and as it becomes: {file: (before, after)}."""
    texts = {}
    for change in fault.changes:
        where = f"{fault.folder}/{fault.name}.fault:{change.line}"
        path = root / change.file
        if change.file not in texts:
            if not path.is_file():
                raise BadInput(f"{where}: no file {change.file}")
            before = path.read_text(encoding="utf-8")
            texts[change.file] = (before, before)
        before, after = texts[change.file]
        found = before.count(change.old)
        if found != 1:
            raise BadInput(f"{where}: found {found} times in {change.file}, expected once: '{change.old}'")
        if after.count(change.old) != 1:
            raise BadInput(f"{where}: changes what was changed above, expected texts apart: '{change.old}'")
        texts[change.file] = (before, after.replace(change.old, change.new))
    return texts


def shared_tests(folder):
    """Tests that a header has for several programs: {suite: [test]}."""
    found = {}
    for header in sorted(folder.rglob("*_tests.hpp")):
        for suite, test in re.findall(r"^TYPED_TEST_P\((\w+),\s*(\w+)\)", header.read_text(encoding="utf-8"), re.M):
            found.setdefault(suite, []).append(test)
    return found


def unit_tests(root):
    """The unit tests as ctest names them, but for the types of those that are run for several: {name: its file}.
    Of INSTANTIATE_TYPED_TEST_SUITE_P(PREFIX, SUITE, ...) it keeps the prefix: PREFIX.TEST<TYPE>."""
    found = {}
    for folder in TOPS:
        for file in sorted((root / folder).rglob("*_test.cpp")):
            for prefix, suite in re.findall(r"^INSTANTIATE_TYPED_TEST_SUITE_P\((\w+),\s*(\w+)", file.read_text(encoding="utf-8"), re.M):
                for test in shared_tests(root / folder).get(suite, []):
                    found[f"unit.{folder}.{prefix}.{test}<>"] = file
            tests = re.findall(r"^(TEST|TEST_F|TYPED_TEST)\((\w+),\s*(\w+)\)", file.read_text(encoding="utf-8"), re.M)
            for kind, suite, test in tests:
                found[f"unit.{folder}.{suite}.{test}{'<>' if kind == 'TYPED_TEST' else ''}"] = file
    return found


def program_of_tests(file):
    """That of the unit tests of a file's folder, the file named from the sources on."""
    return "_".join((*pathlib.PurePath(file).parent.parts, "test"))


def test_names(root, build):
    """All that ctest has in a build folder, but for unit tests, which are read in the sources; and which of the cases
    are not built."""
    names, missing = set(unit_tests(root)), []
    files = [build / "vnv" / "CTestTestfile.cmake"]
    for case in sorted((root / "vnv" / "cases").rglob("*.cpp")):
        file = build / "vnv" / f"{case.stem}_tests.cmake"
        files.append(file)
        if not file.is_file() or not file.stat().st_size:
            missing.append(case.stem)
    for file in files:
        if file.is_file():
            names |= set(re.findall(r"^add_test\((?:\[=\[)?\"?([\w.]+)", file.read_text(encoding="utf-8"), re.M))
    return names, missing


def case_of(pattern):
    """The case that a regular expression names, or nothing."""
    parts = pattern.split(".")
    head = parts[1] if parts[0] in ("nightly", "report") and len(parts) > 1 else parts[0]
    return None if head in ("unit", "selftest", THE_BUILD) else head


def complaints(folder, root, build=None):
    """Everything that is wrong with the files, in a line each."""
    found = []

    def attempt(work):
        try:
            return work()
        except BadInput as error:
            found.append(str(error))

    files = sorted(folder.rglob("*.fault"))
    faults = [fault for file in files if (fault := attempt(lambda: read(file)))]
    for harmless, least in ((False, LEAST_FAULTS), (True, LEAST_HARMLESS)):
        count = sum(fault.harmless == harmless for fault in faults)
        if count < least:
            found.append(f"{folder}: {count} {'harmless changes' if harmless else 'faults'}, expected at least {least}")
    made = lambda fault: (tuple((c.file, c.old, c.new) for c in fault.changes), fault.configure, fault.environment)
    for what, value_of in (("name", lambda fault: fault.name), ("title", lambda fault: fault.title), ("change", made)):
        first = {}
        for fault in faults:
            if first.setdefault(value_of(fault), fault) is not fault:
                found.append(f"{fault.name}: the same {what} as {first[value_of(fault)].name}, expected each once")
    for fault in faults:
        attempt(lambda: changed(fault, root))
        if not fault.harmless and fault.folder not in (modules := {module_of(change.file) for change in fault.changes}):
            found.append(f"{fault.folder}/{fault.name}.fault: expected in {' or '.join(sorted(modules))}")
    names, missing = test_names(root, build) if build else (set(unit_tests(root)), None)
    cases = {file.stem for file in (root / "vnv" / "cases").rglob("*.cpp")}
    for fault in faults:
        for pattern in fault.tests:
            case = case_of(pattern)
            if case and case not in cases:
                found.append(f"{fault.name}: '{pattern}': no case {case}, expected a file in vnv/cases")
            looked_up = pattern.startswith("unit.") or (build and pattern != THE_BUILD and case not in missing)
            if looked_up and not any(re.fullmatch(pattern, name) for name in names):
                found.append(f"{fault.name}: no test fits '{pattern}', expected names of ctest")
    return found
