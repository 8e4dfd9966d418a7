#!/usr/bin/env python3
"""Writes the samples of this folder: the same particles as numpy and Python's csv write tables; run as `make_samples.py FOLDER`.

What the values are stands here and again in the tests.
"""

import csv
import pathlib
import sys

import numpy

ROWS = numpy.array([[0.1 * k, 1 / (k + 1), k / 3, -k / 7, 0.25 * (k // 3)] for k in range(5)])
NAMES = ["x [mm]", "y [mm]", "v_x [mm/s]", "v_y [mm/s]", "time"]


def main(folder):
    folder = pathlib.Path(folder)
    numpy.savetxt(folder / "blanks.txt", ROWS, header=" ".join(NAMES))
    numpy.savetxt(folder / "commas.csv", ROWS, delimiter=",", header="made by hand\n\n" + ",".join(NAMES))
    numpy.savetxt(folder / "nameless.txt", ROWS[:, :4], fmt="%.17g")
    for name, dialect in {"quoted.csv": dict(quoting=csv.QUOTE_NONNUMERIC, delimiter=";"), "tabs.tsv": dict(delimiter="\t")}.items():
        with open(folder / name, "w", newline="", encoding="utf-8") as file:
            csv.writer(file, **dialect).writerows([NAMES, *ROWS.tolist()])
    (folder / "mark_alone.txt").write_text("# ")  # which a fuzzer found


main(sys.argv[1])
