#!/usr/bin/env python3
"""Writes the samples of this folder with h5py and PySPH; run as `make_samples.py FOLDER` with a python3 that has both.

What the values are stands here and again in the tests. `external.h5` names files beside it and above, which are not there.
"""

import gzip
import pathlib
import sys

import h5py
import numpy as np
from pysph.base.utils import get_particle_array
from pysph.solver.utils import dump

folder = sys.argv[1]
count = np.arange(5)
columns = {"x": 0.1 * count, "y": 1 / (count + 1), "u": count / 3, "v": -count / 7}


def file(name, **options):
    return h5py.File(f"{folder}/{name}", "w", **options)


with file("columns_3.h5") as f:
    f.attrs["time"] = 0.25
    f["Re"] = 100.
    f["name"] = "channel"
    for name, column in columns.items():
        f[name] = column
    for kind in ("f2", "f4", "f8", "i1", "i2", "i4", "i8", "u1", "u2", "u4", "u8"):
        f[f"{kind}_little"] = (3 * count + 1).astype("<" + kind)
        f[f"{kind}_big"] = (3 * count + 1).astype(">" + kind)
with file("latest.h5", libver="latest") as f:
    group = f.create_group("fluid")
    group["t"] = np.float32(0.1)
    group["pos"] = np.column_stack([columns["x"], columns["y"]])
    group.create_dataset("vel", data=np.column_stack([columns["u"], columns["v"]]), chunks=(2, 2), compression="gzip", shuffle=True)
with file("h5part.h5") as f:
    for step in (10, 2):
        group = f.create_group(f"Step#{step}")
        group.attrs["TIME"] = 0.125 * step
        for name in ("x", "y"):
            group[name] = columns[name] + step
with file("lzf.h5") as f:
    f.create_dataset("x", data=columns["x"], compression="lzf")
with file("sparse.h5") as f:
    f.create_dataset("x", shape=(2**40,), dtype="f8", chunks=(2**16,))
with file("external.h5") as f:
    f["x"] = h5py.ExternalLink("other.h5", "/x")
    f["y"] = h5py.SoftLink("/nowhere")
    f["z"] = f["/"]
    f.create_dataset("u", shape=(5,), dtype="f8", external=[("../../../other.bin", 0, 40)])
with file("virtual.h5") as f:
    layout = h5py.VirtualLayout(shape=(5,), dtype="f8")
    layout[:] = h5py.VirtualSource("other.h5", "x", shape=(5,))
    f.create_virtual_dataset("x", layout)

fluid = get_particle_array(name="fluid", m=np.full(5, 0.5), rho=np.full(5, 1000.), p=count / 9, V=np.full(5, 2.), **columns)
fluid.add_property("stress", data=np.arange(10.) / 8, stride=2)
fluid.tag[:] = [0, 0, 0, 2, 0]
fluid.align_particles()
wall = get_particle_array(name="wall", x=[0.05, 0.15], y=[-0.5, -0.5])
for array in (fluid, wall):
    array.set_output_arrays(["x", "y", "u", "v", "tag"])
fluid.add_output_arrays(["stress"])
for name, compress in (("pysph_7.hdf5", False), ("pysph_deflated_7.hdf5", True)):
    written = pathlib.Path(folder) / name
    dump(str(written), [fluid, wall], {"count": 7, "dt": 0.125, "t": np.float64(0.1) * 3}, only_real=False, compress=compress)
    pathlib.Path(f"{written}.gz").write_bytes(gzip.compress(written.read_bytes(), mtime=0))  # 35 KB, most of them zero
    written.unlink()
