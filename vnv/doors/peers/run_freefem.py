#!/usr/bin/env python3
"""Runs FreeFEM (Taylor-Hood elements, BDF2) on the scene in this folder; out.csv has its fields at the particles' places.

run_freefem.py COURANT: the largest advective Courant number; a step is no longer than that of a viscous number of 1 either.

Elements are two spacings wide, so that nodes of the velocity are as dense as particles; in a periodic square they stand
where the particles start, whose velocities they take.
"""

import csv
import json
import math
import pathlib
import subprocess
import sys

SIDES = {("y", "above"): 1, ("x", "below"): 2, ("y", "below"): 3, ("x", "above"): 4}  # labels of FreeFEM's square

SOLVER = """
mesh Th = square({columns}, {rows}, [{x0!r} + {width!r} * x, {y0!r} + {height!r} * y]);
fespace All(Th, [P2, P2, P1], periodic = [{periodic}]);
fespace Velocity(Th, P2, periodic = [{periodic}]);

int n, m, count;
ifstream start("start.txt");
start >> n >> m;
real[int, int] vx(n, m), vy(n, m);
real vxij, vyij;
for (int j = 0; j < m; ++j) for (int i = 0; i < n; ++i) {{ start >> vxij >> vyij; vx(i, j) = vxij; vy(i, j) = vyij; }}
func int column() {{ return (int(round((x - {x0!r}) / {h!r})) + n) % n; }}
func int row() {{ return (int(round((y - {y0!r}) / {h!r})) + m) % m; }}

Velocity u1 = {at_start} * vx(column(), row()), v1 = {at_start} * vy(column(), row());
Velocity u0 = u1, v0 = v1;
All [u, v, p], [a, b, q];

// A first step by backward Euler leaves the second order: its error is made once.
real dt = {step!r}, nu = {nu!r};
varf flow([u, v, p], [a, b, q]) =
  int2d(Th)(1.5 / dt * (u * a + v * b) + nu * (dx(u) * dx(a) + dy(u) * dy(a) + dx(v) * dx(b) + dy(v) * dy(b))
            - p * (dx(a) + dy(b)) - q * (dx(u) + dy(v)) - 1e-10 * p * q)
  {walls};
varf beginning([u, v, p], [a, b, q]) =
  int2d(Th)(1 / dt * (u * a + v * b) + nu * (dx(u) * dx(a) + dy(u) * dy(a) + dx(v) * dx(b) + dy(v) * dy(b))
            - p * (dx(a) + dy(b)) - q * (dx(u) + dy(v)) - 1e-10 * p * q)
  {walls};
varf push([u, v, p], [a, b, q]) =
  int2d(Th)(({fx!r} + (4 * u1 - u0) / (2 * dt) - 2 * (u1 * dx(u1) + v1 * dy(u1)) + (u0 * dx(u0) + v0 * dy(u0))) * a
            + ({fy!r} + (4 * v1 - v0) / (2 * dt) - 2 * (u1 * dx(v1) + v1 * dy(v1)) + (u0 * dx(v0) + v0 * dy(v0))) * b)
  {walls};
varf first([u, v, p], [a, b, q]) =
  int2d(Th)(({fx!r} + u1 / dt - (u1 * dx(u1) + v1 * dy(u1))) * a + ({fy!r} + v1 / dt - (u1 * dx(v1) + v1 * dy(v1))) * b)
  {walls};

ifstream places("places.txt");
places >> count;
real[int] X(count), Y(count);
for (int k = 0; k < count; ++k) places >> X[k] >> Y[k];
int[int] wanted = {wanted};
ofstream out("out.csv");
out.precision(16);
out << "time,x,y,v_x,v_y,p" << endl;

matrix A = beginning(All, All, solver = sparsesolver);
for (int k = 1, next = 0; next < wanted.n; ++k) {{
  real[int] r(All.ndof);
  if (k == 1) r = first(0, All); else r = push(0, All);
  u[] = A^-1 * r;
  u0 = u1; v0 = v1;
  u1 = u; v1 = v;
  if (k == 1) A = flow(All, All, solver = sparsesolver);
  if (k == wanted[next]) {{
    for (int i = 0; i < count; ++i)
      out << k * dt << "," << X[i] << "," << Y[i] << "," << u(X[i], Y[i]) << "," << v(X[i], Y[i]) << "," << p(X[i], Y[i]) << endl;
    ++next;
  }}
}}
"""


def walls_of(scene):
    """The conditions on the velocity at each wall."""
    said = []
    for wall in scene["walls"]:
        side, (vx, vy) = SIDES[wall["axis"], wall["fluid"]], wall["velocity [m/s]"]
        if wall["angular frequency [1/s]"]:
            sys.exit("a wall that oscillates, expected one at rest or in steady motion")
        slips = "v = 0" if wall["axis"] == "y" else "u = 0"
        said.append(f"+ on({side}, {slips})" if wall["condition"] == "free slip" else f"+ on({side}, u = {vx!r}, v = {vy!r})")
    return " ".join(said)


def main(courant):
    scene = json.loads(pathlib.Path("scene.json").read_text(encoding="utf-8"))
    if scene["schema"] != "touchstone scene 1":
        sys.exit(f"scene.json: schema {scene['schema']!r}, expected 'touchstone scene 1'")
    with open("particles.csv", newline="", encoding="utf-8") as file:
        start = sorted(csv.DictReader(file), key=lambda row: (float(row["y [m]"]), float(row["x [m]"])))
    h, nu = scene["spacing [m]"], scene["fluid"]["viscosity [Pa s]"] / scene["fluid"]["density [kg/m³]"]
    rows = len({row["y [m]"] for row in start})
    columns, (x0, y0), (x1, y1) = len(start) // rows, scene["domain"]["low [m]"], scene["domain"]["high [m]"]
    moving = any(float(row[of]) for row in start for of in ("v_x [m/s]", "v_y [m/s]"))
    periodic = scene["domain"]["periodic"]
    if moving and not all(periodic):
        sys.exit("fluid that starts in motion between walls, expected at rest, or a periodic square")
    if columns % 2 or rows % 2:
        sys.exit(f"{columns} by {rows} particles, expected even numbers: elements are two spacings wide")
    pathlib.Path("start.txt").write_text(f"{columns} {rows}\n" + "".join(f"{row['v_x [m/s]']} {row['v_y [m/s]']}\n" for row in start))
    pathlib.Path("places.txt").write_text(f"{len(start)}\n" + "".join(f"{row['x [m]']} {row['y [m]']}\n" for row in start))
    force, times = scene["body force"]["amplitude [m/s²]"], scene["times [s]"]
    speeds = [math.hypot(float(row["v_x [m/s]"]), float(row["v_y [m/s]"])) for row in start]
    speeds += [math.hypot(*wall["velocity [m/s]"]) for wall in scene["walls"]]
    speeds += [math.hypot(*force) * (y1 - y0) ** 2 / (8 * nu)]
    interval = math.gcd(*(round(time * 1e9) for time in times)) * 1e-9
    step = interval / math.ceil(interval / min(h ** 2 / nu, courant * h / max(speeds)))
    aside = [h / 2 if along else 0 for along in periodic]  # nodes on particles; between walls the walls are nodes
    sides = [name for along, name in zip(periodic, ("[2, y], [4, y]", "[1, x], [3, x]")) if along]
    pathlib.Path("flow.edp").write_text(SOLVER.format(
        columns=columns // 2, rows=rows // 2, x0=x0 + aside[0], y0=y0 + aside[1], width=x1 - x0, height=y1 - y0, h=h,
        periodic=", ".join(sides), at_start=int(moving), step=step, nu=nu, walls=walls_of(scene), fx=force[0], fy=force[1],
        wanted="[" + ", ".join(str(round(time / step)) for time in times) + "]"))
    done = subprocess.run(["FreeFem++-nw", "-v", "0", "flow.edp"], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
    if done.returncode != 0:
        sys.exit(f"FreeFem++-nw ended with {done.returncode}: {done.stdout[-500:]}")


if __name__ == "__main__":
    main(float(sys.argv[1]))
