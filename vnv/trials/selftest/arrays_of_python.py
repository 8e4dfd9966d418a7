"""What touchstone.py hands over is what was in the arrays: of doubles and single precision, in one array of two columns, every other
entry of a longer one, in lists; and of numpy, where there is one.

Usage: arrays_of_python.py VNV
"""

import array
import os
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).parents[2] / "doors/python"))
os.environ["PATH"] = f"{pathlib.Path(sys.argv[1]).parent}:{os.environ['PATH']}"

import touchstone

flow = touchstone.flow("shear_wave", U=2)
start = {name.split()[0]: values for name, values in flow.particles(0.05).items()}
x, y, v_x, v_y = (start[name] for name in ("x", "y", "v_x", "v_y"))
assert len(x) == 400 and flow.scene(0.05)["parameters"]["U"]["value"] == 2


def every_other(values):
    """Each entry with another between, so that the view of them has gaps."""
    return memoryview(array.array("d", [one for value in values for one in (value, 7)]))[::2]


def pairs(first, second):
    both = array.array("d", [one for pair in zip(first, second) for one in pair])
    return memoryview(both).cast("B").cast("d", (len(first), 2))


samples = {
    "particles as they are given": flow.particles(0.05),
    "doubles": {"x": x, "y": y, "v_x": v_x, "v_y": v_y},
    "lists": {"x": list(x), "y": list(y), "v_x": list(v_x), "v_y": list(v_y)},
    "with gaps": {"x": every_other(x), "y": every_other(y), "v_x": every_other(v_x), "v_y": every_other(v_y)},
    "columns": {"position": pairs(x, y), "velocity": pairs(v_x, v_y)},
    "single precision": {"x": x, "y": y, "v_x": array.array("f", v_x), "v_y": array.array("f", v_y)},
}
try:
    import numpy

    u = numpy.array(v_x)
    samples["numpy"] = {"x": numpy.array(x), "y": numpy.array(y), "v_x": u, "v_y": numpy.zeros(400)}
    samples["numpy, transposed, big-endian"] = {"position": numpy.array([x, y]).T, "velocity": numpy.array([u, 0 * u], dtype=">f8").T}
    samples["numpy, of a numpy time"] = {**samples["numpy"], "t": numpy.float64(0.1)}
except ImportError:
    print("numpy: not here, not tried")


def judged(sample):
    return flow.judge({"t": 0.1, **sample}, at_most=50)


def errors_of(judgement):
    return [value["value"] for value in judgement.values if "per particle" in value["quantity"]["name"]]


found = {name: judged(sample) for name, sample in samples.items()}
expected = errors_of(found["doubles"])
assert len(expected) == 2 and all(value > 0.1 for value in expected), expected
for name, judgement in found.items():
    errors = errors_of(judgement)
    near = 1e-5 if name == "single precision" else 0
    assert len(errors) == 2 and all(abs(a - b) <= near for a, b in zip(errors, expected)), (name, errors, expected)
    assert judgement and "3 of 3 claims hold" in str(judgement), str(judgement)

assert not flow.judge({"t": 0.1, **samples["doubles"]}), "nothing was claimed"
assert not flow.judge({"t": 0.1, **samples["doubles"]}, at_most=1e-3), "a state that did not decay"
for wrong in ({"x": x, "y": y, "v_x": v_x[:-1], "v_y": v_y}, {"x": x, "y": y, "v_x": v_x}, {"y": y, "v_x": v_x, "v_y": v_y}):
    try:
        judged(wrong)
    except touchstone.BadInput as error:
        assert str(error).startswith("vnv: ") and "\n" not in str(error), error
    else:
        raise AssertionError(f"{list(wrong)}: judged, expected a refusal")
