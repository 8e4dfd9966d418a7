#!/usr/bin/env python3
"""Strange surroundings: programs of a build run by who may not write, two at once in one folder, under other locales, in
folders with strange names, on one core, on a processor without AVX, and with a gnuplot or a browser that fails, is not
there or hangs.

What is written is bit-equal to what it would be elsewhere, or one line says where and why, the exit status is not 0, and
what was there before stands. The build folder is only read; other users need root. A trial is a line. Exit status: 0 all
held; 1 something did not; 3 bad input.

Example: vnv/trials/surroundings/try.py build
"""

import csv
import json
import os
import pathlib
import re
import resource
import shutil
import sys
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))

from shared import only_line, processes, refusal, require, require_end, require_none, said_by, start, try_parts, well  # noqa: E402
from works import (CASE, DATA, METHOD, NAME, ROOT, WORKS, TrialsOfWorks, half_written, refused_and_unchanged,  # noqa: E402
                   require_whole, rows_of, tree, verdicts)

NOBODY = {"user": 65534, "group": 65534, "extra_groups": []}
STRANGE = "it's a \"strange\" $(name) & ünïcødé 水"
OF_THE_DAY = re.compile(r'("(?:finished_at|cpu|cpu_lowest|cpu_highest|wall|stepping|harness|peak_memory)":)("[^"]*"|[-+.e0-9]+)')


class Trials(TrialsOfWorks):
    """Each in a folder of its own."""

    def attempt(self, what, trial, *given):
        super().attempt(what, trial, self.folder(), *given)


# What another user may not write, or not read.


def try_user(trials):
    def unwritable(folder, work):
        work.prepare(folder)
        return refused_and_unchanged(work.words(folder), folder, "[Pp]ermission", **NOBODY)

    def unreadable(folder, work):
        work.prepare(folder)
        for file in folder.rglob("*.json"):
            file.chmod(0)
        folder.chmod(0o777)
        return refusal(work.words(folder), folder, "[Pp]ermission", **NOBODY)

    if os.geteuid() != 0:
        print("only root can be another user: not tried")
        return
    trials.scratch.chmod(0o755)
    for name in WORKS:
        trials.attempt(f"{name} where it may not write", unwritable, trials.work(name))
    for name in ("report", "gate"):
        trials.attempt(f"{name} of records that it may not read", unreadable, trials.work(name))


# Two at once.


def both(one, other):
    """Exit status and words of two programs that run beside each other."""
    begun = [start(words) for words in (one, other)]
    return [(process.communicate(timeout=120)[0], process.returncode)[::-1] for process in begun]


def try_at_once(trials):
    programs = trials.programs

    def twice(folder, name, work):
        work.prepare(folder)
        words = work.words(folder)
        ends = both(words, words)
        for status, said in ends:
            require_end(words, status, said, range(128) if name == "report" else (0,))
        require(any(status == 0 for status, _ in ends), f"neither ended well: {ends}")
        require(work.found(folder) == work.expected, "left something else than one alone")
        require_whole(folder)
        return next((f"one gives way: {said.strip()[-300:]}" for status, said in ends if status != 0), "")

    def accepted(folder):
        shutil.copytree(DATA, folder / "data")
        words = lambda method: [programs.vnv, "--data", folder / "data", "accept", f"{CASE}.{method}", "--reason", f"of {method}"]
        file = folder / "data" / "baselines" / f"{CASE}.csv"
        file.write_text("\n".join(row for row in rows_of(file, ("mpm,", "mpm_affine,"))) + "\n", encoding="utf-8")
        for status, said in both(words("mpm"), words("mpm_affine")):
            require_end(words("either"), status, said)
        values = lambda table: {tuple(row[:4]) for row in csv.reader(rows_of(table))}  # by method, level, time and quantity
        lost = values(DATA / "baselines" / f"{CASE}.csv") - values(file)
        require(not lost, f"{len(lost)} baselines of one were lost to the other: {sorted(lost)[:1]}")

    def read_while_written(folder):
        work = trials.work("run")
        work.prepare(folder)
        (status, said), (other, told) = both(work.words(folder), [programs.report, folder / "records", folder / "site"])
        require(status == 0 and (other in (0, 1) or "no record" in told), f"{status}, {other}: {said[-200:]!r} {told[-200:]!r}")

    def others_are_kept(folder):
        records = folder / "records"
        shutil.copytree(trials.former, records)
        before = {name: text for name, text in tree(records).items() if "/" not in name}
        for _ in range(2):  # as ctest -R does, once and again
            well([programs.guard, "begin", records])
            require(not list(records.glob("*.json")), "a record of before would be judged")
        require(tree(records / "before").items() >= before.items(), "records of before are gone")

    for name in WORKS:
        work = trials.work(name).undisturbed(trials.folder())
        for _ in range(5):
            trials.attempt(f"{name} twice at once", twice, name, work)
    for _ in range(3):
        trials.attempt("two methods of a case accepted at once", accepted)
        trials.attempt("pages while records are made", read_while_written)
    trials.attempt("ctest -R of one keeps the records of others", others_are_kept)


# Locales.


def try_locale(trials):
    bare = {name: value for name, value in os.environ.items() if not name.startswith("LC_") and name not in ("LANG", "LANGUAGE")}
    programs, made_here = trials.programs, trials.folder()
    german = {"LOCPATH": str(made_here), "LC_ALL": "de_DE.UTF-8", "LANGUAGE": "de"}
    made, _ = said_by(["localedef", "-i", "de_DE", "-f", "UTF-8", made_here / "de_DE.UTF-8"])
    is_made = made == 0 and said_by(["bash", "-c", "printf %.1f 0,5"], env=os.environ | german)[1] == "0,5"
    if not is_made:
        print("no locale with a decimal comma can be made: it is not tried")

    def written(folder, env):
        """Records but for what changes from run to run, pages and tables, of one case that runs and one that is read."""
        records, site, nights, table = folder / "records", folder / "site", folder / "nights", folder / "gate.md"
        well([programs.vnv, "run", NAME, f"{CASE}.sph", "--records", records], env=env)
        pages = [programs.report, trials.former, site, "--history", nights, "--claims", DATA / "claims", "--references", DATA / "references.bib"]
        require_end(pages, *said_by(pages, env=env), (0, 1))
        well([programs.vnv, "gate", trials.former, records, "--json", folder / "gate.json", "--markdown", table], env=env)
        json.loads((folder / "gate.json").read_text(encoding="utf-8"))
        of_all_days = {file.name: OF_THE_DAY.sub(r"\1", file.read_text(encoding="utf-8")) for file in sorted(records.glob("*.json"))}
        return {"records": of_all_days, "pages": tree(site), "nights": tree(nights),
                "the gate's table": {table.name: table.read_text(encoding="utf-8").replace(str(folder), "")}}

    usual = written(trials.folder(), bare | {"LC_ALL": "C.UTF-8"})

    def same(folder, env):
        found = written(folder, env)
        for what, expected in usual.items():
            differ = [name for name in expected | found[what] if found[what].get(name) != expected.get(name)]
            require(not differ, f"other {what}: {differ[:3]}")

    trials.attempt("LC_ALL=C", same, bare | {"LC_ALL": "C"})
    trials.attempt("no locale", same, bare)
    if is_made:
        trials.attempt("a decimal comma", same, bare | german)


# Names of folders.


def try_path(trials):
    programs = trials.programs

    def walked(folder, name, solver):
        here = folder / name
        records, data, called = here / "records", here / "data", here / "solver" / f"{solver}.toml"
        shutil.copytree(DATA, data)
        shutil.copytree(ROOT / "vnv" / "doors" / "examples" / "program", here / "solver")
        next((here / "solver").glob("*.toml")).rename(called)
        for words in ([programs.vnv, "run", NAME, "--records", records],
                      [programs.vnv, "run", called, "--records", records],
                      [programs.case, "--method", METHOD, "--spacing", "5e-5", "--vtp", here / "particles"],
                      [programs.report, records, here / "site", "--history", here / "nights"],
                      [programs.vnv, "gate", records, records, "--json", here / "gate.json"],
                      [programs.vnv, "--data", data, "accept", NAME, "--reason", "a trial"],
                      [programs.vnv, "export", CASE, "--records", records, "--folder", here / "paper"]):
            well(words)
        require_whole(here)
        require(len(verdicts(records)) == 2, "a record is missing")
        require((here / "site" / CASE / "index.html").is_file() and any((here / "paper").iterdir()), "pages or tables are missing")

    trials.attempt("a plain folder", walked, "plain", "plain")
    trials.attempt(f"a folder called {STRANGE}", walked, STRANGE, "its_水")


# Processors.


def try_processor(trials):
    programs = trials.programs

    def on_one_core(folder):
        well(["taskset", "-c", "0", programs.vnv, "run", CASE, "--records", folder / "records", "-j", "2"])

    def without_avx(_, *words):
        """What was built for this machine says so on another one; what was built for any runs there."""
        words = ["qemu-x86_64", "-cpu", "Nehalem", *words]
        if "TOUCHSTONE_NATIVE:BOOL=ON" in (trials.build / "CMakeCache.txt").read_text(encoding="utf-8"):
            status, said = said_by(words)
            require(0 < status < 128 and len(said.splitlines()) == 1, f"ended with status {status}, says not one line: {said[-300:]!r}")
            return only_line(said, words[3].name, "needs avx")
        well(words)
        code = well(["objdump", "-d", "--no-show-raw-insn", words[3]])
        held = re.findall(r"\tv\w+ .*%[xyz]mm", code)
        require(code and not held, f"holds {len(held)} instructions of AVX: {held[:1]}")
        return f"runs, {code.count(chr(10))} lines of instructions without AVX"

    trials.attempt("one core", on_one_core)
    if not shutil.which("qemu-x86_64"):
        print("no qemu-x86_64: a processor without AVX is not tried")
        return
    for words in ((programs.case, "--method", METHOD), (programs.vnv, "list"), (programs.report, "--help"),
                  (programs.guard, "begin", trials.folder() / "guarded")):
        trials.attempt(f"{words[0].name} without AVX", without_avx, *words)


# Programs of others that are called: gnuplot draws the figures, a browser opens the pages.


def stand_in(folder, name, script):
    """An environment in which a script is called by that name; `folder` is found first."""
    file = folder / name
    file.write_text(script, encoding="utf-8")
    file.chmod(0o755)
    return os.environ | {"PATH": f"{folder}:{os.environ['PATH']}"}


def try_gnuplot(trials):
    real, work = shutil.which("gnuplot"), trials.work("report")

    def shown(folder, script, cause, longest=60):
        work.prepare(folder)
        before, environment = tree(folder / "site"), stand_in(trials.folder(), "gnuplot", "#!/bin/sh\n" + script)
        began, words = time.monotonic(), work.words(folder)
        said = require_end(words, *said_by(words, env=environment), (3,))
        require(time.monotonic() - began < longest, "took too long")
        require(tree(folder / "site") == before, "the former site has changed")
        require_none(half_written(folder))
        return only_line(said, "gnuplot", cause)

    def missing(folder):
        work.prepare(folder)
        words = work.words(folder)
        said = require_end(words, *said_by(words, env=os.environ | {"PATH": str(folder)}), (3,))
        require("not found on PATH" in said, f"does not say why: {said[-300:]!r}")
        require((folder / "site" / "verdicts.csv").is_file(), "no tables")

    trials.attempt("no gnuplot", missing)
    trials.attempt("a gnuplot that fails", shown, "echo no terminal >&2; exit 1\n", "no terminal")
    trials.attempt("a gnuplot that says nothing", shown, "exit 0\n", "ended early")
    trials.attempt("a gnuplot that is killed", shown, "kill -KILL $$\n", "Killed|ended early")
    trials.attempt("a gnuplot that dies halfway", shown, f"sed '/set print/,$d' | {real} \"$@\"\n", "ended early")
    trials.attempt("a gnuplot that hangs", shown, "exec sleep 1000\n", "longer than", 90)


def try_browser(trials):
    def opened(folder, script, cause, longest=30):
        (folder / "site").mkdir()
        (folder / "site" / "index.html").write_text("<p>A page.</p>", encoding="utf-8")
        gigabyte = (1 << 30, 1 << 30)
        status, said = said_by([sys.executable, "-B", ROOT / "reports" / "browser" / "browse.py", "chromium", folder / "site", "--longest", longest],
                               env=stand_in(folder, "chromium", f"#!/bin/bash\n{script}\n"),
                               preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_AS, gigabyte))
        require(0 < status < 128 and len(said.splitlines()) == 1, f"ended with status {status}, says not one line: {said[-300:]!r}")
        living = [found.name for found in processes().values() if any(one.startswith(f"PATH={folder}:") for one in found.environment)]
        require(not living, f"it or one of its children lives on: {living}")
        return only_line(said, "browse.py", cause)

    trials.attempt("a browser that fails", opened, "exit 1", "ended before")
    trials.attempt("a browser that hangs", opened, "trap '' TERM; sleep 1000 & sleep 1000", "not answer within 2 s", 2)
    trials.attempt("a browser that prints without end", opened, "yes & yes >&2", "not answer within 2 s", 2)
    trials.attempt("a browser that answers without end", opened, "tr '\\0' x </dev/zero >&4", "more than 64 MiB")
    trials.attempt("a browser that tells without end of something else", opened,
                   """yes '{"method": "Page.frameNavigated"}' | tr '\\n' '\\0' >&4""", "more than 64 MiB|within", 5)
    trials.attempt("a browser that speaks otherwise", opened, "printf 'no JSON\\0' >&4; sleep 1000", "expected a message in JSON")


PARTS = {"user": try_user, "at_once": try_at_once, "locale": try_locale, "path": try_path, "processor": try_processor, "gnuplot": try_gnuplot,
         "browser": try_browser}

if __name__ == "__main__":
    try_parts(__doc__, PARTS, Trials)
