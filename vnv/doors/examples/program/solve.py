# SPDX-License-Identifier: MIT
"""Stokes' first problem by finite differences, as a program that reads what it is to compute: solve.py SCENE TIME"""

import json
import sys

scene = json.load(open(sys.argv[1], encoding="utf-8"))
time = float(sys.argv[2])
dy = scene["spacing [m]"]
nu = scene["fluid"]["viscosity [Pa s]"] / scene["fluid"]["density [kg/m³]"]
width, height = scene["domain"]["high [m]"]
(plate,) = (wall["velocity [m/s]"][0] for wall in scene["walls"] if wall["condition"] == "no slip")

u = [0.0] * round(height / dy)  # m/s  at the middle of each row of cells
steps = round(time / (0.25 * dy * dy / nu) + 0.5)
for _ in range(steps):
    around = [2 * plate - u[0], *u, u[-1]]  # no slip at the plate, free slip at the ceiling
    u = [u[k] + time / steps * nu * (around[k] - 2 * u[k] + around[k + 2]) / dy**2 for k in range(len(u))]

with open("profile.csv", "w", encoding="utf-8") as table:
    table.write("x [m],y [m],v_x [m/s],v_y [m/s]\n")
    for column in range(round(width / dy)):
        for k, v in enumerate(u):
            table.write(f"{(column + 0.5) * dy!r},{(k + 0.5) * dy!r},{v!r},0\n")
