#!/usr/bin/env python3
"""Interruptions: kills runs at random moments, fills their disk, forbids them to write, and checks what is left.

No record and no page may be torn, finished work is skipped by the next run, and what is done again gives the same
verdicts; where nothing can be written one line says where and why. The build folder is only read: all is written to a
scratch folder. A trial is a line. Exit status: 0 all trials passed; 1 one failed; 3 bad input.

Example: vnv/trials/interruptions/try.py build --kills 20 --seed 7
"""

import functools
import pathlib
import random
import re
import resource
import signal
import subprocess
import sys
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))

import shared  # noqa: E402
from shared import LONGEST, kill, only_line, processes, require, said_by, start, try_parts, until, well  # noqa: E402
from works import FullDisk, OfReport, Trouble, Work, disk, disturbed, may_mount, mount, refused_and_unchanged, tree, verdicts  # noqa: E402

WHOM = ("all of it", "the command alone", "one of its programs")
FULL = "No space left on device|File too large|disk.* full"
FORBIDDEN = "Read-only file system|Not a directory"


def members(session):
    """The processes of a session that still run."""
    return sorted(one for one, found in processes().items() if found.session == session and found.state != "Z")


def wait_for_orphans(session):
    until(lambda: not members(session), "what the killed one started")


def kill_at(words, moment, whom, choose):
    """Starts a program, kills it or a part of it after so many seconds, and waits for what then ends by itself. After a
    kill of the command alone what it has started goes on; its session is returned."""
    process = start(words, stdout=subprocess.DEVNULL)
    time.sleep(moment)
    parts = members(process.pid)
    others = [part for part in parts if part != process.pid]
    victims = {WHOM[0]: parts, WHOM[1]: [process.pid]}.get(whom) or [choose.choice(others or [process.pid])]
    while victims:
        kill(victims)
        victims = members(process.pid) if whom == WHOM[0] else []  # some were started while others were killed
    process.wait(LONGEST)
    return process.pid


class OfMethods(Work):
    """vnv run; the next one skips what was finished, and orphans of the killed one go on meanwhile."""

    session = None  # of the killed one

    def __init__(self, build, methods):
        super().__init__(build)
        self.methods = methods

    def prepare(self, folder):
        pass

    def words(self, folder, methods=None):
        return [self.vnv, "run", *(methods or self.methods), "-j", "2", "--records", folder / "records"]

    def done(self, folder):
        """Records that are taken for finished work, with the time when they were written."""
        records = folder / "records"
        names = [file.name for file in (records / "inputs").glob("*")
                 if re.fullmatch(r"suite \w+\nhash [0-9a-f]{16}\n", file.read_text(encoding="utf-8"))]
        files = {name: records / f"{name}.json" for name in names}
        return {name: file.stat().st_mtime_ns for name, file in files.items() if file.is_file()}

    def goes_on(self, folder):
        done = self.done(folder)
        said = well(self.words(folder))
        wait_for_orphans(self.session)
        skipped = int((re.search(r"(\d+) skipped", said) or [0, 0])[1])
        require(skipped == len(done), f"{skipped} skipped of {len(done)} that were finished")
        after = self.done(folder)
        require(all(after.get(name) == when for name, when in done.items()), "finished work was done again")
        require(self.found(folder) == self.expected, "other verdicts than undisturbed")
        super().goes_on(folder)  # an orphan that brought bytes to the disk ended after its method was done again


class OfOneMore(OfMethods):
    """The second of two methods is run where the first has a record, which stays."""

    def prepare(self, folder):
        well(self.words(folder, self.methods[:1]))
        self.earlier = tree(folder)

    def check(self, folder, status):
        super().check(folder, status)
        now = tree(folder)
        require(all(now.get(file) == text for file, text in self.earlier.items()), "an earlier record has changed")


class OfTests(OfMethods):
    """ctest with the tests of these methods; it does all again, for a suite starts with nothing."""

    def prepare(self, folder):
        lists = [self.build / "vnv" / "CTestTestfile.cmake", self.build / "reports" / "CTestTestfile.cmake",
                 *sorted((self.build / "vnv").glob("*_tests.cmake"))]
        text = "\n".join(line for file in lists for line in file.read_text(encoding="utf-8").splitlines()
                         if re.match(r"(add_test|set_tests_properties)\(\[=\[(?!selftest)\w+\.\w+\]=\]", line))  # which spans lines
        for kept in ("records", "site"):
            text = text.replace(f"{self.build}/{kept}/", f"{folder}/{kept}/")
        (folder / "CTestTestfile.cmake").write_text(text + "\n", encoding="utf-8")

    def words(self, folder):
        names = "|".join(name.replace(".", "[.]") if "." in name else f"{name}[.][a-z0-9_]+" for name in self.methods)
        return ["ctest", "--test-dir", folder, "-j", "2", "--no-tests=error", "-R", f"^({names})$"]

    def found(self, folder):
        return verdicts(folder / "records" / "acceptance")

    done = found

    def goes_on(self, folder):
        Work.goes_on(self, folder)
        require((folder / "site" / "acceptance" / "index.html").is_file(), "no pages")


class OfPagesAlone(OfReport):
    """Without a history, whose night would be the first file that is too long."""

    def words(self, folder):
        return super().words(folder)[:3]


class FullDiskSaidOnce(FullDisk):
    def reason(self, said, folder):
        return only_line(said, folder, FULL)


class ShortFiles(Trouble):
    """No file may be longer than so many bytes: a full disk without a mount."""

    leaves_nothing_hidden = True

    def reason(self, said, folder):
        return only_line(said, "/", FULL)  # it may be a file of /tmp

    def run(self, words, _, most):
        def limited():
            signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
            resource.setrlimit(resource.RLIMIT_FSIZE, (most, resource.RLIM_INFINITY))

        status, said = said_by(words, preexec_fn=limited, restore_signals=False)
        require(status != 0, f"ended well, expected no file of more than {most} bytes")
        return status, said, True


class Trials(shared.Trials):
    """With the methods, run once undisturbed, and pages of their records."""

    def __init__(self, options):
        if options.scratch:
            options.scratch.mkdir(parents=True, exist_ok=True)
        super().__init__(options, options.scratch)
        self.choose, usual = random.Random(options.seed), self.folder()
        self.has_disks = not options.mount_nothing and may_mount(self.folder())
        if not self.has_disks and {"full", "forbidden"} & set(options.only):
            print("no tmpfs is mounted: files are limited in length, and no disk is read-only")
        self.methods, self.records = OfMethods(self.build, options.methods).undisturbed(usual), usual / "records"

    @functools.cached_property
    def pages(self):
        return OfReport(self.build, self.records).undisturbed(self.folder())

    def kill(self, what, work, waits=True):
        """Who is killed in turn, when by chance; the next one waits for orphans, or does not."""

        def trial(folder, whom, moment):
            work.prepare(folder)
            work.session = kill_at(work.words(folder), moment, whom, self.choose)
            if waits:
                wait_for_orphans(work.session)
            work.check(folder, None)
            count = len(work.done(folder))
            work.goes_on(folder)
            return f"{count} of {len(work.expected)} were left"

        for k in range(self.options.kills):
            whom, moment = WHOM[k % 3], self.choose.uniform(0, work.seconds)
            self.attempt(f"{what}, {whom} killed after {moment:.2f} of {work.seconds:.2f} s", trial, self.folder(), whom, moment)


def try_tests(trials):
    tests = OfTests(trials.build, trials.options.methods).undisturbed(trials.folder())
    require(tests.expected == trials.methods.expected, "ctest gives other verdicts than vnv run")
    trials.kill("ctest", tests)


def try_full_disks(trials):
    """Records and pages where little space is left; afterwards there is enough, and the work goes on."""
    judged, choose = trials.methods.expected, trials.choose
    sizes = {name: (trials.records / f"{name}.json").stat().st_size for name in judged}
    first, second = min(sizes, key=sizes.get), max(sizes, key=sizes.get)
    one_more = OfOneMore(trials.build, [first, second])
    one_more.expected = {name: judged[name] for name in (first, second)}
    whole, most = sizes[second] + 4096 - sizes[second] % 4096, sizes[second] * 3 // 4  # the record goes in, and nothing beside it

    def trial(work, trouble, amount):
        return disturbed(work, trials.folder(), trouble, amount)[0] or "space enough"

    for what, work, spaces in (("vnv run", one_more, [0, 4096, *(choose.randrange(whole) for _ in range(3)), whole]),
                               ("touchstone_report", trials.pages, [0, *(choose.randrange(1 << 19) for _ in range(3))])):
        for space in spaces if trials.has_disks else []:
            trials.attempt(f"{what} on a full tmpfs, {space} bytes left", trial, work, FullDiskSaidOnce(), space)
    pages = OfPagesAlone(trials.build, trials.records).undisturbed(trials.folder())
    for what, work in (("vnv run", one_more), ("touchstone_report", pages)):
        trials.attempt(f"{what} with files of {most} bytes at most", trial, work, ShortFiles(), most)


def try_forbidden(trials):
    """A disk that is read-only, and a place below a file, where not even root can write."""
    name = next(iter(trials.methods.expected))
    case, method = name.split(".")
    of_one, folder, file = OfMethods(trials.build, [name]), trials.folder(), trials.folder() / "file"

    def calls_at(place):
        report = [of_one.report, trials.records]
        return {"vnv run": [*of_one.words(place), "--again"],
                "touchstone_report": [*report, place / "site"],
                "touchstone_report --history": [*report, folder / "site", "--history", place / "nights"],
                "touchstone_guard begin": [of_one.guard, "begin", place / "records"]}

    def trial(words, place):
        line = refused_and_unchanged(words, place, FORBIDDEN)
        require(not (folder / "site").exists(), "a site without its night was written")
        return line

    file.write_text("a file\n", encoding="utf-8")
    for what, words in calls_at(file).items():
        trials.attempt(f"{what} below a regular file", trial, words, file)
    if not trials.has_disks:
        return
    place = trials.folder()
    with disk(place, "size=8m"):
        well(of_one.words(place))
        mount(place, "remount,ro")
        alone = [trials.build / "vnv" / case, "--method", method, "--records", place / "records"]
        for what, words in (calls_at(place) | {f"{case} --records": alone}).items():
            trials.attempt(f"{what} on a read-only tmpfs", trial, words, place)


PARTS = {"run": lambda trials: trials.kill("vnv run", trials.methods, waits=False),
         "ctest": try_tests,
         "report": lambda trials: trials.kill("touchstone_report", trials.pages),
         "full": try_full_disks,
         "forbidden": try_forbidden}

if __name__ == "__main__":
    try_parts(__doc__, PARTS, Trials,
              kills={"type": int, "default": 20, "help": "of vnv run, of ctest and of touchstone_report each"},
              seed={"type": int, "default": 1, "help": "of the moments"},
              methods={"nargs": "+", "default": ["refinement", "shear_wave", "stokes_first"],
                       "help": "cases, or methods as CASE.METHOD, all of whose claims hold"},
              scratch={"type": pathlib.Path, "help": "folder to work in, removed in the end; else below /tmp"},
              mount_nothing={"action": "store_true", "help": "no tmpfs, also where this user may mount one"})
