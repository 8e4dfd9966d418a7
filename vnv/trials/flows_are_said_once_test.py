#!/usr/bin/env python3
"""No title, oracle or published parameter of a flow stands twice: a title only in vnv/flows/NAME.cpp or data/flows/NAME.toml, an oracle is made only in
vnv/flows/, and a case that takes a flow sets none of its parameters to a number of its own.

Run as `flows_are_said_once_test.py VNV`. Exit status 1 with a line for each that does.
"""

import json
import pathlib
import re
import subprocess
import sys

TOP = pathlib.Path(__file__).resolve().parents[2]
MADE = re.compile(r"reference::(\w+)(?: \w+)?\{")


def said(*words):
    return subprocess.run(words, check=True, capture_output=True, text=True).stdout


def complaints(vnv):
    titles = dict(line.split(maxsplit=1) for line in said(vnv, "scene").splitlines() if line.strip())
    sources = {str(file.relative_to(TOP)): re.sub("//.*", "", file.read_text(encoding="utf-8")) for file in [*sorted((TOP / "vnv").rglob("*.[ch]pp")), *sorted((TOP / "data/flows").glob("*.toml"))]
               if not file.name.endswith("_test.cpp") and "trials" not in file.parts and file.name != "right_data.hpp"}
    for name, title in titles.items():
        where = [file for file, text in sources.items() if f'"{title.strip()}"' in text]
        if where not in ([f"vnv/flows/{name}.cpp"], [f"data/flows/{name}.toml"]):
            yield f"title '{title.strip()}' stands in {', '.join(where) or 'no file'}, expected vnv/flows/{name}.cpp or data/flows/{name}.toml alone"
    for file, text in sources.items():
        if not file.startswith("vnv/flows/"):
            yield from (f"{file}: makes the oracle reference::{found}, expected a flow of vnv/flows" for found in MADE.findall(text))
        if file.startswith("vnv/cases/"):
            for name in set(re.findall(r'flow_named\("(\w+)"', text)):
                for parameter in json.loads(said(vnv, "scene", name, "--json"))["parameters"]:
                    if re.search(rf"\bdouble (?:\w+ = [^;]*, )?{parameter} = [\d.]", text):
                        yield f"{file}: sets {parameter} of {name}, expected Flow::operator[] or Settings"


if __name__ == "__main__":
    lines = list(complaints(sys.argv[1]))
    print("\n".join(lines) or "each flow is said once")
    sys.exit(1 if lines else 0)
