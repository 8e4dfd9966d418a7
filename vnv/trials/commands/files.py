"""The files that commands name, as somebody else's programs write them: channel flow by finite differences, in the scene that `vnv` says,
the decay of vortices from the particles that `vnv` gives, a table of errors and one of values."""

import csv
import ctypes
import json
import math
import pickle
import re
import shutil
import struct
import subprocess
import sys
import types
import unittest.mock
import zipfile


def scene_of(vnv, flow, *more):
    words = [vnv, "scene", *flow.split(), "--json", *more]
    return json.loads(subprocess.run(words, check=True, capture_output=True, text=True, encoding="utf-8").stdout)


def scene_and_particles(vnv, folder, flow, spacing):
    scene = scene_of(vnv, flow, f"--spacing={spacing}", f"--particles={folder}/start.csv")
    with open(folder / "start.csv", encoding="utf-8", newline="") as lines:
        names, *rows = csv.reader(lines)
    return scene, {name.split()[0]: [float(value) for value in column] for name, column in zip(names, zip(*rows))}


def channel(vnv, folder, flow, across, until, thicker=1):
    """Flow along a channel, of a fluid so many times as viscous as it should be: {"x": [m], "y": [m], "v_x": [m/s]}, a place a particle."""
    height = scene_of(vnv, flow)["domain"]["high [m]"][1]
    scene, at = scene_and_particles(vnv, folder, flow, height / across)
    nu, dy = thicker * scene["fluid"]["viscosity [Pa s]"] / scene["fluid"]["density [kg/m³]"], height / across
    below, above = scene["walls"]
    force = scene["body force"]["amplitude [m/s²]"][0] if "body force" in scene else 0

    def beyond(wall, t, u):
        along = wall["velocity [m/s]"][0] * math.cos(wall.get("angular frequency [1/s]", 0) * t)
        return 2 * along - u if wall["condition"] == "no slip" else u

    row_of = [round(y / dy - 0.5) for y in at["y"]]
    u = [0.0] * across
    for row, v in zip(row_of, at["v_x"]):
        u[row] = v
    steps = math.ceil(until / (0.25 * dy * dy / nu))
    dt = until / steps
    for step in range(steps):
        around = [beyond(below, (step + 0.5) * dt, u[0]), *u, beyond(above, (step + 0.5) * dt, u[-1])]
        u = [v + dt * (nu * (around[k] - 2 * v + around[k + 2]) / dy**2 + force) for k, v in enumerate(u)]
    return {"x": at["x"], "y": at["y"], "v_x": [u[row] for row in row_of]}


def write_csv(file, columns):
    with open(file, "w", encoding="utf-8", newline="") as out:
        table = csv.writer(out)
        table.writerow(columns)
        table.writerows(zip(*columns.values()))


def data_array(name, rows, kind="Float64"):
    text = "\n".join(" ".join(map(repr, row)) for row in rows)
    return f'<DataArray type="{kind}" Name="{name}" NumberOfComponents="{len(rows[0])}" format="ascii">\n{text}\n</DataArray>'


def write_vtk(file, kind, time, piece):
    file.write_text(f'<?xml version="1.0"?>\n<VTKFile type="{kind}" version="0.1" byte_order="LittleEndian">\n<{kind}>\n<FieldData>\n'
                    f'{data_array("TimeValue", [(time,)]).replace("<DataArray", "<DataArray NumberOfTuples=" + chr(34) + "1" + chr(34))}\n</FieldData>\n{piece}\n</{kind}>\n</VTKFile>\n', encoding="utf-8")


def write_vtp(file, time, at):
    places, velocities = ([(*row, 0.0) for row in zip(at["x"], at["y"])], [(v, 0.0, 0.0) for v in at["v_x"]])
    write_vtk(file, "PolyData", time, f'<Piece NumberOfPoints="{len(places)}">\n<PointData>\n{data_array("velocity", velocities)}\n</PointData>\n'
              f'<Points>\n{data_array("Points", places)}\n</Points>\n</Piece>')


def write_vtu_of_cells(file, time, across, side, velocities):
    """Squares in the plane of x and z, as a code for three dimensions writes them."""
    dx, n = side / across, across + 1
    points = [(i * dx, 0.0, k * dx) for k in range(n) for i in range(n)]
    corners = [(k * n + i, k * n + i + 1, (k + 1) * n + i + 1, (k + 1) * n + i) for k in range(across) for i in range(across)]
    write_vtk(file, "UnstructuredGrid", time, f'<Piece NumberOfPoints="{len(points)}" NumberOfCells="{len(corners)}">\n'
              f'<CellData>\n{data_array("U", velocities)}\n</CellData>\n<Points>\n{data_array("Points", points)}\n</Points>\n<Cells>\n'
              f'{data_array("connectivity", [(corner,) for cell in corners for corner in cell], "Int64")}\n{data_array("offsets", [(4 * k + 4,) for k in range(len(corners))], "Int64")}\n'
              f'{data_array("types", [(9,)] * len(corners), "UInt8")}\n</Cells>\n</Piece>')


def write_pysph(file, time, arrays):
    """As PySPH's output of version 2: dictionaries that numpy pickled, of which `arrays` has {name: {property: numbers}}."""
    ndarray, dtype = (type(name, (), {"__module__": "numpy", "__qualname__": name}) for name in ("ndarray", "dtype"))

    def reconstruct():
        raise NotImplementedError("this writes and does not read")

    reconstruct.__module__, reconstruct.__qualname__ = "numpy.core.multiarray", "_reconstruct"
    made_up = {name: types.ModuleType(name) for name in ("numpy", "numpy.core", "numpy.core.multiarray")}
    made_up["numpy"].ndarray, made_up["numpy"].dtype, made_up["numpy.core.multiarray"]._reconstruct = ndarray, dtype, reconstruct

    class Kind:
        def __init__(self, name, order):
            self.name, self.order = name, order

        def __reduce__(self):
            return dtype, (self.name, False, True), (3, self.order, None, None, None, -1, -1, 63 if self.name == "O8" else 0)

    class Array:
        def __init__(self, shape, kind, held):
            self.state = (1, shape, kind, False, held)

        def __reduce__(self):
            return reconstruct, (ndarray, (0,), b"b"), self.state

    def numbers(values):
        return Array((len(values),), Kind("f8", "<"), struct.pack(f"<{len(values)}d", *values))

    particles = {name: {"arrays": {key: numbers(values) for key, values in columns.items()}} for name, columns in arrays.items()}
    with unittest.mock.patch.dict(sys.modules, made_up), zipfile.ZipFile(file, "w") as archive:
        for name, held in (("particles", particles), ("solver_data", {"t": time})):
            heading = "{'descr': '|O', 'fortran_order': False, 'shape': (), }\n"
            archive.writestr(f"{name}.npy", b"\x93NUMPY\x01\x00" + len(heading).to_bytes(2, "little") + heading.encode()
                             + pickle.dumps(Array((), Kind("O8", "|"), [held]), protocol=3))


def write_hdf5(library, file, columns):
    """By the library itself, a dataset a column."""
    hdf5, usual, overwrite = ctypes.CDLL(library), ctypes.c_int64(0), 2
    hdf5.H5Fcreate.restype = ctypes.c_int64
    opened = ctypes.c_int64(hdf5.H5Fcreate(str(file).encode(), overwrite, usual, usual))
    for name, values in columns.items():
        count, doubles = ctypes.c_uint64(len(values)), (ctypes.c_double * len(values))(*values)
        hdf5.H5LTmake_dataset_double(opened, name.encode(), 1, ctypes.byref(count), doubles)
    hdf5.H5Fclose(opened)


def by_trapezia(count):
    """The integral of a sine over half a period, 2, by a rule of second order."""
    return math.pi / count * sum(math.sin(math.pi * k / count) for k in range(count))


def write_all(build, examples, folder):
    """All of them, into a folder."""
    vnv, case, cache = build / "vnv/vnv", build / "vnv/poiseuille", (build / "CMakeCache.txt").read_text(encoding="utf-8")
    hdf5 = re.search("^HDF5_HL_LIBRARY:FILEPATH=(.*)$", cache, re.MULTILINE)[1]
    one_metre = "poiseuille --set H=1 --set F=1e-5 --set nu=0.01"
    for across in (40, 80, 160):
        write_vtp(folder / f"out_{across}.vtp", 5.0, channel(vnv, folder, one_metre, across, 5))
        along = channel(vnv, folder, "couette", across, 0.05)
        write_csv(folder / f"run_{across}.csv", {"x": [1e3 * x for x in along["x"]], "y": [1e3 * y for y in along["y"]], "v_x": along["v_x"],
                                                 "v_y": [0] * len(along["x"]), "t": [0.05] * len(along["x"])})
    along = channel(vnv, folder, f"{one_metre} --set L=0.4", 50, 20)
    fluid = {"x": along["x"], "y": along["y"], "u": along["v_x"], "v": [0.0] * len(along["x"])}
    wall = {"x": along["x"][:50], "y": [-0.01] * 50, "u": [1.0] * 50, "v": [0.0] * 50}  # no fluid: were it judged, it would be wrong
    write_pysph(folder / "pysph_100.npz", 20.0, {"fluid": fluid, "wall": wall})
    along = channel(vnv, folder, "stokes_second", 40, 0.015, thicker=1.2)
    write_hdf5(hdf5, folder / "plate.h5", {"x": along["x"], "y": along["y"], "u": along["v_x"], "v": [0.0] * len(along["x"]), "t": [0.015] * len(along["x"])})
    scene, at = scene_and_particles(vnv, folder, "taylor_green --set Re=100", 1 / 40)
    decay = math.exp(-8 * math.pi**2 * scene["fluid"]["viscosity [Pa s]"] / scene["fluid"]["density [kg/m³]"] * 0.1)
    by_place = sorted(zip(at["y"], at["x"], at["v_x"], at["v_y"]))
    write_vtu_of_cells(folder / "cells.vtu", 0.1, 40, 1.0, [(decay * u, 0.0, decay * v) for _, _, u, v in by_place])
    integrals = {count: by_trapezia(count) for count in (8, 16, 32, 64)}
    write_csv(folder / "errors.csv", {"h": [1 / n for n in integrals], "error": [2 - value for value in integrals.values()]})
    write_csv(folder / "drag.csv", {"h": [1 / n for n in integrals], "drag": list(integrals.values())})
    subprocess.run([case, "--method", "mpm_least_squares", "--spacing", "2.5e-5", "--until", "0.1", "--vtp", folder], check=True, capture_output=True)
    (folder / "poiseuille.mpm_least_squares.custom.pvd").rename(folder / "out.pvd")
    for name, thicker in (("old", 1), ("new", 1.02)):  # of a program that takes no time, else its cost is compared for a minute
        for across in (20, 40, 80):
            along = channel(vnv, folder, "stokes_first", across, 0.01, thicker)
            write_csv(folder / f"{name}_{across}.csv", {"x": along["x"], "y": along["y"], "v_x": along["v_x"], "v_y": [0] * len(along["x"])})
        solver = (examples / "program/differences.toml").read_text(encoding="utf-8").replace("[40, 80, 160]", "[20, 40, 80]")
        solver = "name = \"mine\"\n" + re.sub("^command = .*", f'command = ["cp", "{{here}}/{name}_{{across}}.csv", "profile.csv"]', solver, flags=re.MULTILINE)
        (folder / f"{name}.toml").write_text(solver, encoding="utf-8")
    shutil.copy(examples / "program/differences.toml", folder / "mine.toml")
    shutil.copy(examples / "program/solve.py", folder)
    (folder / "start.csv").unlink()
