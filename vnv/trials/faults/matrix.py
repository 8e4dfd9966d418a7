"""What came of all trials, in a line for a person and as a table: faults by tests, with the margin by which each was
noticed. touchstone_report shows the table as a page."""

import csv
import os
import pathlib

import seeded

SURVIVED, NO_FAULT, FALSE_ALARM = "survived", "does not compile", "false alarm"
AT_NIGHT, NOTICED, GREEN = "noticed at night", "noticed", "stays green"
BAD = (SURVIVED, FALSE_ALARM, NO_FAULT)


def in_words(margin):
    if margin is None:
        return "fails"
    if margin == float("-inf"):
        return "no number"
    return f"{100 * margin:.0f} %" if abs(margin) < 100 else f"{100 * margin:.1e} %"


def by_whom(line):
    """The test that noticed by most."""
    failed = [(name, test) for name, test in line["tests"].items() if test["failed"]]
    size = lambda pair: pair[1]["margin"] if pair[1]["margin"] is not None else 0
    worst = min(failed, key=size, default=None)
    return f" by {worst[0]} ({in_words(worst[1]['margin'])})" if worst else ""


def summary(lines):
    faults = [line for line in lines if not line["harmless"]]
    harmless = [line for line in lines if line["harmless"]]
    alone = sum(line["conclusion"] == NOTICED for line in faults)
    all_in_all = alone + sum(line["conclusion"] == AT_NIGHT for line in faults)
    words = []
    if faults:
        rate = 100 * alone / len(faults)
        words.append(f"{len(faults)} faults: {alone} noticed by day ({rate:.1f} %), {all_in_all} in all")
    if harmless:
        alarms = sum(line["conclusion"] == FALSE_ALARM for line in harmless)
        words.append(f"{len(harmless)} harmless changes: {alarms} false alarms")
    survivors = [line["fault"] for line in lines if line["conclusion"] in BAD]
    return "; ".join(words) + (f"; not as expected: {', '.join(survivors)}" if survivors else "")


def machine():
    """As records have it: "AMD EPYC, 2 processors"."""
    info = pathlib.Path("/proc/cpuinfo").read_text(encoding="utf-8").splitlines()
    model = next((line.split(":", 1)[1].strip() for line in info if line.startswith("model name")), "unknown processor")
    return f"{model}, {os.cpu_count()} processors"


COLUMNS = ("fault", "title", "files", "conclusion", "why", "test", "noticed", "margin [-]", "sentence", "revision",
           "tried at", "digest")


def write(lines, file, provenance):
    """A row for each fault and test, below lines `# key: value`; the former table stands until the new one is whole."""
    new = file.with_name(file.name + ".new")
    with open(new, "w", newline="", encoding="utf-8") as out:
        for key, value in provenance.items():
            out.write(f"# {key}: {value}\n")
        rows = csv.writer(out, lineterminator="\n")
        rows.writerow(COLUMNS)
        for line in lines:
            trial = [line["fault"], line["title"], " ".join(line["files"]), line["conclusion"], line["why"]]
            tried = [line["revision"], line["finished_at"], line["digest"]]
            for name, test in sorted(line["tests"].items()):
                margin = "" if test["margin"] is None else test["margin"]
                result = [name, "yes" if test["failed"] else "no", margin, " ".join(test["sentence"].split())]
                rows.writerow([*trial, *result, *tried])
    os.replace(new, file)


def read(file):
    """What `write` has written: the provenance, and a line for each fault."""
    text = file.read_text(encoding="utf-8").splitlines()
    above = [row for row in text if row.startswith("# ")]
    provenance = dict(row[2:].split(": ", 1) for row in above)
    rows = csv.DictReader(text[len(above):])
    if tuple(rows.fieldnames or ()) != COLUMNS:
        raise seeded.BadInput(f"{file}:{len(above) + 1}: other columns, expected {', '.join(COLUMNS)}")
    lines = {}
    for row in rows:
        line = lines.setdefault(row["fault"], {
            "fault": row["fault"], "title": row["title"], "files": row["files"].split(), "why": row["why"],
            "harmless": row["conclusion"] in (GREEN, FALSE_ALARM), "conclusion": row["conclusion"],
            "revision": row["revision"], "finished_at": row["tried at"], "digest": row["digest"], "tests": {}})
        margin = float(row["margin [-]"]) if row["margin [-]"] else None
        line["tests"][row["test"]] = {"failed": row["noticed"] == "yes", "margin": margin, "sentence": row["sentence"]}
    return provenance, list(lines.values())
