#!/usr/bin/env python3
"""Mutation testing: how many of the mistakes that nobody thought of does a test notice?

Samples places in the sources by a seed, as many a module as --sample says, changes one at a time in a copy (an operator,
a constant, a relation, a dropped statement: sites.py), builds the smallest program of tests that it is compiled into,
then the next, and stops at the first test that fails. What does not compile is no mutant and another is drawn. A
mutant that all near tests pass survives; it is read by a person, and is either equivalent, and equivalent.csv says why, or
needs a test. Exit status: 0 at least --least of the others are noticed in each module; 1 if not; 3 bad input.

Example: vnv/trials/mutants/try.py --scratch ~/mutants --keep --minutes 60
"""

import concurrent.futures
import csv
import itertools
import json
import math
import os
import pathlib
import random
import sys
import threading
import time

FOLDER = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(FOLDER.parent / "faults"))

import seeded  # noqa: E402
import sites  # noqa: E402
from scratch import ROOT, Scratch, digest, empty_records  # noqa: E402
from shared import BadInput, Parser, exit_with  # noqa: E402

from nearest import CALLED_BY_NO_TEST, Nearest  # noqa: E402

KEPT, EQUIVALENT = FOLDER / "trials.csv", FOLDER / "equivalent.csv"
SAMPLE = {"solvers/mpm": 50, "solvers/sph": 50, "solvers": 30, "reference": 40, "vnv/judge": 40, "vnv/measures": 40, "vnv/doors": 40,
          "vnv/flows": 40, "vnv/gate": 40, "vnv": 40, "reports": 40}
CASES = ("cavity", "couette", "dam_break", "dam_break_buchner", "elliptic_drop", "hydrostatic", "manufactured", "oscillating_poiseuille",
         "poiseuille", "rotating_patch", "shear_wave", "standing_wave", "stokes_first", "taylor_green")
NOTICED, SURVIVES, EQUAL, INVALID, UNTESTED = "noticed", "survives", "equivalent", "does not compile", "in no near program"
COLUMNS = ("module", "file", "line", "code", "becomes", "kind", "conclusion", "noticed by or why", "seconds [s]", "digest")


def module_of(file):
    """The most special module that a file belongs to, or nothing."""
    return max((module for module in SAMPLE if file.startswith(module + "/")), key=len, default=None)


def is_mutated(path):
    is_of_program = CALLED_BY_NO_TEST.match(str(path.parent)) or path.name == "main.cpp"
    return path.suffix in (".cpp", ".hpp") and "test" not in path.name and not is_of_program


def all_sites(root):
    found = {module: [] for module in SAMPLE}
    for top in sorted({module.split("/")[0] for module in SAMPLE}):
        for path in sorted((root / top).rglob("*")):
            file = str(path.relative_to(root))
            if is_mutated(pathlib.PurePath(file)) and (module := module_of(file)):
                found[module] += sites.sites(file, path.read_text(encoding="utf-8"))
    return found


def key_of(site):
    """The same for the same change of the same line, wherever it stands in the file."""
    return digest(site.file, site.line, site.becomes)


def read_equivalent():
    """Why a mutant cannot be noticed, by file, line of code and what becomes of it."""
    with open(EQUIVALENT, newline="", encoding="utf-8") as file:
        rows = list(csv.DictReader(line for line in file if not line.startswith("#")))
    for row in rows:
        if set(row) != {"file", "code", "becomes", "why"} or not all(row[column] for column in ("file", "code", "why")):
            raise BadInput(f"{EQUIVALENT}: {row}, expected file,code,becomes,why")
    return {digest(row["file"], row["code"], row["becomes"]): row["why"] for row in rows}


def wilson(count, of):
    """The 95 % interval of a share (Wilson 1927)."""
    z, p = 1.959964, count / of
    middle, half = p + z * z / (2 * of), z * math.sqrt(p * (1 - p) / of + z * z / (4 * of * of))
    return (middle - half) / (1 + z * z / of), (middle + half) / (1 + z * z / of)


class Worker:
    """A copy of the sources with a complete build, in which one mutant at a time is tried."""

    def __init__(self, folder, options):
        self.scratch, self.options = Scratch(folder, 1), options
        self.build = folder / "build"

    def prepare(self):
        self.scratch.configure(self.build)
        self.scratch.jobs = os.cpu_count()
        if said := self.scratch.compile(self.build, [*(f"{room}_unit" for room in seeded.TOPS), *CASES]):
            raise BadInput(f"{self.build}: {said}")
        self.scratch.jobs = 1
        empty_records(self.build)
        self.nearest = Nearest(self.scratch.source, self.build, CASES)
        if without := self.nearest.folders_without():
            raise BadInput(f"{', '.join(without)}: compiled into no program of tests, expected one at least")
        self.nearest.measure(self.options.timeout)

    def tried(self, change):
        """Conclusion, and the test that noticed."""
        began, programs = time.monotonic(), self.nearest.of(change.changes[0].file)
        if not programs:
            return UNTESTED, "compiled into none of the programs"
        with self.scratch.with_change(change):
            for program in programs:
                if said := self.scratch.compile(self.build, [program.path]):
                    return (NOTICED, f"the build: {said}") if "static assertion" in said else (INVALID, said)
                failed, _ = self.nearest.failing_test(program, self.options.timeout)
                if failed:
                    return NOTICED, failed
                if time.monotonic() - began > self.options.seconds:
                    return SURVIVES, f"passed up to {program.name}"
        return SURVIVES, "passed all near tests"


def row_of(site, conclusion, by, seconds):
    return dict(zip(COLUMNS, (module_of(site.file), site.file, site.number, site.line, site.becomes, site.kind, conclusion, by,
                              round(seconds), key_of(site))))


def read_rows(file):
    if not file.is_file():
        return []
    with open(file, newline="", encoding="utf-8") as opened:
        return list(csv.DictReader(opened))


def write(rows, file):
    new = file.with_name(file.name + ".new")
    with open(new, "w", newline="", encoding="utf-8") as out:
        table = csv.DictWriter(out, COLUMNS, lineterminator="\n")
        table.writeheader()
        table.writerows(sorted(rows, key=lambda row: (row["module"], row["file"], int(row["line"]), row["becomes"])))
    os.replace(new, file)


def in_turn(lists):
    """One of each list, then another of each: of work that is cut off each has had its share."""
    return [one for turn in itertools.zip_longest(*lists) for one in turn if one is not None]


def summary(rows, least):
    """A line a module, and whether enough were noticed everywhere."""
    print(f"{'module':14} {'mutants':>7} {'equivalent':>10} {'noticed':>14}  95 % interval")
    enough = True
    for module in [*SAMPLE, ""]:
        of_module = [row for row in rows if row["module"] == module or not module]
        judged = [row for row in of_module if row["conclusion"] in (NOTICED, SURVIVES)]
        if not judged:
            continue
        noticed = sum(row["conclusion"] == NOTICED for row in judged)
        low, high = wilson(noticed, len(judged))
        print(f"{module or 'all':14} {len(judged):7} {sum(row['conclusion'] == EQUAL for row in of_module):10} "
              f"{noticed:4} ({100 * noticed / len(judged):5.1f} %)  {100 * low:.1f} to {100 * high:.1f} %")
        enough &= noticed >= least / 100 * len(judged)
    return enough


class Trials:
    """What is known of each mutant, kept in a file, so that a run that was cut off goes on."""

    def __init__(self, options):
        self.options, self.lock, self.began = options, threading.Lock(), time.monotonic()
        self.rows = {row["digest"]: row for row in read_rows(options.results) if not (options.survivors and row["conclusion"] == SURVIVES)}
        self.equivalent = read_equivalent()
        self.drawn = all_sites(ROOT)
        for module, found in self.drawn.items():
            random.Random(f"{options.seed} {module}").shuffle(found)

    def row(self, site):
        why = self.equivalent.get(key_of(site))
        return row_of(site, EQUAL, why, 0) if why else self.rows.get(key_of(site))

    def sample(self):
        """The rows of the sample as far as they are known, and the sites that are still to be tried, of all modules in turn."""
        rows, fresh = [], {module: [] for module in SAMPLE}
        for module, count in SAMPLE.items():
            left = math.ceil(self.options.fraction * count) if module.startswith(self.options.only) else 0
            for site in self.drawn[module]:
                row = self.row(site)
                if left == 0:
                    break
                if row is None:
                    fresh[module].append(site)
                elif row["conclusion"] in (INVALID, UNTESTED):
                    continue
                else:
                    rows.append(row)
                left -= 1
        return rows, in_turn(fresh.values())

    def keep(self, row):
        with self.lock:
            self.rows[row["digest"]] = row
            write(self.rows.values(), self.options.results)
            print(f"{row['conclusion']}: {row['file']}:{row['line']}: {row['code']}  ->  {row['becomes'] or '(dropped)'}  "
                  f"[{row['noticed by or why']}, {row['seconds [s]']} s]", flush=True)

    def try_all(self, workers, sites_to_try):
        """Each worker takes the next; none is begun when the time is over."""
        waiting = iter(sites_to_try)

        def work(worker):
            while time.monotonic() - self.began < 60 * self.options.minutes:
                with self.lock:
                    site = next(waiting, None)
                if site is None:
                    return
                at = time.monotonic()
                conclusion, by = worker.tried(site.as_fault(worker.scratch.source))
                self.keep(row_of(site, conclusion, by, time.monotonic() - at))

        with concurrent.futures.ThreadPoolExecutor(len(workers)) as pool:
            for done in [pool.submit(work, worker) for worker in workers]:
                done.result()


def try_sample(options):
    """The rows of the sample; what does not compile is replaced by another until the sample is full."""
    trials = Trials(options)
    rows, fresh = trials.sample()
    if fresh and options.minutes > 0:
        workers = [Worker(options.scratch.resolve() / str(k), options) for k in range(options.workers)]
        for worker in workers:
            worker.prepare()
        while fresh and time.monotonic() - trials.began < 60 * options.minutes:
            trials.try_all(workers, fresh)
            rows, fresh = trials.sample()
    if fresh:
        print(f"{len(fresh)} of {len(rows) + len(fresh)} left: the same command goes on with them")
    if options.keep:
        kept = {row["digest"]: row for row in [*rows, *read_rows(KEPT)]}  # what came of other seeds stays
        write((kept | {row["digest"]: row for row in rows}).values(), KEPT)
    return rows


def faults_to_try(folder):
    """Those of a folder, each of which fits today's sources, before anything is built."""
    faults = [seeded.read(file, needs_tests=False) for file in sorted(folder.glob("*.fault"))]
    if not faults:
        raise BadInput(f"{folder}: no fault in it, expected *.fault")
    for fault in faults:
        seeded.changed(fault, ROOT)
    return faults


def try_faults(options):
    """Seeded faults of which nobody has said who notices; whether all were noticed."""
    began, faults, results = time.monotonic(), faults_to_try(options.faults), options.scratch / "faults.json"
    known = json.loads(results.read_text(encoding="utf-8")) if results.is_file() else {}
    is_left = lambda fault: known.get(digest(fault.text), [SURVIVES])[0] != NOTICED if options.survivors else digest(fault.text) not in known
    left = [fault for fault in faults if is_left(fault)]
    if left and options.minutes > 0:
        worker = Worker(options.scratch.resolve() / "0", options)
        worker.prepare()
        while left and time.monotonic() - began < 60 * options.minutes:
            fault = left.pop(0)
            known[digest(fault.text)] = conclusion, by = worker.tried(fault)
            results.write_text(json.dumps(known), encoding="utf-8")
            print(f"{conclusion}: {fault.name}: {fault.title}  [{by}]", flush=True)
    if left:
        print(f"{len(left)} of {len(faults)} left: the same command goes on with them")
    conclusions = [known.get(digest(fault.text), [SURVIVES])[0] for fault in faults]
    print(f"{conclusions.count(NOTICED)} of {len(faults) - len(left)} noticed")
    return conclusions.count(NOTICED) == len(faults)


def options_of(arguments):
    parser = Parser(__doc__)
    parser.add_argument("--scratch", type=pathlib.Path, default=ROOT / "build-mutants", help="folder of the copies and their builds")
    parser.add_argument("--only", default="", help="modules that begin so")
    parser.add_argument("--seed", type=int, default=1, help="of the sample")
    parser.add_argument("--fraction", type=float, default=1, help="of the sample of each module: " + str(SAMPLE))
    parser.add_argument("--survivors", action="store_true", help="try those again that survived, as after a new test")
    parser.add_argument("--faults", type=pathlib.Path, help="try the seeded faults of this folder instead, by the tests nearest to each")
    parser.add_argument("--least", type=float, default=90, help="of each module's mutants that are to be noticed [%%]")
    parser.add_argument("--keep", action="store_true", help="write vnv/trials/mutants/trials.csv")
    parser.add_argument("--minutes", type=float, default=math.inf, help="begin no further trial after so long; 0: only report")
    parser.add_argument("--seconds", type=float, default=200, help="build no further program for a mutant after so long")
    parser.add_argument("--workers", type=int, default=os.cpu_count(), help="mutants at once")
    parser.add_argument("--timeout", type=int, default=60, help="of a program of unit tests, and of a test of a case [s]")
    options = parser.parse_args(arguments)
    options.results = options.scratch / "results.csv"
    return options


def main(arguments):
    options = options_of(arguments)
    if options.faults:
        return 0 if try_faults(options) else 1
    return 0 if summary(try_sample(options), options.least) else 1


if __name__ == "__main__":
    exit_with(main)
