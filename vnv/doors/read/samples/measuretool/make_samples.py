#!/usr/bin/env python3
"""Writes the sample of MeasureTool: three places at two times, in the layout of DualSPHysics' tables."""

import pathlib

PLACES = [(0.25, 0, 0.1), (0.25, 0, 0.3), (0.25, 0, 0.5)]
TIMES = [(0, 0.5, (1.5, 2.5, -3.5)), (1, 1, (1.25, 2.25, -3.25))]

with open(pathlib.Path(__file__).parent / "line_Vel.csv", "w", encoding="ascii") as file:
    for axis, name in enumerate("XYZ"):
        file.write(f" ;Pos{name} [m]:;" + ";".join(str(place[axis]) for place in PLACES) + "\n")
    file.write("Part;Time [s];" + ";".join(f"Vel_{k}.{axis} [m/s]" for k in range(len(PLACES)) for axis in "xyz") + "\n")
    for part, time, speeds in TIMES:
        file.write(f"{part};{time};" + ";".join(f"{speed};0;0" for speed in speeds) + "\n")
