"""What `vnv judge --json` prints, and its JUnit file: a shear wave that was frozen at its start is late by as much as it should have decayed."""

import json
import subprocess
import sys
import tempfile
from pathlib import Path

VNV = sys.argv[1]


def vnv(*words, status=0):
    ended = subprocess.run([VNV, *words], capture_output=True, text=True)
    assert ended.returncode == status, (words, ended)
    return ended.stdout


with tempfile.TemporaryDirectory() as name:
    start, verdicts = str(Path(name) / "start.csv"), Path(name) / "verdicts.xml"
    vnv("scene", "shear_wave", "--particles", start)
    words = ["judge", "shear_wave", start, "--time", "0.1", "--at-most", "1", "--junit", str(verdicts)]
    judged = json.loads(vnv(*words, "--json", status=1))
    assert judged["schema"] == "touchstone judgement 1" and judged["flow"] == "shear_wave" and not judged["holds"], judged
    assert {"files", "read as", "not judged", "runs", "values", "orders", "verdicts", "diagnoses"} <= judged.keys(), judged.keys()
    (diagnosis,) = judged["diagnoses"]
    late = [one for one in diagnosis["explanations"] if [cause["cause"] for cause in one["causes"]] == ["time"]]
    assert len(late) == 1 and late[0]["named"] and abs(late[0]["causes"][0]["value"] + 0.1) < 1e-3, late
    said = late[0]["sentence"]
    failing = [verdict["sentence"] for verdict in judged["verdicts"] if verdict["outcome"] == "fails"]
    assert "s late" in said and len(failing) == 2 and all(said in sentence for sentence in failing), judged["verdicts"]
    assert said in verdicts.read_text(), "JUnit's messages"
    people = vnv(*words, "--diagnose", status=1)
    assert said in people and "% of the squared error: time -0.1" in people, people
