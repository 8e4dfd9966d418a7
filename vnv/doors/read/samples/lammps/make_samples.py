#!/usr/bin/env python3
"""Writes the samples of this folder with LAMMPS: the same particles in every kind of dump; run as `make_samples.py FOLDER` with an lmp in the path.

What the values are stands here and again in the tests.
"""

import pathlib
import subprocess
import sys
import tempfile

DATA = """five particles

5 atoms
2 atom types
-1 1 xlo xhi
0 2 ylo yhi
-0.5 0.5 zlo zhi

Masses

1 0.5
2 0.25

Atoms

{atoms}

Velocities

{velocities}
"""

INPUT = """units {units}
dimension 2
boundary p f p
atom_style atomic
atom_modify sort 0 0
region box block -1 1 0 2 -0.5 0.5
read_data data
pair_style zero 0.1
pair_coeff * *
neighbor 0.1 bin
compute pair all property/atom vx vy
timestep 0.125
fix move all nve
{dumps}
run 2
"""

DUMPS = {
    "custom.lammpstrj": "id type x y z vx vy mass",
    "times.lammpstrj": "id type element x y vx vy",
    "scaled.lammpstrj": "id xs ys zs vx vy",
    "unwrapped.lammpstrj": "id xu yu vx vy c_pair[1]",
    "custom.lammpstrj.gz": "id type x y z vx vy mass",
}


def dumps():
    for k, (name, columns) in enumerate(DUMPS.items()):
        yield f"dump {k} all custom 2 {name} {columns}\ndump_modify {k} sort id format float %.17g"
        if name.startswith("times"):
            yield f"dump_modify {k} time yes units yes element Ar Ne"


def main(folder):
    with tempfile.TemporaryDirectory() as scratch:
        scratch = pathlib.Path(scratch)
        atoms = "\n".join(f"{k + 1} {1 if k < 4 else 2} {0.1 * k!r} {1 / (k + 1)!r} 0" for k in range(5))
        velocities = "\n".join(f"{k + 1} {k / 3!r} {-k / 7!r} 0" for k in range(5))
        (scratch / "data").write_text(DATA.format(atoms=atoms, velocities=velocities))
        (scratch / "input").write_text(INPUT.format(units="lj", dumps="\n".join(dumps())))
        subprocess.run(["lmp", "-in", "input", "-log", "none", "-screen", "none"], cwd=scratch, check=True)
        tilted = INPUT.format(units="si", dumps="dump 0 all custom 2 triclinic.lammpstrj id x y").replace("read_data data", "read_data data\nchange_box all triclinic xy final 0.25")
        (scratch / "input").write_text(tilted.replace("boundary p f p", "boundary p p p"))
        subprocess.run(["lmp", "-in", "input", "-log", "none", "-screen", "none"], cwd=scratch, check=True)
        for name in [*DUMPS, "triclinic.lammpstrj"]:
            (pathlib.Path(folder) / name).write_bytes((scratch / name).read_bytes())


main(sys.argv[1])
