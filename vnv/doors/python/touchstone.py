# SPDX-License-Identifier: MIT
"""Judges arrays of any code by a flow of Touchstone, through its program `vnv`, which has to be on the PATH.

    import touchstone
    poiseuille = touchstone.flow("poiseuille", H=1, F=1e-5, nu=0.01)
    verdict = poiseuille.judge({"t": 20, "x": x, "y": y, "v_x": u, "v_y": v}, at_most=1)
    print(verdict)

Arrays may be of numpy or of whatever else shares its memory, and lists: their bytes are written to a file that `vnv judge` reads and
that is gone afterwards. numpy itself is not needed, and nothing is kept.
"""

import array
import csv
import json
import pathlib
import shutil
import subprocess
import tempfile
import zipfile


class BadInput(ValueError):
    """What was given cannot be judged; the message is the line that `vnv` said."""


class Judgement:
    """What came of samples: true if all claims hold and there is one."""

    def __init__(self, text, record):
        self.text = text.rstrip("\n")  # as `vnv judge` prints it
        self.record = record  # all values, orders and verdicts, as in the JSON file of `vnv judge --records`
        self.verdicts = record["verdicts"]
        self.values = record["values"]
        self.orders = record["orders"]

    def __bool__(self):
        return bool(self.verdicts) and all(verdict["outcome"] == "holds" for verdict in self.verdicts)

    def __str__(self):
        return self.text


class Flow:
    """A flow of `vnv scene`, or of a TOML file of formulas, at parameters in SI units."""

    def __init__(self, name, parameters):
        self.name = name
        self._words = [name] + [f"--set={key}={float(value)!r}" for key, value in parameters.items()]

    def scene(self, spacing):
        """All that a solver needs, as vnv/doors/README.md lists it; `spacing` [m] is that of the particles."""
        scene = json.loads(_vnv("scene", *self._words, f"--spacing={float(spacing)!r}", "--json"))
        if scene["schema"] != "touchstone scene 1":
            raise BadInput(f"vnv scene: schema {scene['schema']!r}, expected 'touchstone scene 1': touchstone.py is of another version")
        return scene

    def particles(self, spacing):
        """The particles at the start: {"x [m]": array, "y [m]": array, ...}, with that spacing [m]."""
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "particles.csv"
            _vnv("scene", *self._words, f"--spacing={float(spacing)!r}", f"--particles={file}")
            with open(file, encoding="utf-8", newline="") as lines:
                names, *rows = csv.reader(lines)
        return {name: array.array("d", map(float, column)) for name, column in zip(names, zip(*rows))}

    def judge(self, samples, at_most=None, name="mine", options=()):
        """Judges one sample or any number of them, of several times and resolutions; they may be generated one by one.

        A sample holds fields by their names, {"t": s, "x": m, "y": m, "v_x": m/s, "v_y": m/s, "p": Pa, "rho": kg/m³, ...}: the time a
        number, each field an entry a particle, "position" and "velocity" of shape (particles, 2 or 3) too. `at_most` [%] is a limit for
        each norm; `options` are those of `vnv judge`. Raises BadInput, a ValueError."""
        words = [f"--name={name}", *options] + ([f"--at-most={float(at_most)!r}"] if at_most is not None else [])
        with tempfile.TemporaryDirectory() as folder:
            files = []
            for k, sample in enumerate([samples] if hasattr(samples, "keys") else samples):
                files.append(f"{folder}/sample_{k}.npz")
                _write(files[-1], sample)
            text = _vnv("judge", *self._words, *files, f"--records={folder}", *words)
            (record,) = pathlib.Path(folder).glob("*.json")
            return Judgement(text.replace(f"{folder}/", ""), json.loads(record.read_text(encoding="utf-8")))


def flow(name, **parameters):
    """A flow by its name, or by its file, "mine.toml"; parameters that are not given are those of the published flow."""
    return Flow(name, parameters)


def _vnv(*words):
    """What `vnv` prints; it ends with 3 or 4 where its input is bad."""
    program = shutil.which("vnv")
    if program is None:
        raise FileNotFoundError("vnv: not on the PATH, expected there the folder bin of an installed Touchstone")
    ended = subprocess.run([program, *words], capture_output=True, text=True, encoding="utf-8", check=False)
    if ended.returncode not in (0, 1):
        raise BadInput(ended.stderr.strip() or f"vnv ended with {ended.returncode}")
    return ended.stdout


def _write(file, fields):
    """An NPZ of the fields, each written from the memory that it has."""
    with zipfile.ZipFile(file, "w") as archive:
        for name, values in fields.items():
            view = _memory_of(values)
            order, letter = ("<", view.format) if view.format[0] not in "<>=@" else (view.format[0], view.format[1:])
            kind = {"f": "f", "d": "f"}.get(letter, "i" if letter.islower() else "u")
            heading = repr({"descr": f"{'>' if order == '>' else '<'}{kind}{view.itemsize}", "fortran_order": False, "shape": view.shape})
            with archive.open(f"{name}.npy", "w") as member:
                member.write(b"\x93NUMPY\x01\x00" + (len(heading) + 1).to_bytes(2, "little") + heading.encode() + b"\n")
                shares = view.nbytes > 0 and view.c_contiguous and view.format == letter  # a copy of what is not a plain run of native numbers
                member.write(view.cast("B") if shares else view.tobytes())


def _memory_of(values):
    """A view of an array's own memory; of what shares none, such as a list or a number, of a copy as doubles."""
    try:
        view = memoryview(values)
        if view.ndim > 0 and view.format.lstrip("<>=@") in ("d", "f", "b", "h", "i", "l", "q", "B", "H", "I", "L", "Q"):
            return view
    except TypeError:
        pass
    try:
        return memoryview(array.array("d", values))
    except TypeError:
        return memoryview(array.array("d", [values]))
