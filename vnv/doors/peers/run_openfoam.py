#!/usr/bin/env python3
"""Runs OpenFOAM (pimpleFoam, laminar, second order in space and time) on the scene in this folder; VTK/ has what it wrote.

run_openfoam.py COURANT: the largest advective Courant number; a step is no longer than that of a viscous number of 1 either.
"""

import csv
import json
import math
import os
import pathlib
import subprocess
import sys

SIDES = {("x", "above"): "left", ("x", "below"): "right", ("y", "above"): "bottom", ("y", "below"): "top"}
FACES = {"left": "(0 4 7 3)", "right": "(1 2 6 5)", "bottom": "(0 1 5 4)", "top": "(3 7 6 2)"}
OPPOSITE = {"left": "right", "right": "left", "bottom": "top", "top": "bottom"}


def write(name, kind, text):
    file = pathlib.Path(name)
    file.parent.mkdir(parents=True, exist_ok=True)
    file.write_text(f"FoamFile {{ version 2.0; format ascii; class {kind}; object {file.name}; }}\n{text}\n", encoding="utf-8")


def patches(scene):
    """The wall at each side; none at one that is periodic or open."""
    walls = {SIDES[wall["axis"], wall["fluid"]]: wall for wall in scene["walls"]}
    return {side: walls.get(side) for side in FACES}


def mesh(scene, columns, rows, depth):
    (x0, y0), (x1, y1) = scene["domain"]["low [m]"], scene["domain"]["high [m]"]
    corners = [(x, y, z) for z in (0, depth) for x, y in ((x0, y0), (x1, y0), (x1, y1), (x0, y1))]
    def kind(side, wall):
        is_periodic = scene["domain"]["periodic"][side in ("bottom", "top")]
        return "wall" if wall else f"cyclic; neighbourPatch {OPPOSITE[side]}" if is_periodic else "patch"
    sides = "".join(f"{side} {{ type {kind(side, wall)}; faces ({FACES[side]}); }}\n" for side, wall in patches(scene).items())
    write("system/blockMeshDict", "dictionary", f"""convertToMeters 1;
vertices ({" ".join(f"({x} {y} {z})" for x, y, z in corners)});
blocks (hex (0 1 2 3 4 5 6 7) ({columns} {rows} 1) simpleGrading (1 1 1));
boundary ({sides} frontAndBack {{ type empty; faces ((0 3 2 1) (4 5 6 7)); }} );""")


def at_side(wall):
    """What a side does to the velocity: held, moved, oscillating as a cosine, or left to slip."""
    if wall is None:
        return "type cyclic;"
    if wall["condition"] == "free slip":
        return "type slip;"
    (u, v), omega = wall["velocity [m/s]"], wall["angular frequency [1/s]"]
    if omega == 0:
        return f"type fixedValue; value uniform ({u} {v} 0);"
    frequency = omega / (2 * math.pi)  # a cosine is a sine that began a quarter of a period earlier
    return (f"type uniformFixedValue; value uniform ({u} {v} 0); uniformValue {{ type sine; frequency {frequency!r}; amplitude 1; "
            f"scale ({u} {v} 0); level (0 0 0); t0 {-0.25 / frequency!r}; }}")


def fields(scene, start):
    """Cells stand where the particles start: along x first, then along y."""
    velocities = "\n".join(f"({row['v_x [m/s]']} {row['v_y [m/s]']} 0)" for row in start)
    sides = "".join(f"{side} {{ {at_side(wall)} }}\n" for side, wall in patches(scene).items())
    write("0/U", "volVectorField", f"""dimensions [0 1 -1 0 0 0 0];
internalField nonuniform List<vector> {len(start)} ({velocities});
boundaryField {{ {sides} frontAndBack {{ type empty; }} }}""")
    sides = "".join(f"{side} {{ type {'zeroGradient' if wall else 'cyclic'}; }}\n" for side, wall in patches(scene).items())
    write("0/p", "volScalarField", f"""dimensions [0 2 -2 0 0 0 0];
internalField uniform 0;
boundaryField {{ {sides} frontAndBack {{ type empty; }} }}""")


def every(scene):
    """How often histories are judged [s]; 0 where none are."""
    return scene.get("times from 0 on, every [s]", 0)


def every_time(scene):
    """Steps end on the times that are written only if these are multiples of one interval [s]."""
    return math.gcd(*(round(time * 1e9) for time in (*scene["times [s]"], every(scene)))) * 1e-9


def settings(scene, step, nu):
    write("constant/transportProperties", "dictionary", f"transportModel Newtonian; nu {nu!r};")
    write("constant/turbulenceProperties", "dictionary", "simulationType laminar;")
    (force, other) = scene["body force"]["amplitude [m/s²]"]
    if force or other:
        write("constant/fvOptions", "dictionary", f"""bodyForce {{ type vectorSemiImplicitSource; selectionMode all; volumeMode specific;
injectionRateSuSp {{ U (({force} {other} 0) 0); }} }}""")
    write("system/fvSchemes", "dictionary", """ddtSchemes { default backward; }
gradSchemes { default Gauss linear; } divSchemes { default Gauss linear; }
laplacianSchemes { default Gauss linear corrected; }
interpolationSchemes { default linear; } snGradSchemes { default corrected; }""")
    write("system/fvSolution", "dictionary", """solvers
{ "p.*" { solver PCG; preconditioner DIC; tolerance 1e-12; relTol 0; } "U.*" { solver PBiCGStab; preconditioner DILU; tolerance 1e-12; relTol 0; } }
PIMPLE { nOuterCorrectors 1; nCorrectors 2; nNonOrthogonalCorrectors 0; pRefCell 0; pRefValue 0; }""")
    interval = every_time(scene)
    write("system/controlDict", "dictionary", f"""application pimpleFoam; startFrom startTime; startTime 0; stopAt endTime;
endTime {scene["times [s]"][-1]!r}; deltaT {interval / math.ceil(interval / step)!r}; writeControl adjustableRunTime; writeInterval {interval!r};
writeFormat binary; writePrecision 12; timePrecision 10; runTimeModifiable no;""")


def run(*words):
    with open("log." + words[0], "w", encoding="utf-8") as log:
        done = subprocess.run(words, stdout=log, stderr=subprocess.STDOUT, env=os.environ | {"WM_PROJECT_DIR": "/usr/share/openfoam"}, check=False)
    if done.returncode != 0:
        sys.exit(f"{words[0]} ended with {done.returncode}: " + pathlib.Path("log." + words[0]).read_text(encoding="utf-8")[-500:])


def read_scene():
    scene = json.loads(pathlib.Path("scene.json").read_text(encoding="utf-8"))
    if scene["schema"] != "touchstone scene 1":
        sys.exit(f"scene.json: schema {scene['schema']!r}, expected 'touchstone scene 1'")
    return scene


def main(courant):
    scene = read_scene()
    with open("particles.csv", newline="", encoding="utf-8") as file:
        start = sorted(csv.DictReader(file), key=lambda row: (float(row["y [m]"]), float(row["x [m]"])))
    rows = len({row["y [m]"] for row in start})
    spacing, nu = scene["spacing [m]"], scene["fluid"]["viscosity [Pa s]"] / scene["fluid"]["density [kg/m³]"]
    speeds = [math.hypot(float(row["v_x [m/s]"]), float(row["v_y [m/s]"])) for row in start]
    speeds += [math.hypot(*wall["velocity [m/s]"]) for wall in scene["walls"]]
    speeds += [math.hypot(*scene["body force"]["amplitude [m/s²]"]) * scene["domain"]["high [m]"][1] ** 2 / (8 * nu)]
    step = min(spacing ** 2 / nu, courant * spacing / max(speeds))
    mesh(scene, len(start) // rows, rows, spacing)
    fields(scene, start)
    settings(scene, step, nu)
    run("blockMesh")
    run("pimpleFoam")
    chosen = [] if every(scene) else ["-time", ",".join(f"{time:.10g}" for time in scene["times [s]"])]
    run("foamToVTK", "-no-boundary", "-fields", "(U p)", *chosen)


if __name__ == "__main__":
    main(float(sys.argv[1]))
