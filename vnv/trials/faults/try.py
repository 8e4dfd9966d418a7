#!/usr/bin/env python3
"""Detection power: seeds one fault at a time in a copy of the sources and sees which tests notice.

The work tree is never changed. The copy in --scratch is made equal to it at each start, so that nothing is left of a
trial that was cut off; a trial is one line of --results, and is not repeated while neither the sources nor the fault
have changed. Exit status: 0 all faults noticed and no harmless change; 1 a fault survived, or a harmless change was
noticed; 3 bad input. How the files read: seeded.py.

Example: vnv/trials/faults/try.py --scratch ~/faults --only 'viscos' --jobs 2
"""

import dataclasses
import json
import locale
import math
import os
import pathlib
import re
import shutil
import time
import xml.etree.ElementTree

import matrix
import seeded
from scratch import ROOT, UNREAD, Scratch, digest, empty_records
from shared import BadInput, Parser, exit_with, run

FOLDER = pathlib.Path(__file__).resolve().parent
KEPT = FOLDER / "trials.csv"
SUITES = {"acceptance": "^(unit|acceptance)$", "nightly": "^(unit|nightly)$"}


def run_tests(source, build, patterns, environment, options):
    """Runs tests; what each says: {name: {failed, margin, sentence}}."""
    for case in (source / "vnv" / "cases").rglob("*.cpp"):  # ctest wants all lists, also of what is not built
        tests = build / "vnv" / f"{case.stem}_tests.cmake"
        if not tests.exists():
            tests.write_text("", encoding="utf-8")
    records, report = build / "records", build / "faults.xml"
    empty_records(build)
    report.unlink(missing_ok=True)
    names = [pattern for pattern in patterns if pattern != seeded.THE_BUILD]
    if not names and not options.suite:
        return {seeded.THE_BUILD: {"failed": False, "margin": None, "sentence": ""}}
    if options.suite:
        choice = ["-L", SUITES[options.suite]]
    else:
        choice = ["-R", "^(" + "|".join(names) + ")$", "-FA", "."]
    variables = dict(pair.split("=", 1) for pair in environment)
    done = run(["ctest", "--test-dir", build, "-j", options.jobs, "--timeout", options.timeout,
                "--output-junit", report, *choice], env=os.environ | variables)
    if not report.is_file():
        raise BadInput(f"{build}: ctest ran nothing: {done.stdout.strip().splitlines()[-1]}")
    found = {}
    for case in xml.etree.ElementTree.parse(report).getroot().iter("testcase"):
        name, failed = case.get("name"), case.get("status") != "run"
        output = case.findtext("system-out") or ""
        if case.get("status") == "notrun" and "Unable to find executable" in output:
            raise BadInput(f"{name}: has no program, expected the programs of all named tests to be built")
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
    lines = [line.strip() for line in output.splitlines() if re.search(r"error|FAIL|expected|Failure|Expected", line)]
    return {"margin": None, "sentence": lines[0][:300] if failed and lines else ""}


def require_locale(fault):
    """Programs take one that is not installed for plain English, and nothing would be tried."""
    for pair in fault.environment:
        variable, value = pair.split("=", 1)
        if variable != "LC_ALL":
            continue
        try:
            locale.setlocale(locale.LC_ALL, value)
        except locale.Error as error:
            raise BadInput(f"{fault.name}: {pair}: {error}, expected one that is installed") from error
        finally:
            locale.setlocale(locale.LC_ALL, "C")


def tried(scratch, fault, options):
    """One trial, undone in the end: a line of the results."""
    own_build = bool(fault.configure)
    build = scratch.builds / (f"build-{fault.name}" if own_build else "build")
    began = time.monotonic()
    try:
        with scratch.with_change(fault):
            scratch.configure(build, fault.configure)
            targets = ["all"] if options.suite else scratch.targets(build, fault.tests)
            said = scratch.make(build, targets) if targets else ""
            tests = {} if said else run_tests(scratch.source, build, fault.tests, fault.environment, options)
            for test in tests.values():
                test["sentence"] = scratch.without_place(test["sentence"])
    finally:
        if own_build:
            shutil.rmtree(build, ignore_errors=True)
    if said:
        tests = {seeded.THE_BUILD: {"failed": True, "margin": None, "sentence": said}}
    elif not tests:
        raise BadInput(f"{fault.name}: no test of ctest fits {', '.join(fault.tests)}")
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
        raise BadInput(f"{file}: {error}, expected a line of JSON a trial") from error


def require_green(scratch, patterns, options, green):
    """Nothing is changed, and the tests have to pass: those that fail without a fault notice nothing."""
    untried = tuple(pattern for pattern in patterns if pattern != seeded.THE_BUILD and pattern not in green)
    if not untried:
        return
    line = tried(scratch, seeded.Fault("unchanged", "Nothing is changed", True, untried, ()), options)
    failed = [name for name, test in line["tests"].items() if test["failed"]]
    if failed:
        raise BadInput(f"{', '.join(failed)}: fails without a fault: {line['tests'][failed[0]]['sentence']}")
    green.update(untried)


def what_is_run(options):
    return f"all of {options.suite}" if options.suite else "the tests that each fault names"


def revision():
    """Of the sources, but for those that no trial is made from."""
    described = run(["git", "-C", ROOT, "describe", "--always"]).stdout.strip()
    changed = run(["git", "-C", ROOT, "status", "--porcelain", "--", ".", ":!*.md",
                   *(f":!{folder}" for folder in UNREAD)]).stdout.strip()
    return described + ("-dirty" if changed else "")


def own_digest(fault):
    return digest(fault.text, *fault.tests)


def write(lines, faults, file, options):
    """The faults in their order, with what is known today of why one survives."""
    of_name = {line["fault"]: line for line in lines}
    rows = [of_name[fault.name] | {"why": fault.why} for fault in faults if fault.name in of_name]
    matrix.write(rows, file, {"title": "What came of each seeded fault, test by test", "machine": matrix.machine(),
                              "tests": what_is_run(options), "untried": len(faults) - len(rows)})
    return rows


class LastTrials:
    """What the project keeps: of each of today's faults the last trial, whenever it was made."""

    def __init__(self, options):
        self.faults, self.options = seeded.read_all(FOLDER), options
        provenance, lines = matrix.read(KEPT) if KEPT.is_file() else ({}, [])
        if provenance.get("tests") != what_is_run(options):
            lines = []
        today = {fault.name: own_digest(fault) for fault in self.faults}
        self.lines = {line["fault"]: line for line in lines if today.get(line["fault"]) == line["digest"]}

    def tried_at(self, fault):
        return self.lines[fault.name]["finished_at"] if fault.name in self.lines else ""

    def renew(self, lines):
        self.lines |= {line["fault"]: line for line in lines}
        if self.options.keep:
            write(self.lines.values(), self.faults, KEPT, self.options)


def try_all(faults, options):
    """Tries those first that were never tried, then those that were tried longest ago."""
    for fault in faults:
        require_locale(fault)
    began = time.monotonic()
    scratch, last = Scratch(options.scratch.resolve(), options.jobs), LastTrials(options)
    results = read_results(options.results)
    keys = {fault.name: digest(scratch.digest, own_digest(fault), options.suite or "") for fault in faults}

    def keep(line):
        with open(options.results, "a", encoding="utf-8") as file:
            file.write(json.dumps(line, ensure_ascii=False) + "\n")
        return line

    green, known = set(), {line["key"]: line for line in results}
    lines = [known[key] for key in keys.values() if key in known]
    fresh = [fault for fault in faults if keys[fault.name] not in known]
    fresh.sort(key=lambda fault: (last.tried_at(fault), fault.tests))  # one after the other what the same tests notice
    for k, fault in enumerate(fresh):
        if time.monotonic() - began > 60 * options.minutes:
            print(f"{len(fresh) - k} of {len(fresh)} left: the same command goes on with them")
            break
        require_green(scratch, ("all",) if options.suite else fault.tests, options, green)
        provenance = {"key": keys[fault.name], "digest": own_digest(fault), "revision": revision()}
        lines.append(keep(tried(scratch, fault, options) | provenance))
        last.renew(lines)
        print(f"{k + 1}/{len(fresh)} {fault.name}: {lines[-1]['conclusion']}{matrix.by_whom(lines[-1])}, "
              f"{lines[-1]['seconds']} s", flush=True)
    last.renew(lines)
    rows = write(lines, faults, options.results.with_suffix(".csv"), options)
    print(matrix.summary(rows))
    return 1 if any(line["conclusion"] in matrix.BAD for line in rows) else 0


def options_of(arguments):
    parser = Parser(__doc__)
    parser.add_argument("--check", action="store_true", help="only check that faults fit today's sources and tests")
    parser.add_argument("--list", action="store_true", help="only list names and titles")
    parser.add_argument("--build", type=pathlib.Path, help="with --check: a whole build, to look up names of tests")
    parser.add_argument("--only", default="", help="regular expression found in a fault's name, MODULE/NAME or title")
    parser.add_argument("--tests", default="", help="regular expression found in a name: of the named tests only these")
    parser.add_argument("--suite", choices=SUITES, help="build and run all of a suite, not only the named tests")
    parser.add_argument("--scratch", type=pathlib.Path, default=ROOT / "build-faults", help="folder of copy and builds")
    parser.add_argument("--results", type=pathlib.Path, help="lines of JSON; a table, .csv, stands beside")
    parser.add_argument("--keep", action="store_true", help="keep what they came to in vnv/trials/faults/trials.csv")
    parser.add_argument("--minutes", type=float, default=math.inf, help="begin no further trial after so long")
    parser.add_argument("--jobs", type=int, default=os.cpu_count(), help="at once, of compiler and of ctest")
    parser.add_argument("--timeout", type=int, default=900, help="of a test [s]")
    options = parser.parse_args(arguments)
    options.results = options.results or options.scratch / "results.jsonl"
    if options.keep and options.tests:
        raise BadInput("--keep: with --tests, expected a trial of all tests that a fault names")
    return options


def chosen(faults, only, tests):
    """The faults that fit, each with those of its tests that fit; one without any is left out."""
    for option, value in (("--only", only), ("--tests", tests)):
        seeded.require_pattern(option, value)
    found = []
    for fault in faults:
        named = tuple(test for test in fault.tests if re.search(tests, test))
        if named and any(re.search(only, text) for text in (fault.name, fault.title, f"{fault.folder}/{fault.name}")):
            found.append(dataclasses.replace(fault, tests=named))
    if not found:
        raise BadInput(f"--only '{only}' --tests '{tests}': fits no fault, expected one of vnv/trials/faults")
    return found


def main(arguments):
    options = options_of(arguments)
    if options.check:
        found = seeded.complaints(FOLDER, ROOT, options.build and options.build.resolve())
        print("\n".join(found) if found else "each fault fits today's sources and tests")
        return 3 if found else 0
    faults = chosen(seeded.read_all(FOLDER), options.only, options.tests)
    if options.list:
        print("\n".join(f"{fault.folder}/{fault.name}: {fault.title}" for fault in faults))
        return 0
    return try_all(faults, options)


if __name__ == "__main__":
    exit_with(main)
