#!/usr/bin/env python3
"""Strange surroundings: programs of a build run by who may not write, two at once in one folder, under other locales, in
folders with strange names, on one core, on a processor without AVX, and with a gnuplot or a browser that fails, is not
there or hangs.

What is written is bit-equal to what it would be elsewhere, or one line says where and why, the exit status is not 0, and
what was there before stands. The build folder is only read; other users need root. A trial is a line. Exit status: 0 all
held; 1 something did not; 3 bad input.

Example: vnv/trials/surroundings/try.py build
"""

import contextlib
import json
import os
import pathlib
import re
import resource
import shutil
import subprocess
import sys
import tempfile
import time

FOLDER = pathlib.Path(__file__).resolve().parent
ROOT = FOLDER.parents[2]
sys.path[:0] = [str(FOLDER.parent), str(FOLDER.parent / "interruptions"), str(FOLDER.parent / "machine")]

import left  # noqa: E402
from shared import BadInput, Failure, Parser, exit_with, require  # noqa: E402
from works import CASE, DATA, METHOD, WORKS, Work, copied, said_by  # noqa: E402

NOBODY = 65534
STRANGE = "it's a \"strange\" $(name) & ünïcødé 水"
OF_THE_DAY = re.compile(r'("(?:finished_at|cpu|cpu_lowest|cpu_highest|wall|stepping|harness|peak_memory)":)("[^"]*"|[-+.e0-9]+)')


def require_refused(status, said, place, cause):
    require(0 < status < 128, f"ended with status {status}, expected a refusal; it said: {said[-200:]!r}")
    lines = [line for line in said.splitlines() if str(place) in line and re.search(cause, line)]
    require(len(lines) == 1, f"{len(lines)} lines say where and why, expected one; it said: {said[-300:]!r}")
    return lines[0].strip()


def without_costs(folder):
    """Records but for what changes from run to run."""
    return {file.name: OF_THE_DAY.sub(r"\1", file.read_text(encoding="utf-8")) for file in sorted(folder.glob("*.json"))}


class Trials:
    def __init__(self, build, former, scratch):
        self.build, self.former, self.scratch, self.failed, self.count = build, former, scratch, 0, 0
        self.vnv, self.report, self.guard = build / "vnv" / "vnv", build / "reports" / "touchstone_report", build / "vnv" / "touchstone_guard"
        self.case = build / "vnv" / CASE

    def attempt(self, what, trial, *more):
        self.count += 1
        folder = self.scratch / f"trial{self.count}"
        folder.mkdir()
        try:
            found, word = trial(folder, *more) or "", "passed"
        except (Failure, OSError, subprocess.SubprocessError, ValueError) as problem:
            found, word, self.failed = str(problem), "FAILED", self.failed + 1
        print(f"{word} {what}{': ' if found else ''}{found}"[:500], flush=True)

    def work(self, name):
        return WORKS[name](self.build, self.former)


# What another user may not write, or not read.


def try_user(trials):
    as_nobody = {"user": NOBODY, "group": NOBODY, "extra_groups": []}

    def unwritable(folder, name):
        work = trials.work(name)
        work.prepare(folder)
        before = left.tree(folder)
        line = require_refused(*said_by(work.words(folder), **as_nobody), folder, "[Pp]ermission")
        require(left.tree(folder) == before, "something was written")
        return line

    def unreadable(folder, name):
        work = trials.work(name)
        work.prepare(folder)
        for file in folder.rglob("*.json"):
            file.chmod(0)
        folder.chmod(0o777)
        return require_refused(*said_by(work.words(folder), **as_nobody), folder, "[Pp]ermission")

    os.chmod(trials.scratch, 0o755)
    for name in WORKS:
        trials.attempt(f"{name} where it may not write", unwritable, name)
    for name in ("report", "gate"):
        trials.attempt(f"{name} of records that it may not read", unreadable, name)


# Two at once.


def both(one, other):
    """Exit status and words of two programs that run beside each other."""
    begun = [subprocess.Popen([str(word) for word in words], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True) for words in (one, other)]
    return [(process.communicate(timeout=120)[0], process.returncode)[::-1] for process in begun]


def try_at_once(trials):
    def twice(folder, name, expected):
        work = trials.work(name)
        work.prepare(folder)
        words = work.words(folder)
        ends = both(words, words)
        for status, said in ends:
            require(0 <= status < 128, f"ended with status {status}: {said[-300:]!r}")
            require(status == 0 or name == "report", f"ended with status {status}: {said[-300:]!r}")
        require(any(status == 0 for status, _ in ends), f"neither ended well: {ends}")
        require(work.found(folder) == expected, "left something else than one alone")
        for place in ("records", "nights"):
            if (folder / place).is_dir():
                require(not left.torn(folder / place), f"torn: {left.torn(folder / place)}")
        return "" if all(status == 0 for status, _ in ends) else "one gives way: " + next(said for status, said in ends if status != 0).strip()

    def accepted(folder):
        copied(DATA, folder / "data")
        words = lambda method: [trials.vnv, "--data", folder / "data", "accept", f"{CASE}.{method}", "--reason", f"of {method}"]
        file = folder / "data" / "baselines" / f"{CASE}.csv"
        kept = [line for line in file.read_text(encoding="utf-8").splitlines() if not re.match("(mpm|mpm_affine),", line)]
        file.write_text("\n".join(kept) + "\n", encoding="utf-8")
        for status, said in both(words("mpm"), words("mpm_affine")):
            require(status == 0, f"ended with status {status}: {said[-300:]!r}")
        rows = lambda path: {line for line in path.read_text(encoding="utf-8").splitlines() if not line.startswith("#")}
        lost = rows(DATA / "baselines" / f"{CASE}.csv") - rows(file)
        require(not lost, f"{len(lost)} baselines of one were lost to the other: {sorted(lost)[:1]}")

    def read_while_written(folder):
        work = trials.work("run")
        work.prepare(folder)
        (status, said), (other, told) = both(work.words(folder), [trials.report, folder / "records", folder / "site"])
        require(status == 0 and (other in (0, 1) or "no record" in told), f"{status}, {other}: {said[-200:]!r} {told[-200:]!r}")

    def others_are_kept(folder):
        copied(trials.former, folder / "records")
        before = left.tree(folder / "records")
        for _ in range(2):  # as ctest -R does, once and again
            status, said = said_by([trials.guard, "begin", folder / "records"])
            require(status == 0, said)
            require(not list((folder / "records").glob("*.json")), "a record of before would be judged")
        require(left.tree(folder / "records" / "before").items() >= {name: text for name, text in before.items() if "/" not in name}.items(), "records of before are gone")

    for name in WORKS:
        folder = trials.scratch / f"alone_{name}"
        folder.mkdir()
        work = trials.work(name)
        work.prepare(folder)
        said_by(work.words(folder))
        expected = json.loads(json.dumps(work.found(folder))) if name in ("case", "run") else work.found(folder)
        for _ in range(5):
            trials.attempt(f"{name} twice at once", twice, name, expected)
    for _ in range(3):
        trials.attempt("two methods of a case accepted at once", accepted)
        trials.attempt("pages while records are made", read_while_written)
    trials.attempt("ctest -R of one keeps the records of others", others_are_kept)


# Locales.


def try_locale(trials):
    with_comma = trials.scratch / "locales"
    with_comma.mkdir()
    made = subprocess.run(["localedef", "-i", "de_DE", "-f", "UTF-8", with_comma / "de_DE.UTF-8"], capture_output=True).returncode == 0
    german = {"LOCPATH": str(with_comma), "LC_ALL": "de_DE.UTF-8", "LANGUAGE": "de"}
    if not made or subprocess.run(["bash", "-c", "printf %.1f 0,5"], env=os.environ | german, capture_output=True, text=True).stdout != "0,5":
        print("no locale with a decimal comma can be made: it is not tried")
        made = False

    def written(folder, env):
        """Records, pages and tables, of one case that runs and one that is read."""
        records, site = folder / "records", folder / "site"
        for words in ([trials.vnv, "run", f"{CASE}.{METHOD}", f"{CASE}.sph", "--records", records],
                      [trials.report, trials.former, site, "--history", folder / "nights", "--claims", DATA / "claims", "--references", DATA / "references.bib"],
                      [trials.vnv, "gate", trials.former, records, "--json", folder / "gate.json", "--markdown", folder / "gate.md"]):
            status, said = said_by(words, env=env)
            require(status in (0, 1) and "gate" not in words or status == 0, f"ended with status {status}: {said[-300:]!r}")
        tables = {name: (folder / name).read_text(encoding="utf-8").replace(str(folder), "") for name in ("gate.json", "gate.md")}
        return without_costs(records), left.tree(site), left.tree(folder / "nights"), tables["gate.md"]

    bare = {name: value for name, value in os.environ.items() if not name.startswith("LC_") and name not in ("LANG", "LANGUAGE")}
    folder = trials.scratch / "usual"
    folder.mkdir()
    usual = written(folder, bare | {"LC_ALL": "C.UTF-8"})

    def same(folder, env):
        for what, one, other in zip(("records", "pages", "nights", "the gate's table"), written(folder, env), usual):
            differ = [name for name in other if one.get(name) != other[name]] if isinstance(one, dict) else [] if one == other else [what]
            require(one == other, f"other {what}: {differ[:3]}")

    trials.attempt("LC_ALL=C", same, bare | {"LC_ALL": "C"})
    trials.attempt("no locale", same, bare)
    if made:
        trials.attempt("a decimal comma", same, bare | german)


# Names of folders.


def try_path(trials):
    def walked(folder, name):
        here = folder / name
        records, data = here / "records", copied(DATA, here / "data")
        (here / "solver").mkdir()
        for file in (ROOT / "vnv" / "doors" / "examples" / "program").iterdir():
            shutil.copy(file, here / "solver")
        solver = next((here / "solver").glob("*.toml")).rename(here / "solver" / f"{'its_水' if name == STRANGE else 'plain'}.toml")
        for words in ([trials.vnv, "run", f"{CASE}.{METHOD}", "--records", records],
                      [trials.vnv, "run", solver, "--records", records],
                      [trials.case, "--method", METHOD, "--spacing", "5e-5", "--vtp", here / "particles"],
                      [trials.report, records, here / "site", "--history", here / "nights"],
                      [trials.vnv, "gate", records, records, "--json", here / "gate.json"],
                      [trials.vnv, "--data", data, "accept", f"{CASE}.{METHOD}", "--reason", "a trial"],
                      [trials.vnv, "export", CASE, "--records", records, "--folder", here / "paper"]):
            status, said = said_by(words)
            require(status == 0, f"{' '.join(str(word) for word in words[:3])}: ended with status {status}: {said[-300:]!r}")
        require(len(left.verdicts(records)) == 2 and not left.torn(here / "site"), "records or pages are torn")
        require((here / "site" / CASE / "index.html").is_file() and any((here / "paper").iterdir()), "pages or tables are missing")
        return here

    trials.attempt("a plain folder", lambda folder: walked(folder, "plain") and None)
    trials.attempt(f"a folder called {STRANGE}", lambda folder: walked(folder, STRANGE) and None)


# Processors.


def try_processor(trials):
    def on_one_core(folder):
        status, said = said_by(["taskset", "-c", "0", trials.vnv, "run", CASE, "--records", folder / "records", "-j", "2"])
        require(status == 0, said[-300:])

    def without_avx(_, *words):
        """What was built for this machine says so on another one; what was built for any runs there."""
        status, said = said_by(["qemu-x86_64", "-cpu", "Nehalem", *words])
        if "TOUCHSTONE_NATIVE:BOOL=ON" not in (trials.build / "CMakeCache.txt").read_text(encoding="utf-8"):
            require(status == 0, f"ended with status {status}: {said[-300:]!r}")
            code = subprocess.run(["objdump", "-d", "--no-show-raw-insn", words[0]], capture_output=True, text=True, check=True).stdout
            held = re.findall(r"\tv\w+ .*%[xyz]mm", code)
            require(code and not held, f"holds {len(held)} instructions of AVX: {held[:1]}")
            return f"runs, {code.count(chr(10))} lines of instructions without AVX"
        require(len(said.splitlines()) == 1, f"says not one line: {said[-300:]!r}")
        return require_refused(status, said, words[0].name, "needs avx")

    trials.attempt("one core", on_one_core)
    if not shutil.which("qemu-x86_64"):
        print("no qemu-x86_64: a processor without AVX is not tried")
        return
    for words in ((trials.case, "--method", METHOD), (trials.vnv, "list"), (trials.report, "--help"), (trials.guard, "begin", trials.scratch / "guarded")):
        trials.attempt(f"{words[0].name} without AVX", without_avx, *words)


# gnuplot.


def try_gnuplot(trials):
    real = shutil.which("gnuplot")

    def shown(folder, script, cause, longest=60):
        work = trials.work("report")
        work.prepare(folder)
        before = left.tree(folder / "site")
        (folder / "bin").mkdir()
        fake = folder / "bin" / "gnuplot"
        fake.write_text("#!/bin/sh\n" + script, encoding="utf-8")
        fake.chmod(0o755)
        began = time.monotonic()
        status, said = said_by(work.words(folder), env=os.environ | {"PATH": f"{folder / 'bin'}:{os.environ['PATH']}"})
        require(time.monotonic() - began < longest, "took too long")
        require(status == 3, f"ended with status {status}, expected 3: no pages were made; it said: {said[-300:]!r}")
        lines = [line for line in said.splitlines() if "gnuplot" in line and re.search(cause, line)]
        require(len(lines) == 1, f"{len(lines)} lines say why: {said[-300:]!r}")
        require(left.tree(folder / "site") == before, "the former site has changed")
        require(not list(folder.glob(".*")), "something is left")
        return lines[0]

    def missing(folder):
        work = trials.work("report")
        work.prepare(folder)
        status, said = said_by(work.words(folder), env=os.environ | {"PATH": str(folder)})
        require(status == 3 and "not found on PATH" in said, f"ended with status {status}: {said[-300:]!r}")
        require((folder / "site" / "verdicts.csv").is_file(), "no tables")

    trials.attempt("no gnuplot", missing)
    trials.attempt("a gnuplot that fails", shown, "echo no terminal >&2; exit 1\n", "no terminal")
    trials.attempt("a gnuplot that says nothing", shown, "exit 0\n", "ended early")
    trials.attempt("a gnuplot that is killed", shown, "kill -KILL $$\n", "Killed|ended early")
    trials.attempt("a gnuplot that dies halfway", shown, f"sed '/set print/,$d' | {real} \"$@\"\n", "ended early")
    trials.attempt("a gnuplot that hangs", shown, "exec sleep 1000\n", "longer than", 90)


# The browser that opens the pages.


def processes_of(mark):
    """Those that have it in their environment."""
    found = []
    for file in pathlib.Path("/proc").glob("[0-9]*/environ"):
        with contextlib.suppress(OSError):
            found += [file.parent.name] if mark.encode() in file.read_bytes() else []
    return found


def try_browser(trials):
    def opened(folder, script, cause, longest=30):
        (folder / "site").mkdir()
        (folder / "site" / "index.html").write_text("<p>A page.</p>", encoding="utf-8")
        fake = folder / "chromium"
        fake.write_text("#!/bin/bash\n" + script + "\n", encoding="utf-8")
        fake.chmod(0o755)
        gigabyte = (1 << 30, 1 << 30)
        status, said = said_by([sys.executable, "-B", ROOT / "reports" / "browser" / "browse.py", "chromium", folder / "site", "--longest", longest],
                               env=os.environ | {"PATH": f"{folder}:{os.environ['PATH']}"}, preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_AS, gigabyte))
        require(len(said.splitlines()) == 1, f"says not one line: {said[-300:]!r}")
        line = require_refused(status, said, "browse.py", cause)
        require(not processes_of(f"PATH={folder}:"), "it or one of its children lives on")
        return line

    trials.attempt("a browser that fails", opened, "exit 1", "ended before")
    trials.attempt("a browser that hangs", opened, "trap '' TERM; sleep 1000 & sleep 1000", "not answer within 2 s", 2)
    trials.attempt("a browser that prints without end", opened, "yes & yes >&2", "not answer within 2 s", 2)
    trials.attempt("a browser that answers without end", opened, "tr '\\0' x </dev/zero >&4", "more than 64 MiB")
    trials.attempt("a browser that tells without end of something else", opened, """yes '{"method": "Page.frameNavigated"}' | tr '\\n' '\\0' >&4""", "more than 64 MiB|within", 5)
    trials.attempt("a browser that speaks otherwise", opened, "printf 'no JSON\\0' >&4; sleep 1000", "expected a message in JSON")


PARTS = {"user": try_user, "at_once": try_at_once, "locale": try_locale, "path": try_path, "processor": try_processor, "gnuplot": try_gnuplot,
         "browser": try_browser}


def main(arguments):
    parser = Parser(__doc__)
    parser.add_argument("build", metavar="BUILD", type=pathlib.Path, help="build folder, only read")
    parser.add_argument("--only", nargs="+", choices=PARTS, default=PARTS, help="of the trials only these")
    options = parser.parse_args(arguments)
    build = options.build.resolve()
    for name in ("DASHBOARD_TEST_FROM_CTEST", "CTEST_INTERACTIVE_DEBUG_MODE"):
        os.environ.pop(name, None)  # vnv accept refuses to run in a test
    with tempfile.TemporaryDirectory(prefix="surroundings.") as held:
        scratch = pathlib.Path(held)
        Work(build, None)  # refuses a build folder without programs
        (scratch / "former").mkdir()
        status, said = said_by([build / "vnv" / CASE, "--method", METHOD, "--records", scratch / "former"])
        if status != 0:
            raise BadInput(f"{CASE}: ends with status {status}: {said.strip()[-300:]!r}")
        trials = Trials(build, scratch / "former", scratch)
        for part in options.only:
            if part == "user" and os.geteuid() != 0:
                print("only root can be another user: not tried")
                continue
            PARTS[part](trials)
    print(f"{trials.count} trials, {trials.failed} failed")
    return 1 if trials.failed else 0


if __name__ == "__main__":
    exit_with(main)
