#!/usr/bin/env python3
"""Each scene that `vnv scene FLOW --json` prints is of the JSON schema that documents it, and what is not is refused by it; our own
readers of scenes refuse one of a newer version in one line; and the formula of a body force, evaluated line by line, is that of its examples.

scenes_are_of_their_schema.py VNV
"""

import copy
import json
import math
import pathlib
import subprocess
import sys
import tempfile

import jsonschema

VNV = pathlib.Path(__file__).resolve().parents[2]
SCHEMA = VNV / "doors" / "scene.schema.json"


def said(*command):
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout


def spoilt(scene):
    """The scene without one of its keys, with one more, and with one that is no number: none is of the schema."""
    for key in scene:
        if key not in ("times from 0 on, every [s]", "exact"):
            yield {name: value for name, value in scene.items() if name != key}
    yield {**scene, "gravity": 9.81}
    for group, key in (("domain", "low [m]"), ("fluid", "density [kg/m³]"), ("body force", "amplitude [m/s²]")):
        changed = copy.deepcopy(scene)
        changed[group][key] = "1"
        yield changed


def readers_of_a_newer_scene(scene):
    """What a program that reads scene.json has done with one of version 2, where it has not refused it in one line."""
    for reader in ("run_freefem.py", "run_openfoam.py"):
        with tempfile.TemporaryDirectory() as folder:
            (pathlib.Path(folder) / "scene.json").write_text(json.dumps({**scene, "schema": "touchstone scene 2"}), encoding="utf-8")
            ended = subprocess.run([sys.executable, VNV / "doors/peers" / reader, "0.5"], cwd=folder, capture_output=True, text=True, check=False)
        if ended.stderr != "scene.json: schema 'touchstone scene 2', expected 'touchstone scene 1'\n" or ended.returncode == 0:
            yield f"{reader}: {ended.returncode}: {ended.stderr}"


def formula_otherwise(scene):
    """Examples of the body force that are not what its formula gives."""
    force = scene["body force"]
    (examples,) = (value for name, value in force.items() if name.startswith("examples"))
    assert len(examples) == 3, examples
    for x, y, t, *expected in examples:
        names = {"sin": math.sin, "cos": math.cos, "pi": math.pi, "x": x, "y": y, "t": t}
        names |= {name: parameter["value"] for name, parameter in scene["parameters"].items()}
        for line in force["formula"]:
            exec(line, names)
        found = [names["b_x"], names["b_y"]]
        if not all(math.isclose(*pair, rel_tol=1e-12) for pair in zip(found, expected)):
            yield f"body force at {x}, {y}, {t}: {found}, expected {expected}"


def main(vnv):
    validator = jsonschema.Draft7Validator(json.loads(SCHEMA.read_text(encoding="utf-8")))
    validator.check_schema(validator.schema)
    flows = [line.split()[0] for line in said(vnv, "scene").splitlines() if line.strip()]
    wrong = []
    for flow in flows:
        scene = json.loads(said(vnv, "scene", flow, "--json"))
        wrong += [f"{flow}: {'/'.join(map(str, error.path))}: {error.message}" for error in validator.iter_errors(scene)]
        wrong += [f"{flow}: passes though it is spoilt" for other in spoilt(scene) if validator.is_valid(other)]
    wrong += readers_of_a_newer_scene(scene)
    wrong += formula_otherwise(json.loads(said(vnv, "scene", "manufactured", "--set", "U=2", "--json")))
    print("\n".join(wrong) or f"{len(flows)} scenes are of {SCHEMA.name}")
    return 1 if wrong or len(flows) < 14 else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
