#!/usr/bin/env python3
"""Code that README quotes is that of the tree: under a line that ends in a link to a file, "[name](path):", a case or a flow is quoted whole,
of any other file consecutive lines. And how many seeded faults, mutants and harmless changes texts speak of is what the tables of
their trials hold, with no failure among them. Prints what differs; exit status 0: nothing does; 1: something does.

Example: vnv/trials/readme_test.py
"""

import csv
import difflib
import pathlib
import re
import sys

TOP = pathlib.Path(__file__).resolve().parents[2]
TRIALS = TOP / "vnv/trials"
sys.path.insert(0, str(TRIALS / "faults"))

import matrix  # noqa: E402

QUOTED = re.compile(r"\]\(([\w./]+)\):\n\n```cpp\n(.*?)```", re.DOTALL)


def difference(path, quoted):
    """What the quoted lines have otherwise than the file, as a list of lines; empty if nothing."""
    file = TOP / path
    text = file.read_text(encoding="utf-8") if file.is_file() else ""
    if quoted == text or (not path.startswith(("vnv/cases/", "vnv/flows/")) and "\n" + quoted in "\n" + text):
        return []
    return list(difflib.unified_diff(text.splitlines(), quoted.splitlines(), path, "README.md", lineterm=""))


def counts():
    """{what texts call them: (how many were tried, how many came out as they should)}"""
    _, faults = matrix.read(TRIALS / "faults/trials.csv")
    with open(TRIALS / "mutants/trials.csv", newline="", encoding="utf-8") as file:
        mutants = [row["conclusion"] for row in csv.DictReader(file)]
    of = lambda harmless: [line["conclusion"] for line in faults if line["harmless"] == harmless]
    tried = {"seeded faults": (of(False), matrix.NOTICED), "harmless changes": (of(True), matrix.GREEN),
             "random mutants": ([conclusion for conclusion in mutants if conclusion != "equivalent"], "noticed")}
    return {what: (len(all_of_it), all_of_it.count(good)) for what, (all_of_it, good) in tried.items()}


def miscounted(page, known):
    """Complaints of a text, which has to speak of all of them."""
    said = re.findall(rf"(\d+) \[?({'|'.join(known)})", " ".join((TOP / page).read_text(encoding="utf-8").split()))
    for what, (tried, good) in known.items():
        numbers = {int(number) for number, of in said if of == what}
        if numbers != {tried} or good != tried:
            yield f"{page}: {sorted(numbers)} {what}, expected {tried}, of which {good} came out as they should"


def main():
    readme = (TOP / "README.md").read_text(encoding="utf-8")
    quotes = QUOTED.findall(readme)
    differences = [line for path, quoted in quotes for line in difference(path, quoted)]
    known = counts()
    differences += [line for page in ("README.md", "vnv/trials/README.md") for line in miscounted(page, known)]
    print("\n".join(differences) or f"README.md: {len(quotes)} quoted files, all as they are")
    whole = any(path.startswith("vnv/cases/") for path, _ in quotes) and readme.count("```cpp") == len(quotes)
    if not whole:
        print("README.md: expected a case, and each block of C++ under a line that names its file")
    return 1 if differences or not whole else 0


if __name__ == "__main__":
    sys.exit(main())
