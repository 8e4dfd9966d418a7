#!/usr/bin/env python3
"""Each command that README, CONTRIBUTING, IS_MY_SOLVER_RIGHT and the examples of --help print, run as it is printed.

They are run in folders that look like the project beside its programs, which are those of BUILD, with the files that they
name; what would log in or queue elsewhere is run here. BUILD and the sources are only read. A command that nothing here runs,
and one here that no text prints, is a failure, too. A command is a line. Exit status: 0 all do what they should; 1 one does
not; 3 bad input.

Example: vnv/trials/commands/try.py build
"""

import os
import pathlib
import re
import shutil
import subprocess
import sys
import time

FOLDER = pathlib.Path(__file__).resolve().parent
sys.path[:0] = [str(FOLDER.parent), str(FOLDER.parent / "faults")]

import files  # noqa: E402
import known  # noqa: E402
import seeded  # noqa: E402
import texts  # noqa: E402
from shared import Parser, Trials, built, exit_with, require, require_none, said_by, well  # noqa: E402

ROOT = texts.ROOT
TWO = ("invariance_cavity", "invariance_patch")  # nights of seconds
LONGEST = 7200  # s
OF_OTHERS = ("CTEST_", "DASHBOARD_", "TOUCHSTONE_", "RC_PARAMS", "GIT_", "CI")  # would change what a command does


def copied(build, here, cases):
    """A folder that looks like the project built there, in part if so."""
    shutil.rmtree(here, ignore_errors=True)
    (here / "build/vnv").mkdir(parents=True)
    (here / "build/reports").mkdir()
    for file in ROOT.iterdir():
        if not file.name.startswith((".git", "build")) and file.name != "data":
            (here / file.name).symlink_to(file)
    shutil.copytree(ROOT / "data", here / "data")
    (here / "build/data").symlink_to(here / "data")  # where programs look first
    names = (build / "vnv/cases.txt").read_text(encoding="utf-8").split()
    wanted = [name for name in names if cases is None or name in cases]
    programs = ["reports/touchstone_report", *(f"vnv/{name}" for name in ("vnv", "touchstone_guard", *wanted))]
    tests = [f"vnv/{file.name}" for file in (build / "vnv").glob("*.cmake")]
    for name in ["vnv/cases.txt", *programs, *tests]:  # not all: other tests make files there and remove them
        if not (build / name).is_file():
            continue
        try:
            os.link(build / name, here / "build" / name)
        except OSError:  # on another file system
            shutil.copy(build / name, here / "build" / name)
    built = [name for name in wanted if (here / "build/vnv" / name).is_file()]
    (here / "build/vnv/cases.txt").unlink()
    (here / "build/vnv/cases.txt").write_text("\n".join(built) + "\n", encoding="utf-8")
    cache = (build / "CMakeCache.txt").read_text(encoding="utf-8")
    cache = re.sub("^(TOUCHSTONE_HISTORY:.*=).*", rf"\1{build}/history", cache, flags=re.MULTILINE).replace(str(build), str(here / "build"))
    (here / "build/CMakeCache.txt").write_text(re.sub("^(CMAKE_HOME_DIRECTORY:.*=).*", rf"\1{here}", cache, flags=re.MULTILINE), encoding="utf-8")


def surroundings(scratch):
    environment = {name: value for name, value in os.environ.items() if not name.startswith(OF_OTHERS)}
    return {**environment, "ASKED": str(scratch / "asked"), "PYTHONDONTWRITEBYTECODE": "1", "LANG": "C.UTF-8",
            "PATH": os.pathsep.join(("build/vnv", "build/reports", str(FOLDER / "standins"), os.environ["PATH"]))}


def printed_as(entry, printed):
    """All forms in which the texts print it."""
    return [command for command in printed if re.sub(r"(^|(?<= ))build/vnv/vnv ", "vnv ", command) == entry.command]


def try_one(entry, command, scratch):
    """What it says is what it should say, and so is how it ends."""
    began, here, around = time.monotonic(), scratch / entry.folder, surroundings(scratch)
    (scratch / "asked").write_text("", encoding="utf-8")
    if entry.change:
        commit(entry.change, here)
    if entry.first:
        well(["bash", "-c", entry.first], LONGEST, cwd=here, env=around, stdin=subprocess.DEVNULL)
    script = f"{command}{entry.also}\nstatus=$?\n{entry.then}\nexit $status\n"
    status, said = said_by(["zsh" if entry.needs == "zsh" else "bash", "-c", script], LONGEST, cwd=here, env=around, stdin=subprocess.DEVNULL)
    require(status == entry.status, f"ended with status {status}, expected {entry.status}; it said: {said[-1000:]!r}")
    require(re.search(entry.says, said, re.MULTILINE), f"expected it to say '{entry.says}'; it said: {said[-3000:]!r}")
    return f"{time.monotonic() - began:.1f} s"


def by_day(build, scratch):
    copied(build, scratch / "project", None)
    copied(build, scratch / "two", TWO)
    copied(build, scratch / "main", TWO)
    files.write_all(build, ROOT / "vnv/doors/examples", scratch / "project")


def git(clone, *words):
    well(["git", "-C", clone, "-c", "user.name=Trial", "-c", "user.email=trial@example.org", *words])


def by_night(_, scratch):
    shutil.rmtree(scratch / "clone", ignore_errors=True)
    git(ROOT, "clone", "-q", ROOT, scratch / "clone")


def of_gates(build, scratch):
    by_night(build, scratch)
    git(scratch / "clone", "tag", "before")
    (scratch / "clone/build/vnv").mkdir(parents=True)
    shutil.copy(build / "vnv/vnv", scratch / "clone/build/vnv")


def commit(change, clone):
    """The clone's last commit makes this change and nothing else."""
    git(clone, "reset", "-q", "--hard", "before")
    for file, (_, after) in seeded.changed(seeded.read(FOLDER.parent / change), clone).items():
        (clone / file).write_text(after, encoding="utf-8")
    git(clone, "commit", "-q", "-a", "-m", change)


PARTS = {"day": (known.BY_DAY, by_day), "night": (known.BY_NIGHT, by_night), "gates": (known.GATES, of_gates)}


def unknown(printed):
    """What is printed and not run, and what is run and not printed."""
    entries = [entry for entries, _ in PARTS.values() for entry in entries]
    on_bare_machines = [part for line in texts.of_first_block() for part in (line, *line.split(" && "))]  # .ci/bare takes them from there
    run_here = {command for entry in entries for command in printed_as(entry, printed)}
    for command, where in printed.items():
        if command not in run_here and command not in on_bare_machines and not any(texts.begins(command, other) for other in run_here):
            yield f"{where}: '{command}': nothing runs it; expected it in vnv/trials/commands/known.py"
    for entry in entries:
        if not printed_as(entry, printed):
            yield f"vnv/trials/commands/known.py: '{entry.command}': no text prints it"


def main(arguments):
    parser = Parser(__doc__)
    parser.take_build()
    parser.add_argument("--part", choices=PARTS, default="day", help="day: what takes seconds; night: what builds, in a clone; gates: of revisions of a clone")
    parser.add_argument("--only", default="", help="regular expression of commands")
    parser.add_argument("--scratch", type=pathlib.Path, help="folder to work in, which is kept; else one that is gone afterwards")
    options = parser.parse_args(arguments)
    printed = texts.printed(*(built(options.build, name) for name in ("vnv/vnv", "vnv/stokes_first", "reports/touchstone_report")))
    entries, prepare = PARTS[options.part]
    if options.part != "day" and not (ROOT / ".git").exists():
        print(f"SKIP: {ROOT} is no repository of git, of which a clone could be made")
        return 0
    with Trials(options) as trials:
        trials.attempt("what is printed and what is run", lambda: require_none(list(unknown(printed))))
        scratch = options.scratch.resolve() if options.scratch else trials.folder("of commands")
        prepare(options.build, scratch)
        for entry in entries:
            for command in printed_as(entry, printed):
                if not re.search(options.only, f"{command}{entry.also}"):
                    continue
                if entry.needs and not shutil.which(entry.needs):
                    print(f"left out {command}: no {entry.needs}")
                else:
                    trials.attempt(command + entry.also, try_one, entry, command, scratch)
        return trials.conclude()


if __name__ == "__main__":
    exit_with(main)
