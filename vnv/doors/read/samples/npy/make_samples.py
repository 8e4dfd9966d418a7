#!/usr/bin/env python3
"""Writes the samples of this folder with numpy and PySPH; run as `make_samples.py FOLDER` with a python3 that has both.

What the values are stands here and again in the tests.
"""

import pickle
import sys

import numpy as np
from pysph.base.utils import get_particle_array
from pysph.solver.utils import dump

folder = sys.argv[1]
count = np.arange(5)
columns = {"x": 0.1 * count, "y": 1 / (count + 1), "u": count / 3, "v": -count / 7}

for kind in ("f2", "f4", "f8", "i1", "i2", "i4", "i8", "u1", "u2", "u4", "u8", "b1"):
    for order in "<>":
        np.save(f"{folder}/{kind}_{'little' if order == '<' else 'big'}.npy", (count % 2 if kind == "b1" else 3 * count + 1).astype(order + kind))
table = np.column_stack(list(columns.values()))
np.save(f"{folder}/table_c.npy", table)
np.save(f"{folder}/table_fortran.npy", np.asfortranarray(table))
for version in ((2, 0), (3, 0)):
    with open(f"{folder}/version_{version[0]}.npy", "wb") as file:
        np.lib.format.write_array(file, table, version)

np.savez(f"{folder}/columns.npz", t=np.full(5, 0.25), **columns)
np.savez_compressed(f"{folder}/columns_deflated_12.npz", t=0.25, name="channel", **columns)
np.savez(f"{folder}/vectors.npz", time=np.float32(0.1), pos=table[:, :2], vel=np.asfortranarray(table[:, 2:]))
np.savez(f"{folder}/table.npz", table)
x, y = np.meshgrid(columns["x"], columns["y"][:3])
np.savez(f"{folder}/grid.npz", x=x, y=y, u=x + y, t=0.5)
np.savez(f"{folder}/times.npz", t=np.array([0.2, 0.1, 0.2, 0.1, 0.2]), **columns)
np.savez(f"{folder}/objects.npz", x=np.array([1, "a"], dtype=object))

fluid = get_particle_array(name="fluid", m=np.full(5, 0.5), rho=np.full(5, 1000.), p=count / 9, V=np.full(5, 2.), **columns)
fluid.add_property("stress", data=np.arange(10.) / 8, stride=2)
fluid.tag[:] = [0, 0, 0, 2, 0]  # the last but one is a ghost, which PySPH puts behind the others
fluid.align_particles()
wall = get_particle_array(name="wall", x=[0.05, 0.15], y=[-0.5, -0.5])
for array in (fluid, wall):
    array.add_output_arrays(["tag"])
fluid.add_output_arrays(["p", "V", "stress"])
state = {"count": 7, "dt": 0.125, "t": np.float64(0.1) * 3}
dump(f"{folder}/pysph_7.npz", [fluid, wall], state, only_real=False)
dump(f"{folder}/pysph_deflated_7.npz", [fluid, wall], state, only_real=False, compress=True)

for protocol in range(2, 6):
    arrays = {"c": table, "f": np.asfortranarray(table), "big": columns["x"].astype(">f4"), "nothing": None, "list": [1, -300, 2.5, True, b"\xe9", "\xe9"], "far": 2**40}
    with open(f"{folder}/protocol_{protocol}.pickle", "wb") as file:
        pickle.dump(arrays, file, protocol)
