#!/usr/bin/python3
"""Runs an example of PySPH as it is shipped; out/*.npz has what it wrote.

run_pysph.py EXAMPLE DX [OPTIONS]: DX takes the place of the number in the example's line `dx = ...`; "-" leaves it as it is.
"""

import importlib.util
import pathlib
import re
import sys

sys.modules["h5py"] = None  # where that is there PySPH writes HDF5


def main(example, dx, options):
    try:
        file = pathlib.Path(importlib.util.find_spec(f"pysph.examples.{example}").origin)
    except ModuleNotFoundError:
        sys.exit("no PySPH for this Python, expected Debian's package python3-pysph")
    source = file.read_text(encoding="utf-8")
    if dx != "-":
        source, count = re.subn(r"(?m)^dx = .*$", f"dx = {dx}", source)
        if count != 1:
            sys.exit(f"{file}: {count} lines 'dx = ...', expected one")
    sys.argv = [str(file), *options, "--no-openmp", "-d", "out"]
    try:
        exec(compile(source, str(file), "exec"), {"__name__": "__main__", "__file__": str(file)})
    except ModuleNotFoundError as error:  # the plots that examples make of their output, which is complete by then
        if error.name != "matplotlib":
            raise


if __name__ == "__main__":
    main(sys.argv[1], sys.argv[2], sys.argv[3:])
