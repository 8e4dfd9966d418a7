#!/usr/bin/env python3
"""Writes the samples of XYZ: two frames in the extended layout, as ASE and OVITO have it, and one plain frame."""

import pathlib

HERE = pathlib.Path(__file__).parent
LATTICE = 'Lattice="0.5 0 0 0 1 0 0 0 1"'
FRAMES = [(0.5, [("fluid", 0.1, 0.2, 0, 1.5, -0.5, 0, "T"), ("wall", 0.3, 0, 0, 0, 0, 0, "F")]),
          (1, [("fluid", 0.15, 0.25, 0, 1.25, -0.25, 0, "T"), ("wall", 0.3, 0, 0, 0, 0, 0, "F")])]

with open(HERE / "extended.xyz", "w", encoding="ascii") as file:
    for time, rows in FRAMES:
        file.write(f"{len(rows)}\n{LATTICE} Properties=species:S:1:pos:R:3:velo:R:3:moves:L:1 Time={time}\n")
        file.writelines(" ".join(map(str, row)) + "\n" for row in rows)
(HERE / "plain_12.xyz").write_text("2\n step 12\nAr 0.1 0.2 0 1.5\nAr 0.3 0.4 0 2.5\n", encoding="ascii")
