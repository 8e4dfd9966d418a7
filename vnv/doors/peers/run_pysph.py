#!/usr/bin/python3
"""Runs an example of PySPH with other numbers; out/*.npz has what it wrote.

run_pysph.py EXAMPLE [NAME=VALUE...] [OPTIONS]: VALUE takes the place of what the example first gives to NAME. All else is as shipped.
"""

import importlib.util
import pathlib
import re
import sys

sys.modules["h5py"] = None  # where that is there PySPH writes HDF5


def main(example, words):
    try:
        file = pathlib.Path(importlib.util.find_spec(f"pysph.examples.{example}").origin)
    except ModuleNotFoundError:
        sys.exit("no PySPH for this Python, expected Debian's package python3-pysph")
    source = file.read_text(encoding="utf-8")
    given = [word.split("=", 1) for word in words if re.match(r"\w+=", word)]
    for name, value in given:
        source, count = re.subn(rf"(?m)((?:^ *|[;,(] *)(?:self\.)?{name} *= *)(?:\[.*?\]|[^;,)\n]+)", rf"\g<1>{value}", source, count=1)
        if count != 1:
            sys.exit(f"{file}: no '{name} = ...', expected one")
    options = [word for word in words if not re.match(r"\w+=", word)]
    sys.argv = [str(file), *options, "--no-openmp", "-d", "out"]
    try:
        exec(compile(source, str(file), "exec"), {"__name__": "__main__", "__file__": str(file)})
    except ModuleNotFoundError as error:  # the plots that examples make of their output, which is complete by then
        if error.name != "matplotlib":
            raise


if __name__ == "__main__":
    main(sys.argv[1], sys.argv[2:])
