"""`vnv gate old.toml new.toml` runs both in turn and compares what they compute and what they cost."""

import subprocess
import sys
import tempfile
from pathlib import Path

VNV = sys.argv[1]
SOLVER = """name = "{name}"
flow = "shear_wave"
set = {{ Re = {re} }}
across = [10]
times = [0.1]
command = ["sh", "-c", "{work}awk -F, -v OFS=, 'NR > 1 {{{{ $3 *= {factor} }} 1' {{particles}} > end.csv"]
output = "end.csv"
[read]
time = 0.1
{more}"""
BURN = "i=0; while [ $i -lt {} ]; do i=$((i+1)); done; "

with tempfile.TemporaryDirectory() as name:

    def solver(name_of, factor=0.9, burn=0, re=100, more=""):
        file = Path(name) / f"{name_of}.toml"
        work = BURN.format(burn) if burn else ""
        file.write_text(SOLVER.format(name=name_of, factor=factor, re=re, work=work, more=more), encoding="utf-8")
        return str(file)

    def gate(*words):
        ended = subprocess.run([VNV, "gate", *words], capture_output=True, text=True)
        return ended.returncode, ended.stdout + ended.stderr

    old = solver("old", burn=60000)
    status, said = gate(old, solver("twice_as_long", burn=120000), "--repeats", "2")
    assert status == 1 and "shear_wave.old: user CPU time [s]" in said and "times as long" in said, (status, said)
    assert "runs 1 methods by both programs, 2 times in turn" in said, said
    status, said = gate(old, solver("less_wrong", factor=0.95), "--repeats", "0")
    assert status == 0 and "L2 v, per particle [%] at 0.1 s" in said and ": better" in said and "CPU time" not in said, (status, said)
    status, said = gate(old, solver("the_same", burn=60000), "--repeats", "0")
    assert status == 0, (status, said)
    status, said = gate(old, solver("on_a_gpu", more="[resources]\ngpus = 1\n"), "--repeats", "1")
    assert status == 0 and "CPU time [s] before and GPU time [s] after, which are not compared" in said, (status, said)
    status, said = gate(old, solver("another_flow", re=50))
    assert status == 3 and said.count("\n") == 1 and "expected one flow with the same parameters" in said, (status, said)
    status, said = gate(old, solver("elsewhere", more="[needs]\nno_such_program = \"nowhere\"\n"))
    assert status == 3 and said.count("\n") == 1 and "needs no_such_program (nowhere)" in said, (status, said)
