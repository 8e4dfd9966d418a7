"""The kill matrix: faults by tests, with the margin by which each was noticed; survivors stand first."""

import csv
import html

SURVIVED, NO_FAULT, FALSE_ALARM = "survived", "does not compile", "false alarm"
AT_NIGHT, NOTICED, GREEN = "noticed at night", "noticed", "stays green"
BAD = (SURVIVED, FALSE_ALARM, NO_FAULT)
ORDER = (*BAD, AT_NIGHT, NOTICED, GREEN)


def in_words(margin):
    if margin is None:
        return "fails"
    if margin == float("-inf"):
        return "no number"
    return f"{100 * margin:.0f} %" if abs(margin) < 100 else f"{100 * margin:.1e} %"


def worst_of(line):
    """The test that noticed by most, or nothing."""
    failed = [(name, test) for name, test in line["tests"].items() if test["failed"]]
    size = lambda pair: pair[1]["margin"] if pair[1]["margin"] is not None else 0
    return min(failed, key=size, default=None)


def by_whom(line):
    worst = worst_of(line)
    return f" by {worst[0]} ({in_words(worst[1]['margin'])})" if worst else ""


def sort(lines):
    """Survivors first, then by how much they were noticed, what was hardly noticed first."""

    def by_how_much(line):
        worst = worst_of(line)
        return 0 if worst is None or worst[1]["margin"] is None else -worst[1]["margin"]

    return sorted(lines, key=lambda line: (ORDER.index(line["conclusion"]), by_how_much(line), line["fault"]))


def summary(lines):
    faults = [line for line in lines if not line["harmless"]]
    harmless = [line for line in lines if line["harmless"]]
    alone = sum(line["conclusion"] == NOTICED for line in faults)
    all_in_all = alone + sum(line["conclusion"] == AT_NIGHT for line in faults)
    words = []
    if faults:
        share = 100 * alone / len(faults)
        words.append(f"{len(faults)} faults: {alone} noticed by day ({share:.1f} %), {all_in_all} in all")
    if harmless:
        alarms = sum(line["conclusion"] == FALSE_ALARM for line in harmless)
        words.append(f"{len(harmless)} harmless changes: {alarms} false alarms")
    survivors = [line["fault"] for line in sort(lines) if line["conclusion"] in BAD]
    return "; ".join(words) + (f"; look at {', '.join(survivors)}" if survivors else "")


def write(lines, stem):
    """STEM.csv, a row for each fault and test, and STEM.html, the matrix."""
    lines = sort(lines)
    with open(stem.with_suffix(".csv"), "w", newline="", encoding="utf-8") as file:
        rows = csv.writer(file, lineterminator="\n")
        rows.writerow(["fault", "title", "conclusion", "test", "noticed", "margin [-]", "sentence"])
        for line in lines:
            for name, test in sorted(line["tests"].items()):
                margin = "" if test["margin"] is None else test["margin"]
                rows.writerow([line["fault"], line["title"], line["conclusion"], name, int(test["failed"]), margin,
                               test["sentence"]])
    stem.with_suffix(".html").write_text(page(lines), encoding="utf-8")


STYLE = """body { font: 15px/1.4 sans-serif; margin: 2em } table { border-collapse: collapse }
th, td { border: 1px solid #ccc; padding: 2px 6px; text-align: left; white-space: nowrap }
thead th { writing-mode: vertical-rl; transform: rotate(180deg); vertical-align: bottom }
.seen { background: #cfe8cf } .bad { background: #f4c7c3 } .night { background: #fbe7b2 } .passed { color: #888 }"""


def page(lines):
    tests = sorted({name for line in lines for name in line["tests"]})
    heads = "".join(f"<th>{html.escape(name)}</th>" for name in ["fault", "conclusion", *tests])
    rows = "".join(row(line, tests) for line in lines)
    return ('<!doctype html>\n<html lang="en"><meta charset="utf-8"><title>Detection power</title>\n'
            f"<style>{STYLE}</style>\n<h1>Detection power</h1>\n<p>{html.escape(summary(lines))}.</p>\n"
            "<p>Margins are shares of the limit that is left, negative beyond it; green cells noticed the fault. "
            "The pointer on a cell tells the verdict.</p>\n"
            f"<table><thead><tr>{heads}</tr></thead>\n<tbody>{rows}</tbody></table></html>\n")


def row(line, tests):
    kind = "bad" if line["conclusion"] in BAD else "night" if line["conclusion"] == AT_NIGHT else ""
    cells = "".join(cell(line["tests"].get(name), line["harmless"]) for name in tests)
    return (f'<tr><th title="{html.escape(", ".join(line["files"]))}">{html.escape(line["title"])}</th>'
            f'<td class="{kind}">{line["conclusion"]}</td>{cells}</tr>\n')


def cell(test, harmless):
    if test is None:
        return "<td></td>"
    kind = ("bad" if harmless else "seen") if test["failed"] else "passed"
    words = in_words(test["margin"]) if test["failed"] or test["margin"] is not None else "passes"
    return f'<td class="{kind}" title="{html.escape(test["sentence"])}">{words}</td>'
