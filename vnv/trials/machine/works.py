"""What the programs of a build do in a folder, and what they may leave there when something disturbs them."""

import json
import os
import pathlib
import shutil
import sys

FOLDER = pathlib.Path(__file__).resolve().parent
sys.path[:0] = [str(FOLDER.parent), str(FOLDER.parent / "interruptions")]

import left  # noqa: E402
from shared import BadInput, require, run  # noqa: E402

CASE, METHOD = "stokes_first", "mpm"
NAME = f"{CASE}.{METHOD}"
DATA = FOLDER.parents[2] / "data"


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
