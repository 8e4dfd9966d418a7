#!/usr/bin/env python3
"""What simulates or is timed is compiled at -O3: no object compiled at less holds a function of a solver.

Run as `no_solver_at_O1_test.py BUILD`; unit tests may hold some, and objects that are not built are passed over. Exit
status 1 with a line for each object that does.
"""

import json
import pathlib
import re
import subprocess
import sys

FUNCTION_OF_SOLVER = re.compile(r"^(.*?):[0-9a-f]* [tTW] (_ZNK?10touchstone3(?:mpm|sph)\w+)", re.M)  # as compilers mangle it


def objects_below_O3(build):
    """The object files of the project, but for tests and headers compiled alone, whose last -O is less than 3."""
    for entry in json.loads((build / "compile_commands.json").read_text(encoding="utf-8")):
        levels = re.findall(r" -O(\w)", entry["command"])
        object_file = re.search(r" -o (\S+)", entry["command"])[1]
        is_test = "_test.dir/" in object_file or "/headers/" in entry["file"]
        if levels and levels[-1] in "012" and not is_test:
            yield pathlib.Path(entry["directory"]) / object_file


def functions_of_solvers(files):
    """{file: one function of a solver that it holds}, of those that hold any."""
    symbols = subprocess.run(["nm", "-A", "--defined-only", *files], capture_output=True, text=True, check=True).stdout
    return dict(FUNCTION_OF_SOLVER.findall(symbols))


def main(build):
    files = [file for file in objects_below_O3(build) if file.suffix == ".o" and file.is_file()]  # no precompiled headers
    found = functions_of_solvers(files) if files else {}
    for file, function in found.items():
        name = subprocess.run(["c++filt", "-p", function], capture_output=True, text=True, check=True).stdout.strip()
        print(f"{file}: holds {name} and is not compiled at -O3, expected its target to be linked with touchstone_optimised")
    if not found:
        print(f"{len(files)} objects below -O3 hold no solver")
    return 1 if found else 0


if __name__ == "__main__":
    if "TOUCHSTONE_SANITIZE:BOOL=ON" in (pathlib.Path(sys.argv[1]) / "CMakeCache.txt").read_text(encoding="utf-8"):
        print("with the sanitizers nothing is timed")
        sys.exit(0)
    sys.exit(main(pathlib.Path(sys.argv[1])))
