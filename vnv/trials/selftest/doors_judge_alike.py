"""Our own MPM and SPH have the same values and verdicts, to the last bit, through each door: as files (VTP, a table of 17 digits, NPZ and,
where h5py is, HDF5), as a program and as a class; and what the case itself prints of them.

Usage: doors_judge_alike.py VNV PROGRAM CLASSES, where PROGRAM is that of the case of the manufactured solution
"""

import csv
import json
import pathlib
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).parents[2] / "doors/python"))
import touchstone

VNV, PROGRAM, CLASSES = sys.argv[1:]
ACROSS, UNTIL, LIMIT = 32, 0.2, 5
HDF5 = "import csv, h5py, sys; names, *rows = csv.reader(open(sys.argv[1])); f = h5py.File(sys.argv[2], 'w'); [f.create_dataset(n.split()[0], data=[float(v) for v in c]) for n, c in zip(names, zip(*rows))]"


def said(*words, ends=(0,)):
    ended = subprocess.run([str(word) for word in words], capture_output=True, text=True, check=False)
    assert ended.returncode in ends, f"{words}: ended with {ended.returncode}, expected one of {ends}; it said: {ended.stdout}{ended.stderr}"
    return ended.stdout


def values_and_verdicts(text):
    record = json.loads(text)
    verdicts = [[one[key] for key in ("quantity", "time", "value", "lower", "upper", "outcome", "margin")] for one in record["verdicts"]]
    return [[one["quantity"]["name"], one["time"], one["value"]] for one in record["values"]], [one for one in verdicts if one[0] != "end time reached"]


def solver(folder, method, kind, command, output):
    file = folder / f"{kind}.toml"
    text = [f'name = "{method}"', 'flow = "manufactured"', f"across = [{ACROSS}]", f"times = [{UNTIL}]", f"command = {json.dumps([str(word) for word in command])}"]
    file.write_text("\n".join([*text, f'output = "{output}"', f"claims = {{ at_most = {LIMIT} }}"]), encoding="utf-8")
    said(VNV, "run", file, "--records", folder / kind, ends=(0, 1))
    return values_and_verdicts((folder / kind / f"manufactured.{method}.json").read_text(encoding="utf-8"))


def judged(file):
    return values_and_verdicts(said(VNV, "judge", "manufactured", file, "--at-most", LIMIT, "--json", ends=(0, 1)))


def through_all_doors(folder, method):
    inner = said(PROGRAM, "--method", method, "--spacing", 1 / ACROSS, "--until", UNTIL, "--vtp", folder)
    found = {
        "VTP": judged(folder / f"manufactured.{method}.custom.pvd"),
        "program": solver(folder, method, "program", [PROGRAM, "--method", method, "--spacing", "{spacing}", "--until", "{until}", "--vtp", "{folder}"], "*.pvd"),
        "class": solver(folder, method, "class", [CLASSES, "{spacing}", "{times}", "{particles}", "{parameters}", method], "samples.csv"),
    }
    (samples,) = (folder / "class").glob("**/samples.csv")
    with open(samples, encoding="utf-8", newline="") as lines:
        names, *rows = csv.reader(lines)
    rows = [[float(cell) for cell in row] for row in rows]
    table = folder / "table.csv"
    table.write_text("\n".join([",".join(names), *(",".join(f"{cell:.17g}" for cell in row) for row in rows)]), encoding="utf-8")
    touchstone._write(folder / "arrays.npz", dict(zip(names, zip(*rows))))
    found["table"] = judged(table)
    found["NPZ"] = judged(folder / "arrays.npz")
    for python in (sys.executable, "/usr/bin/python3"):
        if subprocess.run([python, "-c", HDF5, table, folder / "arrays.h5"], capture_output=True, check=False).returncode == 0:
            found["HDF5"] = judged(folder / "arrays.h5")
            break
    else:
        print("h5py: not here, HDF5 is not tried")
    values, verdicts = found["VTP"]
    norms = [one for one in values if "per particle" in one[0]]
    assert len(norms) == 3 and len(verdicts) > 3, found["VTP"]
    for door, both in found.items():
        assert both == found["VTP"], f"{method}, {door}: {both}, expected {found['VTP']}"
    for name, time, value in norms:
        assert f"{name} [%] = {value:.6g} at {time:g} s" in inner, f"{method}: {name} = {value}, expected what the case prints: {inner}"
    print(f"{method}: {len(values)} values and {len(verdicts)} verdicts ({', '.join(sorted({one[5] for one in verdicts}))}) alike through {', '.join(found)}")


for ours in ("mpm_affine", "sph_second_order"):
    with tempfile.TemporaryDirectory(prefix="doors judge alike ") as scratch:  # with blanks in its path
        through_all_doors(pathlib.Path(scratch), ours)
