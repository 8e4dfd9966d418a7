#!/usr/bin/env python3
"""Detection power: seeds one fault at a time in a copy of the sources and sees which tests notice.

The work tree is never changed. The copy in --scratch is made equal to it at each start, so that nothing is left of a
trial that was cut off; a trial is one line of --results, and is not repeated while neither the sources nor the fault
have changed. Exit status: 0 all faults noticed and no harmless change; 1 a fault survived, or a harmless change was
noticed; 3 bad input. How the files read: seeded.py.

Example: vnv/faults/try.py --scratch ~/faults --only 'viscos' --jobs 2
"""

import argparse
import dataclasses
import fcntl
import hashlib
import json
import os
import pathlib
import re
import shutil
import signal
import subprocess
import sys
import time
import xml.etree.ElementTree

import matrix
import seeded

FOLDER = pathlib.Path(__file__).resolve().parent
ROOT = FOLDER.parent.parent
RECORDED = FOLDER / "trials.csv"
SUITES = {"acceptance": "^(unit|acceptance)$", "nightly": "^(unit|nightly)$"}


def run(words, **more):
    """Runs a program to its end; whoever breaks off here ends all that it started, so that nothing is written later."""
    words = [str(word) for word in words]
    with subprocess.Popen(words, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, errors="replace",
                          start_new_session=True, **more) as process:
        try:
            said = process.communicate()[0]
        except BaseException:
            os.killpg(process.pid, signal.SIGTERM)
            raise
        return subprocess.CompletedProcess(words, process.returncode, said)


def source_files():
    """What belongs to the sources, committed or not, but for this folder and what is only to be read."""
    listed = run(["git", "-C", ROOT, "ls-files", "-co", "--exclude-standard", "-z"])
    if listed.returncode != 0:
        raise seeded.BadInput(f"{ROOT}: git lists no files: {listed.stdout.strip()}")
    names = sorted(name for name in listed.stdout.split("\0") if name and (ROOT / name).is_file())
    return [name for name in names if not name.endswith(".md") and not name.startswith("vnv/faults/")]


def digest(*texts):
    sums = hashlib.sha256()
    for text in texts:
        sums.update(hashlib.sha256(text if isinstance(text, bytes) else text.encode()).digest())
    return sums.hexdigest()[:16]


class Scratch:
    """A copy of the sources and the builds of it."""

    def __init__(self, folder, options):
        self.source, self.builds, self.options = folder / "source", folder, options
        self.source.mkdir(parents=True, exist_ok=True)
        self.lock = open(folder / "lock", "w", encoding="utf-8")
        try:
            fcntl.flock(self.lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except OSError as error:
            raise seeded.BadInput(f"{folder}: another trial runs here, wanted a folder of its own") from error
        self.equal_the_sources()

    def equal_the_sources(self):
        names, contents = source_files(), []
        for name in names:
            content, copy = (ROOT / name).read_bytes(), self.source / name
            contents.append(content)
            if not copy.is_file() or copy.read_bytes() != content:
                copy.parent.mkdir(parents=True, exist_ok=True)
                copy.write_bytes(content)
                copy.chmod((ROOT / name).stat().st_mode)
        known = set(names)
        for file in sorted(self.source.rglob("*")):
            if file.is_file() and str(file.relative_to(self.source)) not in known:
                file.unlink()
        self.digest = digest(*names, *contents)

    def configure(self, build, arguments=()):
        if (build / "build.ninja").is_file():
            return
        launcher = ["-DCMAKE_CXX_COMPILER_LAUNCHER=ccache"] if shutil.which("ccache") else []
        done = run(["cmake", "-S", self.source, "-B", build, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release",
                    "-DTOUCHSTONE_NATIVE=ON", *launcher, *arguments])
        if done.returncode != 0:
            raise seeded.BadInput(f"{build}: cannot be configured: {done.stdout.strip().splitlines()[-1]}")

    def targets(self, build, patterns):
        """The programs that the named tests need."""
        lists = (build / "vnv" / "CTestTestfile.cmake").read_text(encoding="utf-8")
        programs = {"vnv": "vnv_command"}
        found = set()
        for pattern in patterns:
            if pattern == seeded.THE_BUILD:
                found.add("vnv_methods")  # which compiles every method
            elif case := seeded.case_of(pattern):
                found.add(case)
            elif pattern.startswith("unit."):
                found.add(pattern.split(".")[1] + "_unit")
            elif pattern.startswith("selftest."):
                for line in lists.splitlines():
                    name = re.match(r'add_test\((?:\[=\[)?"?([\w.]+)', line)
                    if name and re.fullmatch(pattern, name[1]):
                        of_build = re.findall(re.escape(str(build)) + r"/vnv/(\w+)", line)
                        found |= {programs.get(program, program) for program in of_build}
        return sorted(found)

    def make(self, build, targets):
        """What the compiler said where it failed, else nothing."""
        done = run(["cmake", "--build", build, "-j", self.options.jobs, "--target", *targets])
        if done.returncode == 0:
            return ""
        said = [line for line in done.stdout.splitlines() if "error" in line] or done.stdout.splitlines()
        return said[0][:300]

    def look(self, build, patterns, environment):
        """Runs tests; what each says: {name: {failed, margin, sentence}}."""
        for case in (self.source / "vnv" / "cases").glob("*.cpp"):  # ctest wants all lists, also of what is not built
            tests = build / "vnv" / f"{case.stem}_tests.cmake"
            if not tests.exists():
                tests.write_text("", encoding="utf-8")
        records, report = build / "records", build / "faults.xml"
        shutil.rmtree(records, ignore_errors=True)
        for suite in ("acceptance", "report", "nightly"):
            (records / suite).mkdir(parents=True)
        report.unlink(missing_ok=True)
        names = [pattern for pattern in patterns if pattern != seeded.THE_BUILD]
        if not names and not self.options.suite:
            return {seeded.THE_BUILD: {"failed": False, "margin": None, "sentence": ""}}
        if self.options.suite:
            choice = ["-L", SUITES[self.options.suite]]
        else:
            choice = ["-R", "^(" + "|".join(names) + ")$", "-FA", "."]
        variables = dict(pair.split("=", 1) for pair in environment)
        done = run(["ctest", "--test-dir", build, "-j", self.options.jobs, "--timeout", self.options.timeout,
                    "--output-junit", report, *choice], env=os.environ | variables)
        if not report.is_file():
            raise seeded.BadInput(f"{build}: ctest ran nothing: {done.stdout.strip().splitlines()[-1]}")
        found = {}
        for case in xml.etree.ElementTree.parse(report).getroot().iter("testcase"):
            name, failed = case.get("name"), case.get("status") != "run"
            output = case.findtext("system-out") or ""
            if "SKIP" not in (case.findtext("skipped") or "") and case.get("status") != "disabled":
                found[name] = {"failed": failed} | margin_of(name, records, failed, output)
        return found


def margin_of(name, records, failed, output):
    """The smallest margin of a case's verdicts, with its sentence; without a record the first line that complains."""
    suite, _, rest = name.partition(".")
    file = records / (suite if suite in ("report", "nightly") else "acceptance")
    file = file / f"{rest if suite in ('report', 'nightly') else name}.json"
    if file.is_file():
        verdicts = json.loads(file.read_text(encoding="utf-8"))["verdicts"]
        number = lambda v: float(v["margin"]) if v["margin"] not in (None, "nan") else float("-inf")
        is_told = lambda v: v["outcome"] != "holds" if failed else number(v) != 0  # a count that is met has margin 0
        judged = [v for v in verdicts if is_told(v)] or verdicts
        if judged:
            worst = min(judged, key=number)
            return {"margin": number(worst), "sentence": worst["sentence"]}
    lines = [line.strip() for line in output.splitlines() if re.search(r"error|FAIL|wanted|Failure|Expected", line)]
    return {"margin": None, "sentence": lines[0][:300] if failed and lines else ""}


def tried(scratch, fault):
    """One trial, undone in the end: a line of the results."""
    own_build = bool(fault.configure)
    build = scratch.builds / (f"build-{fault.name}" if own_build else "build")
    texts = seeded.changed(fault, scratch.source)
    began = time.monotonic()
    scratch.configure(build, fault.configure)
    try:
        for file, (_, after) in texts.items():
            (scratch.source / file).write_text(after, encoding="utf-8")
        targets = ["all"] if scratch.options.suite else scratch.targets(build, fault.tests)
        said = scratch.make(build, targets) if targets else ""
        tests = {} if said else scratch.look(build, fault.tests, fault.environment)
    finally:
        for file, (before, _) in texts.items():
            (scratch.source / file).write_text(before, encoding="utf-8")
        if own_build:
            shutil.rmtree(build, ignore_errors=True)
    if said:
        tests = {seeded.THE_BUILD: {"failed": True, "margin": None, "sentence": said}}
    elif not tests:
        raise seeded.BadInput(f"{fault.name}: no test of ctest fits {', '.join(fault.tests)}")
    return {"fault": fault.name, "title": fault.title, "harmless": fault.harmless,
            "files": sorted({change.file for change in fault.changes}), "conclusion": conclusion_of(fault, tests),
            "seconds": round(time.monotonic() - began), "tests": tests,
            "finished_at": time.strftime("%Y-%m-%dT%H:%M:%SZ", time.gmtime())}


def conclusion_of(fault, tests):
    noticed = [name for name, test in tests.items() if test["failed"]]
    if fault.harmless:
        return matrix.FALSE_ALARM if noticed else matrix.GREEN
    if noticed == [seeded.THE_BUILD] and seeded.THE_BUILD not in fault.tests:
        return matrix.NO_FAULT
    if any(not name.startswith("nightly.") for name in noticed):
        return matrix.NOTICED
    return matrix.AT_NIGHT if noticed else matrix.SURVIVED


def read_results(file):
    """Earlier trials, one a line; a last line that was cut off is forgotten."""
    if not file.is_file():
        return []
    text = file.read_text(encoding="utf-8")
    whole = text[:text.rfind("\n") + 1]
    if whole != text:
        file.write_text(whole, encoding="utf-8")
    try:
        return [json.loads(line) for line in whole.splitlines()]
    except json.JSONDecodeError as error:
        raise seeded.BadInput(f"{file}: {error}, wanted a line of JSON a trial") from error


def require_green(scratch, faults, results, keep):
    """Tests that fail without a fault notice nothing."""
    patterns = sorted({pattern for fault in faults for pattern in fault.tests} - {seeded.THE_BUILD})
    unchanged = seeded.Fault("unchanged", "Nothing is changed", True, tuple(patterns), ())
    key = digest(scratch.digest, *patterns, scratch.options.suite or "")
    line = next((r for r in results if r["key"] == key), None)
    if line is None:
        print(f"unchanged sources, {len(patterns)} names of tests", flush=True)
        line = keep(tried(scratch, unchanged) | {"key": key})
    failed = [name for name, test in line["tests"].items() if test["failed"]]
    if failed:
        raise seeded.BadInput(f"{', '.join(failed)}: fails without a fault: {line['tests'][failed[0]]['sentence']}")


def provenance(lines, options):
    """Which sources were tried, when and where."""
    revision = run(["git", "-C", ROOT, "describe", "--always", "--dirty"]).stdout.strip()
    ends = [line["finished_at"] for line in lines if "finished_at" in line]  # not of lines that an older try.py left
    return {"title": "What came of each seeded fault, test by test", "revision": revision,
            "date": max(ends, default="unknown"), "machine": matrix.machine(),
            "tests": f"all of {options.suite}" if options.suite else "the tests that each fault names"}


def try_all(faults, options):
    scratch = Scratch(options.scratch.resolve(), options)
    results = read_results(options.results)

    def keep(line):
        with open(options.results, "a", encoding="utf-8") as file:
            file.write(json.dumps(line, ensure_ascii=False) + "\n")
        results.append(line)
        return line

    key_of = lambda fault: digest(scratch.digest, fault.text, *fault.tests, options.suite or "")
    keys = {fault.name: key_of(fault) for fault in faults}
    known = {r["key"] for r in results}
    fresh = [fault for fault in faults if keys[fault.name] not in known]
    if fresh:
        require_green(scratch, fresh, results, keep)
    for k, fault in enumerate(fresh):
        line = keep(tried(scratch, fault) | {"key": keys[fault.name]})
        told = f"{line['conclusion']}{matrix.by_whom(line)}, {line['seconds']} s"
        print(f"{k + 1}/{len(fresh)} {fault.name}: {told}", flush=True)
    result_of = lambda fault: next(r for r in reversed(results) if r["key"] == keys[fault.name])
    lines = [result_of(fault) | {"why": fault.why} for fault in faults]
    for file in [options.results.with_suffix(".csv"), *([RECORDED] if options.record else [])]:
        matrix.write(lines, file, provenance(lines, options))
    print(matrix.summary(lines))
    return 1 if any(line["conclusion"] in matrix.BAD for line in lines) else 0


def options_of(arguments):
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.error = lambda message: (_ for _ in ()).throw(seeded.BadInput(f"try.py: {message}"))
    parser.add_argument("--check", action="store_true", help="only check that faults fit today's sources and tests")
    parser.add_argument("--list", action="store_true", help="only list names and titles")
    parser.add_argument("--build", type=pathlib.Path, help="with --check: a whole build, to look up names of tests")
    parser.add_argument("--only", default="", help="regular expression found in a fault's name or title")
    parser.add_argument("--tests", default="", help="regular expression found in a name: of the named tests only these")
    parser.add_argument("--suite", choices=SUITES, help="build and run all of a suite, not only the named tests")
    parser.add_argument("--scratch", type=pathlib.Path, default=ROOT / "build-faults", help="folder of copy and builds")
    parser.add_argument("--results", type=pathlib.Path, help="lines of JSON; a table, .csv, stands beside")
    parser.add_argument("--record", action="store_true", help="keep what all faults came to as vnv/faults/trials.csv")
    parser.add_argument("--jobs", type=int, default=os.cpu_count(), help="at once, of compiler and of ctest")
    parser.add_argument("--timeout", type=int, default=900, help="of a test [s]")
    options = parser.parse_args(arguments)
    options.results = options.results or options.scratch / "results.jsonl"
    if options.record and (options.only or options.tests):
        raise seeded.BadInput("--record: with --only or --tests, wanted a trial of all faults")
    return options


def chosen(faults, only, tests):
    """The faults that fit, each with those of its tests that fit; one without any is left out."""
    for option, value in (("--only", only), ("--tests", tests)):
        try:
            re.compile(value)
        except re.error as error:
            raise seeded.BadInput(f"{option} '{value}': {error}, wanted a regular expression") from error
    found = []
    for fault in faults:
        named = tuple(test for test in fault.tests if re.search(tests, test))
        if named and (re.search(only, fault.name) or re.search(only, fault.title)):
            found.append(dataclasses.replace(fault, tests=named))
    if not found:
        raise seeded.BadInput(f"--only '{only}' --tests '{tests}': fits no fault, wanted one of vnv/faults")
    return found


def main(arguments):
    options = options_of(arguments)
    if options.check:
        found = seeded.complaints(FOLDER, ROOT, options.build and options.build.resolve())
        print("\n".join(found) if found else "each fault fits today's sources and tests")
        return 3 if found else 0
    faults = chosen(seeded.read_all(FOLDER), options.only, options.tests)
    if options.list:
        print("\n".join(f"{'harmless/' if fault.harmless else ''}{fault.name}: {fault.title}" for fault in faults))
        return 0
    return try_all(faults, options)


if __name__ == "__main__":
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(3))
    try:
        sys.exit(main(sys.argv[1:]))
    except seeded.BadInput as error:
        print(error, file=sys.stderr)
        sys.exit(3)
