#!/usr/bin/env python3
"""Whoever a text of a case, flow or method names with a year, or as "et al.", has an entry in data/references.bib, by which
`vnv export` cites them. Prints who has none; exit status 0: nobody; 1: somebody.

Example: vnv/trials/references_test.py
"""

import pathlib
import re
import sys

TOP = pathlib.Path(__file__).resolve().parents[2]
NAME = r"[A-Z][\w'-]+"
CITED = re.compile(rf"{NAME}(?:, {NAME})*(?: & {NAME})?(?: et al\.|,? \(?(?:1[89]|20)\d\d\b)")
TEXT = re.compile(r'"((?:[^"\\\n]|\\.)*)"')


def texts(file):
    joined = re.sub(r'"\s*\n\s*"', "", file.read_text(encoding="utf-8"))  # literals that follow each other are one
    return TEXT.findall(joined)


def main():
    bib = (TOP / "data/references.bib").read_text(encoding="utf-8")
    named = [re.compile(pattern) for pattern in re.findall(r"^  named = \{(.*)\},$", bib, re.MULTILINE)]
    cited, unknown = 0, []
    for folder in ("cases", "flows", "methods", "doors", "studies", "stability"):
        for file in sorted((TOP / "vnv" / folder).rglob("*.[ch]pp")):
            if file.name.endswith("_test.cpp"):
                continue
            for text in texts(file):
                for found in CITED.findall(text):
                    cited += 1
                    if not any(pattern.search(text) for pattern in named):
                        unknown.append(f"{file.relative_to(TOP)}: {found}: no entry of data/references.bib is named so")
    print("\n".join(unknown) or f"{cited} citations, all in data/references.bib")
    return 1 if unknown or cited < 40 else 0


if __name__ == "__main__":
    sys.exit(main())
