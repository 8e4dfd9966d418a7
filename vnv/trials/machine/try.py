#!/usr/bin/env python3
"""A machine in trouble: lets the first, second, third call and so on of open, write, rename, fsync, mkdir and fork fail,
until a program ends without having made so many, and checks what is left.

Records, baselines and pages are old or new and never torn, a program that ends well has done all that it does
undisturbed, any other says why, no index is green without the verdicts, and the next run does what was left undone. The
build folder is only read. A program and a call are a line. Exit status: 0 all held; 1 something did not; 3 bad input.

Example: vnv/trials/machine/try.py build
"""

import errno
import json
import os
import pathlib
import shutil
import struct
import sys
import tempfile

FOLDER = pathlib.Path(__file__).resolve().parent
sys.path[:0] = [str(FOLDER.parent), str(FOLDER.parent / "interruptions")]

import left  # noqa: E402
from shared import BadInput, Parser, exit_with, run  # noqa: E402

ERRORS = {"open": (errno.EACCES, errno.EMFILE), "write": (errno.ENOSPC, errno.EIO), "rename": (errno.EACCES, errno.ENOSPC),
          "fsync": (errno.EIO,), "mkdir": (errno.ENOSPC,), "fork": (errno.EAGAIN,)}
CASE, METHOD = "stokes_first", "mpm"
NAME = f"{CASE}.{METHOD}"
DATA = FOLDER.parents[2] / "data"


class Failure(Exception):
    """What did not hold, in one line."""


def require(condition, words):
    if not condition:
        raise Failure(words)


def copied(source, to):
    shutil.copytree(source, to, dirs_exist_ok=True)
    return to


class Work:
    """What a program does in a folder, and what it may leave there."""

    def __init__(self, build, former):
        self.vnv, self.report, self.case = build / "vnv" / "vnv", build / "reports" / "touchstone_report", build / "vnv" / CASE
        self.former = former  # records of before
        for program in (self.vnv, self.report, self.case):
            if not os.access(program, os.X_OK):
                raise BadInput(f"{program}: cannot be run, expected a program of a build folder")

    def prepare(self, folder):
        if self.former:
            copied(self.former, folder / "records")

    def words(self, folder):
        raise NotImplementedError

    def found(self, folder):
        """What is compared with what an undisturbed run leaves."""
        return left.verdicts(folder / "records")

    def check(self, folder, status, expected):
        require(not left.torn(folder / "records"), f"torn: {left.torn(folder / 'records')}")

    def goes_on(self, folder, expected):
        status, said = said_by(self.words(folder))
        require(status == 0, f"undisturbed again it ends with status {status}: {said[-200:]!r}")
        require(self.found(folder) == expected, "undisturbed again it leaves something else")


class OfCase(Work):
    def prepare(self, folder):
        (folder / "records").mkdir()

    def words(self, folder):
        return [self.case, "--method", METHOD, "--records", folder / "records"]


class OfRun(Work):
    def words(self, folder):
        return [self.vnv, "run", NAME, "--records", folder / "records", "--again"]

    def check(self, folder, status, expected):
        super().check(folder, status, expected)
        claims = folder / "claims"
        claims.mkdir()
        lines = (DATA / "claims" / f"{CASE}.csv").read_text(encoding="utf-8").splitlines(keepends=True)
        kept = [line for line in lines if line.startswith(("#", "suite,", f"acceptance,{METHOD},"))]
        (claims / f"{CASE}.csv").write_text("".join(kept), encoding="utf-8")
        green, _ = said_by([self.report, folder / "records", folder / "site", "--claims", claims, "--whole"])
        require(green != 0 or self.found(folder) == expected, "the index is green without the verdicts")
        require(status != 0 or green == 0, "ended well, and the index is not green")


class OfReport(Work):
    def prepare(self, folder):
        super().prepare(folder)
        said_by(self.words(folder))
        (folder / "site" / "index.html").write_text("former</html>\n", encoding="utf-8")

    def words(self, folder):
        return [self.report, folder / "records", folder / "site", "--history", folder / "nights"]

    def found(self, folder):
        return left.tree(folder / "site")

    def check(self, folder, status, expected):
        require(not left.torn(folder / "nights"), "a night is torn")
        site = self.found(folder)
        old = expected | {"index.html": b"former</html>\n"}
        require(site in (old, expected), f"the site is neither old nor new: {sorted(set(old) ^ set(site))}")


class OfAccept(Work):
    def prepare(self, folder):
        copied(DATA, folder / "data")

    def words(self, folder):
        return [self.vnv, "--data", folder / "data", "accept", NAME, "--reason", "a trial"]

    def found(self, folder):
        rows = lambda file: [line for line in file.read_text(encoding="utf-8").splitlines() if not line.startswith("# date")]
        return [rows(folder / "data" / place / f"{CASE}.csv") for place in ("baselines", "claims")]

    def check(self, folder, status, expected):
        for one, old, new in zip(self.found(folder), self.found(FOLDER.parents[2]), expected):
            require(one in (old, new), "accepted values are neither old nor new")
        names = lambda root: {name for name in left.tree(root) if "/." not in name}
        require(names(folder / "data") == names(DATA), "there are other data")


class OfGate(Work):
    def prepare(self, folder):
        copied(self.former, folder / "before")
        copied(self.former, folder / "after")

    def words(self, folder):
        return [self.vnv, "gate", folder / "before", folder / "after", "--json", folder / "gate.json", "--markdown", folder / "gate.md"]

    def found(self, folder):
        return [(folder / file).read_text(encoding="utf-8").replace(str(folder), "") for file in ("gate.json", "gate.md")]

    def check(self, folder, status, expected):
        require(status in (0, 3), f"ended with status {status}, expected 3: nothing is worse")
        if (folder / "gate.json").is_file():
            json.loads((folder / "gate.json").read_text(encoding="utf-8"))


WORKS = {"case": OfCase, "run": OfRun, "report": OfReport, "accept": OfAccept, "gate": OfGate}


def said_by(words, **more):
    done = run(words, timeout=120, **more)
    return done.returncode, done.stdout


class Trial:
    def __init__(self, work, library, build, scratch):
        self.work, self.library, self.build, self.scratch = work, library, build, scratch
        self.folder = scratch / "here"
        self.fresh()
        status, said = said_by(work.words(self.folder))
        if status != 0:
            raise BadInput(f"{work.words(self.folder)[0]}: ends with status {status} undisturbed: {said.strip()[-300:]!r}")
        self.expected = work.found(self.folder)

    def fresh(self):
        shutil.rmtree(self.folder, ignore_errors=True)
        self.folder.mkdir()
        self.work.prepare(self.folder)

    def disturbed(self, call, error, which):
        """Whether there was such a call."""
        self.fresh()
        count = self.scratch / "count"
        count.write_bytes(bytes(8))
        trouble = {"LD_PRELOAD": str(self.library), "FAILING_CALL": f"{call}:{error}:{which}", "FAILING_COUNT": str(count),
                   "FAILING_IN": str(self.build)}
        status, said = said_by(self.work.words(self.folder), env=os.environ | trouble)
        if struct.unpack("l", count.read_bytes())[0] < which:
            return False
        require(status >= 0 and status < 128, f"ended by signal, status {status}: {said[-200:]!r}")
        if status == 0:
            require(self.work.found(self.folder) == self.expected, "ended well without having done its work")
        else:
            require(any(": " in line for line in said.splitlines()), f"ended with status {status} and does not say why: {said!r}")
        self.work.check(self.folder, status, self.expected)
        self.work.goes_on(self.folder, self.expected)
        return True


def attempt(trial, call, error, options):
    """Complaints, and how many calls were let fail."""
    found, which = [], 0
    while which < options.first:
        which += 1
        try:
            if not trial.disturbed(call, error, which):
                return found, which - 1
        except (Failure, OSError) as problem:
            found.append(f"{call} {which}, {errno.errorcode[error]}: {problem}")
    return found, which


def main(arguments):
    parser = Parser(__doc__)
    parser.add_argument("build", metavar="BUILD", type=pathlib.Path, help="build folder, only read")
    parser.add_argument("--only", nargs="+", choices=WORKS, default=WORKS, help="of the programs only these")
    parser.add_argument("--calls", nargs="+", choices=ERRORS, default=ERRORS, help="of the calls only these")
    parser.add_argument("--first", type=int, default=10000, help="let only so many of the first calls fail")
    parser.add_argument("--first-error", action="store_true", help="of each call only one error")
    options = parser.parse_args(arguments)
    build = options.build.resolve()
    library = build / "vnv" / "libfailing_call.so"
    if not library.is_file():
        raise BadInput(f"{library}: not there, expected it to be built")
    for name in ("DASHBOARD_TEST_FROM_CTEST", "CTEST_INTERACTIVE_DEBUG_MODE"):
        os.environ.pop(name, None)  # vnv accept refuses to run in a test
    failed = 0
    with tempfile.TemporaryDirectory(prefix="machine.") as held:
        scratch = pathlib.Path(held)
        (scratch / "former").mkdir()
        status, said = said_by([build / "vnv" / CASE, "--method", METHOD, "--records", scratch / "former"])
        if status != 0:
            raise BadInput(f"{CASE}: ends with status {status}: {said.strip()[-300:]!r}")
        for name in options.only:
            trial = Trial(WORKS[name](build, scratch / "former"), library, build, scratch)
            for call in options.calls:
                for error in ERRORS[call][:1] if options.first_error else ERRORS[call]:
                    found, count = attempt(trial, call, error, options)
                    failed += len(found)
                    print(f"{'FAILED' if found else 'passed'} {name}, {call}: {errno.errorcode[error]} {count} times", flush=True)
                    for line in found:
                        print(f"  {line}", flush=True)
    print(f"{failed} failed")
    return 1 if failed else 0


if __name__ == "__main__":
    exit_with(main)
