#!/usr/bin/env python3
"""Writes the samples of lines as OpenFOAM's function object `sets` has them with setFormat raw: by a distance, and by all coordinates."""

import pathlib

HERE = pathlib.Path(__file__).parent
ROWS = [(0.25, 0.1, 3.5, 1.5, -0.5), (0.25, 0.3, 2.5, 2.5, 0.25), (0.25, 0.5, 1.5, -3.5, 0.125)]
(HERE / "line_U.xy").write_text("".join(f"{y} \t{u} {v} 0\n" for _, y, _, u, v in ROWS), encoding="ascii")
(HERE / "line_p_U.xy").write_text("".join(f"{x} {y} 0 \t{p} \t{u} {v} 0\n" for x, y, p, u, v in ROWS), encoding="ascii")
