#!/usr/bin/env python3
"""What a case measures of its own particles, `vnv judge` measures of the files that it wrote of them, to the last digit printed.

particles_are_judged_alike.py VNV PROGRAM FLOW METHOD all|some OPTION...: PROGRAM is that of the case FLOW, the options are
those of one run of it. With "all", each value has to be judged, else those that are.
"""

import json
import pathlib
import re
import shutil
import subprocess
import sys


def said_by(*command, at_most=0):
    done = subprocess.run(command, capture_output=True, text=True, encoding="utf-8")
    if done.returncode > at_most:
        sys.exit(f"{' '.join(map(str, command))}: ended with {done.returncode}; it said: {done.stdout[-2000:]}{done.stderr[-2000:]}")
    return done.stdout


vnv, program, flow, method, which, *options = sys.argv[1:]
folder = pathlib.Path("particles_are_judged_alike") / flow
shutil.rmtree(folder, ignore_errors=True)
measured = re.findall(r"^(.+) = (\S+) at (\S+) s$", said_by(program, "--method", method, *options, "--vtp", folder), re.MULTILINE)
judged = json.loads(said_by(vnv, "judge", flow, folder / f"{flow}.{method}.custom.pvd", "--at-most", "100", "--json", at_most=1))
found = {}
for value in judged["values"]:
    quantity = value["quantity"]
    found[f"{quantity['name']} [{quantity['unit'] or '-'}]", f"{value['time']:.6g}"] = value["value"]
told_at_its_worst_time = "largest hole [spacings]", "rows crowded [%]", "rows in the place of another [-]"
alike = 0
for heading, value, time in measured:
    if heading in told_at_its_worst_time:
        continue
    if (heading, time) not in found:
        if which == "all":
            sys.exit(f"vnv judge {flow}: no {heading} at {time} s; it found: {sorted(found)}")
    elif (there := f"{float(found[heading, time]):.6g}") != value:
        sys.exit(f"vnv judge {flow}: {heading} = {there} at {time} s, expected {value}")
    else:
        alike += 1
print(f"{flow}: {alike} values alike")
if alike < 2:
    sys.exit(f"{flow}: {alike} values of both, expected at least 2")
