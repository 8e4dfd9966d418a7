"""What the programs of a build do in a folder, what they leave there, and what of it must be whole whatever disturbs them."""

import contextlib
import json
import os
import pathlib
import shutil
import subprocess
import time

from shared import Trials, built, refusal, require, require_none, said_by, well

ROOT = pathlib.Path(__file__).resolve().parents[2]
DATA = ROOT / "data"
CASE, METHOD = "stokes_first", "mpm"
NAME = f"{CASE}.{METHOD}"

for name in ("DASHBOARD_TEST_FROM_CTEST", "CTEST_INTERACTIVE_DEBUG_MODE"):
    os.environ.pop(name, None)  # vnv accept refuses to run in a test


def is_whole(file):
    text = file.read_text(encoding="utf-8", errors="replace")
    if file.suffix == ".json":
        return "verdicts" in json.loads(text)
    if file.suffix == ".jsonl":
        lines = [json.loads(line) for line in text.splitlines()]
        return text.endswith("\n") and lines[0]["lines"] == len(lines) - 1
    ends = {".html": "</html>", ".svg": "</svg>"}
    return file.name == "stamp" or text.rstrip().endswith(ends.get(file.suffix, "")) and text != ""


def require_whole(folder):
    """No record, night or page in it is torn."""
    for file in sorted(file for place in ("records", "nights", "site") for file in (folder / place).rglob("*")):
        inner = file.relative_to(folder).parts
        if not file.is_file() or any(part.startswith(".") for part in inner) or {"logs", "inputs", "runs"} & set(inner):
            continue  # what is being written has a hidden name; the others are what programs said
        whole = False
        with contextlib.suppress(ValueError, KeyError, IndexError):
            whole = is_whole(file)
        require(whole, f"{file} is torn")


def half_written(folder):
    """Hidden names, which nothing that has ended leaves."""
    return [f"{file} is left" for file in sorted(folder.rglob(".*")) if file.name != ".lock"]


def verdicts(records):
    """{CASE.METHOD: what was judged, by which value, and how}"""
    keys = ("level", "time", "quantity", "author", "value", "outcome")
    found = {file.stem: json.loads(file.read_text(encoding="utf-8"))["verdicts"] for file in records.glob("*.json")}
    return {name: [[verdict[key] for key in keys] for verdict in all_of_it] for name, all_of_it in found.items()}


def tree(folder):
    """All that is in a folder, to be compared byte by byte."""
    return {str(file.relative_to(folder)): file.read_bytes() for file in sorted(folder.rglob("*")) if file.is_file()}


def refused_and_unchanged(words, place, cause, **more):
    """The line in which a program says that it may not write there, where nothing changes."""
    before = tree(place)
    line = refusal(words, place, cause, **more)
    require(tree(place) == before, "something was written")
    return line


def rows_of(table, but_for="#"):
    return [line for line in table.read_text(encoding="utf-8").splitlines() if not line.startswith(but_for)]


class Work:
    """What a program does in a folder, and what it may leave there."""

    def __init__(self, build, former=None):
        self.build, self.former = build, former  # records of before
        self.vnv, self.guard = built(build, "vnv/vnv"), built(build, "vnv/touchstone_guard")
        self.report, self.case = built(build, "reports/touchstone_report"), built(build, f"vnv/{CASE}")

    def prepare(self, folder):
        shutil.copytree(self.former, folder / "records")

    def words(self, folder):
        raise NotImplementedError

    def found(self, folder):
        """What is compared with what an undisturbed run leaves."""
        return verdicts(folder / "records")

    def done(self, folder):
        """What of it is there after it was killed."""
        return self.found(folder)

    def undisturbed(self, folder):
        """Does it once, for what is expected of it, and how long it takes [s]."""
        self.prepare(folder)
        began = time.monotonic()
        well(self.words(folder))
        self.seconds, self.expected = time.monotonic() - began, self.found(folder)
        return self

    def check(self, folder, status):
        """After it was disturbed; the status is None where it was killed."""
        require_whole(folder)

    def goes_on(self, folder):
        well(self.words(folder))
        require(self.found(folder) == self.expected, "undisturbed again it leaves something else")
        require_whole(folder)
        require_none(half_written(folder))


class OfCase(Work):
    def prepare(self, folder):
        (folder / "records").mkdir()

    def words(self, folder):
        return [self.case, "--method", METHOD, "--records", folder / "records"]


class OfRun(Work):
    def words(self, folder):
        return [self.vnv, "run", NAME, "--records", folder / "records", "--again"]

    def check(self, folder, status):
        super().check(folder, status)
        claims = folder / "claims"
        claims.mkdir()
        kept = [row for row in rows_of(DATA / "claims" / f"{CASE}.csv", "~") if row.startswith(("#", "suite,", f"acceptance,{METHOD},"))]
        (claims / f"{CASE}.csv").write_text("\n".join(kept) + "\n", encoding="utf-8")
        green, _ = said_by([self.report, folder / "records", folder / "site", "--claims", claims, "--whole"])
        require(green != 0 or self.found(folder) == self.expected, "the index is green without the verdicts")
        require(status != 0 or green == 0, "ended well, and the index is not green")


class OfReport(Work):
    """Pages made anew in the place of others."""

    def prepare(self, folder):
        super().prepare(folder)
        well(self.words(folder))
        (folder / "site" / "index.html").write_text("former</html>\n", encoding="utf-8")

    def words(self, folder):
        return [self.report, folder / "records", folder / "site", "--history", folder / "nights"]

    def found(self, folder):
        return tree(folder / "site")

    def check(self, folder, status):
        super().check(folder, status)
        site = self.found(folder)
        old = self.expected | {"index.html": b"former</html>\n"}
        require(site in (old, self.expected), f"the site is neither old nor new: {sorted(set(old) ^ set(site))}")


class OfAccept(Work):
    def prepare(self, folder):
        shutil.copytree(DATA, folder / "data")

    def words(self, folder):
        return [self.vnv, "--data", folder / "data", "accept", NAME, "--reason", "a trial"]

    def found(self, folder):
        return [rows_of(folder / "data" / place / f"{CASE}.csv", "# date") for place in ("baselines", "claims")]

    def check(self, folder, status):
        for one, old, new in zip(self.found(folder), self.found(ROOT), self.expected):
            require(one in (old, new), "accepted values are neither old nor new")
        names = lambda root: {name for name in tree(root) if "/." not in name}
        require(names(folder / "data") == names(DATA), "there are other data")


class OfGate(Work):
    def prepare(self, folder):
        for name in ("before", "after"):
            shutil.copytree(self.former, folder / name)

    def words(self, folder):
        return [self.vnv, "gate", folder / "before", folder / "after", "--json", folder / "gate.json", "--markdown", folder / "gate.md"]

    def found(self, folder):
        return [(folder / file).read_text(encoding="utf-8").replace(str(folder), "") for file in ("gate.json", "gate.md")]

    def check(self, folder, status):
        require(status in (0, 3), f"ended with status {status}, expected 3: nothing is worse")
        if (folder / "gate.json").is_file():
            json.loads((folder / "gate.json").read_text(encoding="utf-8"))


WORKS = {"case": OfCase, "run": OfRun, "report": OfReport, "accept": OfAccept, "gate": OfGate}


class TrialsOfWorks(Trials):
    """With records of before, of the one method."""

    def __init__(self, options):
        super().__init__(options)
        self.programs, self.former = Work(self.build), self.folder()
        well([self.programs.case, "--method", METHOD, "--records", self.former])

    def work(self, name):
        return WORKS[name](self.build, self.former)


class Trouble:
    """What a program meets: `run(words, folder, amount)` gives its status, what it said, and whether it met any."""

    first, step, place, leaves_nothing_hidden = 1, 1, staticmethod(contextlib.nullcontext), False

    def reason(self, said, folder):
        """The line that says why it ended early."""
        return next((line for line in said.splitlines() if ": " in line), "")


def disturbed(work, folder, trouble, amount):
    """Why it ended early, if it did, and whether it met the trouble."""
    with trouble.place(folder):
        work.prepare(folder)
        status, said, met = trouble.run(work.words(folder), folder, amount)
        require(0 <= status < 128, f"ended by signal, status {status}: {said[-200:]!r}")
        reason = trouble.reason(said, folder) if status != 0 else ""
        require(status == 0 or reason, f"ended with status {status} and does not say why: {said!r}")
        require(status != 0 or work.found(folder) == work.expected, "ended well without having done its work")
        if met:
            require_none(half_written(folder) if trouble.leaves_nothing_hidden else [])
            work.check(folder, status)
            work.goes_on(folder)
        return reason, met


@contextlib.contextmanager
def disk(folder, options="size=64k"):
    """A tmpfs there."""
    mount(folder, options)
    try:
        yield
    finally:
        subprocess.run(["umount", "-l", folder], check=True)


def mount(folder, options):
    subprocess.run(["mount", "-t", "tmpfs", "-o", options, "none", folder], check=True, capture_output=True)


def may_mount(folder):
    try:
        with disk(folder):
            return True
    except (OSError, subprocess.CalledProcessError):
        return False


class FullDisk(Trouble):
    """A disk with room for so much more than is there; afterwards it has enough."""

    ENOUGH = "size=1g,nr_inodes=100k"
    first, leaves_nothing_hidden = 0, True

    def __init__(self, option="size", step=1, name=""):
        self.option, self.step, self.name = option, step, name

    def place(self, folder):
        return disk(folder, self.ENOUGH)

    def run(self, words, folder, amount):
        at = os.statvfs(folder)
        used = (at.f_blocks - at.f_bfree) * at.f_bsize if self.option == "size" else at.f_files - at.f_ffree
        mount(folder, f"remount,{self.option}={max(used + amount, 1)}")  # 0 is no limit
        status, said = said_by(words)
        mount(folder, f"remount,{self.ENOUGH}")
        return status, said, status != 0
