#!/usr/bin/env python3
"""Trials of verdicts: is a claim that holds seen to fail wherever its value would?

Each claim that holds in the records of a suite is mutated, one at a time. The program of its case judges the values of the
record anew, with the one that the claim reads just beyond its limit, not a number, missing, that of another level, or
never measured (CASE --mutate). The report reads the record with the verdict changed in all ways that it could be wrong,
and puts it on an index (touchstone_verdict_mutation). A few mutations are made for real: programs end with status 1, and
the index is red. Exit status: 0 all were seen; 1 one survived; 3 bad input.

With --samples each method of the records is run anew, and a field of its particles is scaled before anything is measured
(CASE --mutate-samples); the index of a record that fails so is red. Claims that no field moves, such as on cost, are named.

Examples: vnv/trials/verdicts/try.py build --records build/records/nightly
          vnv/trials/verdicts/try.py build --samples
"""

import collections
import concurrent.futures
import csv
import json
import math
import os
import pathlib
import re
import shutil
import sys
import tempfile
import time

FOLDER = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(FOLDER.parent))

from shared import BadInput, Parser, built, exit_with, run  # noqa: E402

ROOT = FOLDER.parents[2]
INDEX = pathlib.Path("reports", "touchstone_verdict_mutation")


def mutated(options, case, expected, *words):
    """What the program of a case says of the claims that it mutates."""
    done = run([options.build / "vnv" / case, "--data", options.data, *words])
    if done.returncode not in (0, 1) or not re.search(expected, done.stdout, re.MULTILINE):
        raise BadInput(f"{case} {' '.join(map(str, words))}: {(done.stdout.strip().splitlines() or ['said nothing'])[-1]}")
    return done.stdout


def try_values(options, records, cases):
    """Claims that hold, and {mutation: [seen, tried]}."""
    claims, counts, survivors = 0, collections.defaultdict(lambda: [0, 0]), []
    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        for output in pool.map(lambda case: mutated(options, case, " claims hold:", "--mutate", records), cases):
            survivors += [line for line in output.splitlines() if line.startswith("SURVIVED")]
            for line in re.findall(r"^[\w.]+: (\d+ claims hold:.*)$", output, re.MULTILINE):
                claims += int(line.split()[0])
                for mutation, seen, tried in re.findall(r"(\w+) (\d+)/(\d+)", line):
                    counts[mutation][0] += int(seen)
                    counts[mutation][1] += int(tried)
    return claims, counts, survivors


def beyond(verdict):
    value, lower, upper = (verdict[key] if verdict[key] is None else float(verdict[key])
                           for key in ("value", "lower", "upper"))
    above = lower is None or (upper is not None and upper - value <= value - lower)
    return math.nextafter(upper, math.inf) if above else math.nextafter(lower, -math.inf)


def report_on(options, folder):
    """Exit status of the report on these records, and its index."""
    some = {name: value for name, value in os.environ.items() if name != "TOUCHSTONE_WHOLE_SUITE"}  # it is one record
    done = run([options.build / "reports" / "touchstone_report", folder, folder / "site", "--claims", options.data / "claims"], env=some)
    index = folder / "site" / "index.html"
    if not index.is_file():
        raise BadInput(f"touchstone_report {folder}: {done.stdout.strip().splitlines()[-1]}")
    return done.returncode, index.read_text(encoding="utf-8")


def is_red_for_real(options, file, folder):
    """Whether the pages of a record are green, and red with its last value that holds beyond its limit."""
    folder.mkdir()
    shutil.copy(file, folder)
    before, index = report_on(options, folder)
    record = json.loads(file.read_text(encoding="utf-8"))
    verdict = next(v for v in reversed(record["verdicts"]) if v["outcome"] == "holds")
    verdict["value"] = beyond(verdict)
    (folder / file.name).write_text(json.dumps(record), encoding="utf-8")
    after, mutated = report_on(options, folder)
    return (before == 0 and 'class="sum holds"' in index and after == 1 and 'class="sum fails"' in mutated
            and "inconsistent record" in mutated)


def fails_for_real(options, name, folder):
    """Whether a method's program passes, and fails where one accepted value is another."""
    case, method = name.split(".")
    call = [options.build / "vnv" / case, "--method", method, "--data", folder / "data"]
    shutil.copytree(options.data, folder / "data")
    before = run(call).returncode
    table = folder / "data" / "baselines" / f"{case}.csv"
    rows = list(csv.reader(table.read_text(encoding="utf-8").splitlines()))
    row = next(row for row in rows if row[0] == method)  # method, level, time, quantity, value, lower, upper, basis
    row[4:7] = [repr(2 * float(row[6]) - float(row[4]) + 1e-9)] * 3  # as far beyond the upper limit as that is above
    with table.open("w", encoding="utf-8", newline="") as file:
        csv.writer(file, lineterminator="\n").writerows(rows)
    done = run(call)
    return before == 0 and done.returncode == 1 and ": FAILS" in done.stdout


def try_for_real(options, files):
    """Whether each that was tried was red."""
    if options.for_real == 0:
        return []
    with tempfile.TemporaryDirectory(prefix="verdicts.") as scratch:
        some = files[:: max(1, math.ceil(len(files) / options.for_real))]
        red = [is_red_for_real(options, file, pathlib.Path(scratch) / file.stem) for file in some]
        cheapest = min(files, key=lambda file: sum(r["cost"]["wall"] for r in json.loads(file.read_text())["runs"])).stem
        case, method = cheapest.split(".")
        baselines = options.data / "baselines" / f"{case}.csv"
        if baselines.is_file() and f"\n{method}," in baselines.read_text(encoding="utf-8"):
            red.append(fails_for_real(options, cheapest, pathlib.Path(scratch) / "program"))
    return red


def mutate_samples(options, folder, name):
    """Claims that hold of a method, those that fail by some field of its samples, the others, whether the index is red, and
    the seconds spent on this after the runs."""
    case, method = name.split(".")
    records = folder / name
    records.mkdir()
    told = r"^[\w.]+: (\d+) claims hold: beyond (\d+)/\d+.*; mutated for ([\d.]+) s$"
    said = mutated(options, case, told, "--method", method, "--mutate-samples", "--records", records)
    claims, seen, seconds = re.search(told, said, re.MULTILINE).groups()
    survivors = [line for line in said.splitlines() if line.startswith("SURVIVED")]
    is_red = int(seen) == 0 or report_on(options, records)[0] == 1
    return int(claims), int(seen), survivors, is_red, float(seconds)


def try_samples(options):
    """Exit status: all claims that samples can move are seen, and each index is red."""
    began, names = time.monotonic(), sorted(file.stem for file in options.records.glob("*.json"))[:: options.every]
    if not names:
        raise BadInput(f"{options.records}: no records in it, expected *.json")
    with tempfile.TemporaryDirectory(prefix="samples.") as scratch, concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        results = list(pool.map(lambda name: mutate_samples(options, pathlib.Path(scratch), name), names))
    claims, seen, red, seconds = (sum(result[k] for result in results) for k in (0, 1, 3, 4))
    print("\n".join(line for result in results for line in result[2]))
    print(f"{claims} claims of {len(names)} methods, {seen} made to fail from samples; {red} of {len(names)} indexes as they "
          f"should be; {time.monotonic() - began:.0f} s, of which the programs mutated for {seconds / options.jobs:.0f} s and ran solvers else")
    return 0 if seen == claims and red == len(names) else 1


def options_of(arguments):
    parser = Parser(__doc__)
    parser.take_build()
    parser.add_argument("--records", type=pathlib.Path, help="folder of records; default: BUILD/records/acceptance")
    parser.add_argument("--data", type=pathlib.Path, default=ROOT / "data", help="whose baselines and accepted claims")
    parser.add_argument("--every", type=int, default=1, help="one record of so many, as the test of the day does")
    parser.add_argument("--after-suite", action="store_true", help="only where TOUCHSTONE_WHOLE_SUITE says that all of a suite was run")
    parser.add_argument("--samples", action="store_true", help="mutate the samples of each method instead of its record")
    parser.add_argument("--for-real", type=int, default=3, help="so many records at most are mutated for real")
    parser.add_argument("--jobs", type=int, default=2, help="programs at once")
    options = parser.parse_args(arguments)
    options.records = (options.records or options.build / "records" / "acceptance").resolve()
    return options


def main(arguments):
    options = options_of(arguments)
    if options.samples:
        return try_samples(options)
    if options.after_suite and not os.environ.get("TOUCHSTONE_WHOLE_SUITE"):
        print("SKIP: not the whole suite was run")  # whoever runs one test does not wait for this
        return 0
    built(options.build, INDEX)
    chosen = sorted(options.records.glob("*.json"))[::options.every]
    with tempfile.TemporaryDirectory(prefix="records.") as folder:
        for file in chosen if options.every > 1 else []:
            shutil.copy(file, folder)
        return mutate_all(options, pathlib.Path(folder) if options.every > 1 else options.records)


def mutate_all(options, records):
    began, files = time.monotonic(), sorted(records.glob("*.json"))
    cases = sorted({file.stem.split(".")[0] for file in files})
    if not files:
        raise BadInput(f"{options.records}: no records in it, expected *.json")
    index = [options.build / INDEX, records, "--claims", options.data / "claims"]
    with concurrent.futures.ThreadPoolExecutor(1) as pool:
        shown = pool.submit(run, index)
        claims, counts, survivors = try_values(options, records, cases)
        shown = shown.result()
    print("\n".join(survivors + shown.stdout.splitlines()))
    for mutation, (seen, tried) in counts.items():
        print(f"{mutation}: {seen} of {tried} seen by the programs")
    real = try_for_real(options, files)
    on_index = re.search(r"^value: (\d+) seen", shown.stdout, re.MULTILINE)
    print(f"{claims} claims that hold, {counts['beyond'][0]} made to fail, {on_index[1] if on_index else 'none'} seen by "
          f"the index; {sum(real)} of {len(real)} for real; {time.monotonic() - began:.0f} s")
    is_seen = all(seen == tried for seen, tried in counts.values()) and counts["beyond"][1] == claims > 0
    return 0 if is_seen and shown.returncode == 0 and all(real) else 1


if __name__ == "__main__":
    exit_with(main)
