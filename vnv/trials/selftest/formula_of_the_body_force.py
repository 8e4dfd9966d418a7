"""The body force that `vnv scene manufactured --json` prints, evaluated line by line, is that of its examples.

Usage: formula_of_the_body_force.py VNV
"""

import json
import math
import subprocess
import sys

scene = json.loads(subprocess.run([sys.argv[1], "scene", "manufactured", "--set", "U=2", "--json"], check=True, capture_output=True).stdout)
force = scene["body force"]
(examples,) = (value for name, value in force.items() if name.startswith("examples"))
assert len(examples) == 3, examples
for x, y, t, *expected in examples:
    names = {"sin": math.sin, "cos": math.cos, "pi": math.pi, "x": x, "y": y, "t": t}
    names |= {name: parameter["value"] for name, parameter in scene["parameters"].items()}
    for line in force["formula"]:
        exec(line, names)
    found = [names["b_x"], names["b_y"]]
    assert all(math.isclose(*pair, rel_tol=1e-12) for pair in zip(found, expected)), (x, y, t, found, expected)
