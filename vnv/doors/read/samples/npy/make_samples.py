#!/usr/bin/python3
"""Writes the samples beside it: by NumPy (np.save, np.savez) and by PySPH (pysph.solver.utils.dump), Debian 12's."""

import pathlib
import pickle

import numpy as np

FOLDER = pathlib.Path(__file__).resolve().parent
x = np.array([[0.25, 0.125], [0.75, 0.5], [1 / 3, 1e-300]])
v = np.array([[1.0, -2.0], [0.1, 0.2], [3.0, -0.0]])
p = np.array([101325.0, -1.5, 1 / 7])

np.savez(FOLDER / "plain.npz", x=x, v=v, p=p, t=0.5, version=2)
np.savez_compressed(FOLDER / "compressed.npz", x=x, v=v, p=p, t=0.5, version=2)
np.savez(FOLDER / "big_endian_fortran.npz", x=np.asfortranarray(x.astype(">f8")), v=np.asfortranarray(v.astype(">f8")), p=p.astype(">f8"),
         time=np.array([0.5]))
np.save(FOLDER / "whole_numbers.npy", np.array([[1, -2], [3, 40000]], dtype="i4"))
np.save(FOLDER / "single.npy", v.astype("f4"))
for protocol in (2, 3, 4, 5):
    state = np.empty((), dtype=object)
    state[()] = {"fluid": {"x": x[:, 0].copy(), "y": x[:, 1].copy(), "p": p}, "t": np.float64(0.5), "name": "run", "steps": 2**40, "walls": None}
    with open(FOLDER / f"pickled_{protocol}.npy", "wb") as file:
        np.lib.format.write_array_header_1_0(file, np.lib.format.header_data_from_array_1_0(state))
        pickle.dump(state, file, protocol=protocol)

import sys  # noqa: E402
sys.modules["h5py"] = None  # PySPH writes HDF5 where that is there
from pysph.base.utils import get_particle_array  # noqa: E402
from pysph.solver.utils import dump  # noqa: E402

fluid = get_particle_array(name="fluid", x=x[:, 0], y=x[:, 1], u=v[:, 0], v=v[:, 1], p=p, m=[1.0, 2.0, 3.0], rho=1000.0)
wall = get_particle_array(name="wall", x=[0.0, 1.0], y=[-0.5, -0.5])
dump(str(FOLDER / "pysph_12"), [fluid, wall], {"t": 0.5, "dt": 1e-3, "count": 12})
