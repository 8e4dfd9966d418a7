#!/usr/bin/env python3
"""Includes run in one direction: no file includes what lies above its folder.

Run as `include_direction_test.py [SOURCES]`, in the project if it is left out. Exit status 1 with a line for each include that runs back.
"""

import pathlib
import re
import sys

# The folders of vnv/, lowest layer first: each may include all layers below its own, and solvers/ from `run` on.
LAYERS = ("files programs", "record", "judge", "run", "case", "methods measures", "measures/plots", "studies", "harness flows",
          "stability bench doors", "cases", "trials")
WITHOUT_SOLVERS = ("files", "programs", "record", "judge")
WITH_ORACLES = ("flows", "doors", "cases", "trials")
RECORDS = {"vnv/files", "vnv/programs", "vnv/record"}  # what is known where no solver is
REPORTS = ("text", "read", "compare", "figures", "pages")  # lowest first

# What tests may include besides, as they compare a thing with what is made of it, or draw values alike.
OF_TESTS = {"solvers": {"solvers/sph"}, "vnv/files": {"solvers"}, "vnv/run": {"vnv/stability", "vnv/doors/read"},
            "vnv/gate": {"vnv/judge"}, "vnv/studies": {"vnv/harness"}, "vnv/bench": {"reference"}, "reports/read": {"reports/pages"},
            "reports/compare": {"reports/figures"}}


def allowed_includes():
    """{folder: the others that its files may include}"""
    allowed = {"solvers": set(), "solvers/mpm": {"solvers"}, "solvers/sph": {"solvers"}, "reference": set(),
               "vnv/gate": RECORDS, "vnv/doors/read": {"vnv/files"},
               "vnv/command": RECORDS | {"vnv/judge", "vnv/gate", "vnv/flows", "vnv/doors", "vnv/doors/read"}}
    solvers, below = {"solvers", "solvers/mpm", "solvers/sph"}, set()
    for layer in LAYERS:
        for name in layer.split():
            more = set() if name in WITHOUT_SOLVERS else solvers
            allowed[f"vnv/{name}"] = below | more | ({"reference"} if name in WITH_ORACLES else set())
        below = below | {f"vnv/{name}" for name in layer.split()}
    allowed["vnv/doors"] |= {"vnv/doors/read"}
    below = RECORDS
    for name in REPORTS:
        allowed[f"reports/{name}"] = below
        below = below | {f"reports/{name}"}
    return allowed | {"reports": below, "reports/browser": below | {"reports"}, "vnv/trials/verdicts": below,
                      "vnv/trials/inputs": below | {"reports", "vnv/command", "vnv/doors", "vnv/flows", "vnv/harness", "vnv/judge"}}


def folder_of(file, folders):
    """The longest of the folders that a file lies in; vnv/case.hpp counts as one."""
    names = [name for name in folders if file.startswith((name + "/", name + "."))]
    return max(names, key=len, default=None)


def complaints(root):
    allowed = allowed_includes()
    tops = ("solvers", "reference", "vnv", "reports")
    for file in sorted(file for top in tops for file in (root / top).rglob("*.[ch]pp")):
        name = str(file.relative_to(root))
        folder = folder_of(name, allowed)
        if folder is None:
            yield f"{name}: lies in no folder of the table, expected one of {', '.join(sorted(allowed))}"
            continue
        is_test = name.endswith(("_test.cpp", "testing.hpp"))
        may = allowed[folder] | {folder} | (OF_TESTS.get(folder, set()) | {"reports"} if is_test else set())
        for number, line in enumerate(file.read_text(encoding="utf-8").splitlines(), 1):
            found = re.match(r'#include "((?:solvers|reference|vnv|reports)/[^"]+)"', line)
            if found and (other := folder_of(found[1], allowed)) not in may:
                others = ", ".join(sorted(may - {folder}))
                yield f"{name}:{number}: includes {found[1]}, but {folder} may include only {others}"


if __name__ == "__main__":
    lines = list(complaints(pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else ".")))
    print("\n".join(lines) or "each include runs downwards")
    sys.exit(1 if lines else 0)
