"""What an interruption leaves: which files are whole, what they say, and who still runs."""

import json
import pathlib
import re


def is_whole(file):
    text = file.read_text(encoding="utf-8", errors="replace")
    if file.suffix == ".json":
        return "verdicts" in json.loads(text)
    if file.suffix == ".jsonl":
        lines = [json.loads(line) for line in text.splitlines()]
        return text.endswith("\n") and lines[0]["lines"] == len(lines) - 1
    ends = {".html": "</html>", ".svg": "</svg>"}
    return text.rstrip().endswith(ends.get(file.suffix, "")) and text != ""


def torn(*folders):
    """Records, nights and pages that are there and not whole."""
    found = []
    for folder in folders:
        for file in sorted(folder.rglob("*")):
            inner = file.relative_to(folder).parts
            if not file.is_file() or any(part.startswith(".") for part in inner) or inner[0] in ("logs", "inputs"):
                continue  # what is being written has a hidden name; logs are of people
            try:
                whole = is_whole(file) or file.name == "stamp"
            except (ValueError, KeyError, IndexError):
                whole = False
            if not whole:
                found.append(f"{file} is torn")
    return found


def half_written(folder):
    """Hidden names in a folder, which nothing that has ended well leaves."""
    return [f"{file} is left" for file in sorted(folder.glob(".*"))]


def verdicts(records):
    """{CASE.METHOD: what was judged, by which value, and how}"""
    keys = ("level", "time", "quantity", "author", "value", "outcome")
    found = {file.stem: json.loads(file.read_text(encoding="utf-8"))["verdicts"] for file in records.glob("*.json")}
    return {name: [[verdict[key] for key in keys] for verdict in all_of_it] for name, all_of_it in found.items()}


def finished(records):
    """Records that `vnv run` takes for finished work, with the time when they were written."""
    names = [file.name for file in (records / "inputs").glob("*")
             if re.fullmatch(r"suite \w+\nhash [0-9a-f]{16}\n", file.read_text(encoding="utf-8"))]
    return {name: (records / f"{name}.json").stat().st_mtime_ns for name in names
            if (records / f"{name}.json").is_file()}


def tree(folder):
    """All that is in a folder, to be compared byte by byte."""
    return {str(file.relative_to(folder)): file.read_bytes() for file in sorted(folder.rglob("*")) if file.is_file()}


def members(session):
    """The processes of a session that still run."""
    found = []
    for place in pathlib.Path("/proc").glob("[0-9]*"):
        try:
            state, _, _, of = (place / "stat").read_text().rsplit(")", 1)[1].split()[:4]
        except (OSError, ValueError):
            continue  # it has ended meanwhile
        if state != "Z" and int(of) == session:
            found.append(int(place.name))
    return sorted(found)
