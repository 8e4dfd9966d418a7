#!/usr/bin/env python3
"""Code that README quotes is that of the tree: under a line that ends in a link to a file, "[name](path):", a case or a flow is quoted
whole, of any other file consecutive lines. Prints what differs; exit status 0: nothing does; 1: something does. It runs nothing else.

Example: vnv/trials/readme_test.py
"""

import difflib
import pathlib
import re
import sys

TOP = pathlib.Path(__file__).resolve().parents[2]
QUOTED = re.compile(r"\]\(([\w./]+)\):\n\n```cpp\n(.*?)```", re.DOTALL)


def difference(path, quoted):
    """What the quoted lines have otherwise than the file, as a list of lines; empty if nothing."""
    file = TOP / path
    text = file.read_text(encoding="utf-8") if file.is_file() else ""
    if quoted == text or (not path.startswith(("vnv/cases/", "vnv/flows/")) and "\n" + quoted in "\n" + text):
        return []
    return list(difflib.unified_diff(text.splitlines(), quoted.splitlines(), path, "README.md", lineterm=""))


def main():
    readme = (TOP / "README.md").read_text(encoding="utf-8")
    quotes = QUOTED.findall(readme)
    differences = [line for path, quoted in quotes for line in difference(path, quoted)]
    print("\n".join(differences) or f"README.md: {len(quotes)} quoted files, all as they are")
    whole = any(path.startswith("vnv/cases/") for path, _ in quotes) and readme.count("```cpp") == len(quotes)
    if not whole:
        print("README.md: expected a case, and each block of C++ under a line that names its file")
    return 1 if differences or not whole else 0


if __name__ == "__main__":
    sys.exit(main())
