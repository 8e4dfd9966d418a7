#!/usr/bin/env python3
"""Trials of the gate: does it see a loss that is planted, and does it cry wolf where nothing has changed?

A planted loss is a file *.fault here, as in vnv/trials/faults, noticed by rows of the gate, KIND CASE.METHOD. It is made in a
copy of the sources; unchanged and changed programs are gated, and the row has to be worse. With --self a build is
gated against itself, every program run as if it differed. Exit status: 0 all losses were seen and one alarm in a
hundred at most; 1 if not; 3 bad input.

Example: vnv/trials/losses/try.py --self 100 --build build --only 'stokes|couette.mpm'
"""

import json
import os
import pathlib
import re
import sys
import time

FOLDER = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(FOLDER.parent / "faults"))

import seeded  # noqa: E402
from scratch import ROOT, Scratch  # noqa: E402
from shared import BadInput, Parser, built, exit_with, run  # noqa: E402

CONCLUSIONS = ("same or better", "worse", "inconclusive")


def gate(vnv, before, after, output, arguments):
    """Exit status and what was found."""
    output.unlink(missing_ok=True)
    done = run([vnv, "gate", before, after, "--json", output, *arguments])
    if done.returncode not in (0, 1, 2):
        raise BadInput(f"vnv gate {before} {after}: {done.stdout.strip().splitlines()[-1]}")
    return done.returncode, json.loads(output.read_text(encoding="utf-8"))["differences"]


def row_of(difference):
    return f"{difference['kind']} {difference['case']}.{difference['method']}"


def sentence_of(difference):
    level = f" {difference['level']}" if difference["level"] else ""
    return f"{row_of(difference)}{level}: {difference['quantity']} {difference['change']}, {difference['why']}"


def try_loss(loss, scratch, vnv):
    """Whether the gate names the row."""
    cases = sorted({re.split("[ .]", row)[1] for row in loss.tests})
    builds = [scratch.builds / name for name in ("build", "build-changed")]
    for build in builds:
        scratch.configure(build)
    said = scratch.make(builds[0], cases)
    with scratch.with_change(loss):
        said = said or scratch.make(builds[1], cases)
    if said:
        raise BadInput(f"{loss.name}: cannot be built: {said}")
    methods = "|".join(re.escape(row.split(" ")[1]) for row in loss.tests)
    arguments = [word for case in cases for word in ("--case", case)] + ["--only", f"^({methods})$"]
    status, found = gate(vnv, *builds, scratch.builds / "gate.json", arguments)
    worse = [difference for difference in found if difference["change"] == "worse"]
    rows = {row_of(difference) for difference in worse}
    is_seen = status == 1 and set(loss.tests) <= rows
    print(f"{'seen' if is_seen else 'MISSED'} {loss.name}: {loss.title}", flush=True)
    for difference in worse or found:
        print(f"    {sentence_of(difference)}")
    return is_seen


def read_losses():
    return [seeded.read(file) for file in sorted(FOLDER.glob("*.fault"))]


def try_losses(options):
    losses = [loss for loss in read_losses() if re.search(options.only, loss.name)]
    if not losses:
        raise BadInput(f"--only '{options.only}': fits no loss, expected one of {FOLDER}")
    scratch = Scratch(options.scratch.resolve(), options.jobs)
    seen = [try_loss(loss, scratch, options.build / "vnv" / "vnv") for loss in losses]
    print(f"{len(seen)} planted losses, {sum(seen)} seen")
    return 0 if all(seen) else 1


def try_itself(options):
    options.scratch.mkdir(parents=True, exist_ok=True)
    counts, began = dict.fromkeys(CONCLUSIONS, 0), time.monotonic()
    for k in range(options.self):
        status, found = gate(options.build / "vnv" / "vnv", options.build, options.build,
                             options.scratch / "self.json", ["--all", "--only", options.only])
        counts[CONCLUSIONS[status]] += 1
        changes = [sentence_of(difference) for difference in found if difference["change"] in CONCLUSIONS[1:]]
        print(f"{k + 1}/{options.self} {CONCLUSIONS[status]}" + "".join(f"\n    {words}" for words in changes), flush=True)
    rows = sum(difference["change"] != "unjudged" for difference in found)
    print(f"{options.self} gates of a build against itself, {rows} rows each, "
          f"{(time.monotonic() - began) / options.self:.0f} s each: "
          + ", ".join(f"{count} {conclusion}" for conclusion, count in counts.items()))
    return 0 if 100 * counts["worse"] <= options.self else 1


def options_of(arguments):
    parser = Parser(__doc__)
    parser.add_argument("--check", action="store_true", help="only check that the losses fit today's sources")
    parser.add_argument("--self", type=int, default=0, help="gate the build against itself so many times")
    parser.add_argument("--build", type=pathlib.Path, default=ROOT / "build", help="whose vnv is tried")
    parser.add_argument("--only", default="", help="regular expression of losses, or with --self of CASE.METHOD")
    parser.add_argument("--scratch", type=pathlib.Path, default=ROOT / "build-faults" / "gate",
                        help="folder of copy and builds")
    parser.add_argument("--jobs", type=int, default=os.cpu_count(), help="at once, of the compiler")
    options = parser.parse_args(arguments)
    if not options.check:
        built(options.build, "vnv/vnv")
    seeded.require_pattern("--only", options.only)
    return options


def main(arguments):
    options = options_of(arguments)
    if options.check:
        for loss in read_losses():
            seeded.changed(loss, ROOT)
        print("each planted loss fits today's sources")
        return 0
    return try_itself(options) if options.self > 0 else try_losses(options)


if __name__ == "__main__":
    exit_with(main)
