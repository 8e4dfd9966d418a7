#!/usr/bin/env python3
"""Interruptions: kills runs at random moments, fills their disk, forbids them to write, and checks what is left.

No record and no page may be torn, finished work is skipped by the next run, and what is done again gives the same
verdicts; where nothing can be written one line says where and why. The build folder is only read: all is written to a
scratch folder. A trial is a line. Exit status: 0 all trials passed; 1 one failed; 3 bad input.

Example: vnv/trials/interruptions/try.py build --kills 20 --seed 7
"""

import contextlib
import os
import pathlib
import random
import re
import resource
import signal
import subprocess
import sys
import tempfile
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))

import left  # noqa: E402
import shared  # noqa: E402
from shared import BadInput, Parser, Trials, exit_with, require  # noqa: E402

WHOM = ("all of it", "the command alone", "one of its programs")
CAUSES = re.compile("No space left on device|File too large|Read-only file system|Not a directory|disk.* full")
LONGEST = 300  # s, of a program
PARTS = ("run", "ctest", "report", "full", "forbidden")


def require_none(complaints):
    require(not complaints, "; ".join(complaints[:3]))


class Programs:
    """Those of a build folder, and what is run with them."""

    def __init__(self, build, methods):
        self.build, self.methods = build, methods
        self.vnv, self.report = build / "vnv" / "vnv", build / "reports" / "touchstone_report"
        self.guard = build / "vnv" / "touchstone_guard"
        for program in (self.vnv, self.report, self.guard):
            if not os.access(program, os.X_OK):
                raise BadInput(f"{program}: cannot be run, expected a program of a build folder")

    def run(self, records, methods=None):
        return [self.vnv, "run", *(methods or self.methods), "-j", "2", "--records", records]


def run(words, **more):
    """Exit status and what was said."""
    done = shared.run(words, timeout=LONGEST, **more)
    return done.returncode, done.stdout


def wait_for_orphans(session):
    end = time.monotonic() + LONGEST
    while left.members(session) and time.monotonic() < end:
        time.sleep(0.02)


def kill_at(words, moment, whom, choose):
    """Starts a program, kills it or a part of it after so many seconds, and waits for what then ends by itself. After a
    kill of the command alone what it has started goes on; its session is returned."""
    process = subprocess.Popen([str(word) for word in words], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                               start_new_session=True)
    time.sleep(moment)
    parts = left.members(process.pid)
    others = [part for part in parts if part != process.pid]
    victims = {WHOM[0]: parts, WHOM[1]: [process.pid]}.get(whom) or [choose.choice(others or [process.pid])]
    while victims:
        for victim in victims:
            with contextlib.suppress(ProcessLookupError):
                os.kill(victim, signal.SIGKILL)
        victims = left.members(process.pid) if whom == WHOM[0] else []  # some were started while others were killed
    process.wait(LONGEST)
    return process.pid


def said_once(result, place):
    """That a program failed by itself and said in one line where and why."""
    status, output = result
    lines = [line for line in output.splitlines() if str(place) in line and CAUSES.search(line)]
    require(status > 0, f"ended with status {status}, expected a failure; it said: {output.strip()[-200:]!r}")
    require(len(lines) == 1, f"{len(lines)} lines say where and why, expected one; it said: {output.strip()[-300:]!r}")
    return lines[0].strip()


def timed(words):
    began = time.monotonic()
    status, output = run(words)
    if status != 0:
        raise BadInput(f"{words[0]}: ends with status {status} undisturbed: {output.strip()[-300:]!r}")
    return time.monotonic() - began


def done_again(words):
    """What was said by a program that ends well after it was killed."""
    status, output = run(words)
    require(status == 0, f"done again it ended with status {status}: {output.strip()[-300:]!r}")
    return output


def attempt_kills(trials, what, kills, choose, usual, trial):
    """Of a program that takes `usual` seconds: `trial(whom, moment, k)`, whom it meets in turn, when by chance."""
    for k in range(kills):
        whom, moment = WHOM[k % 3], choose.uniform(0, usual)
        trials.attempt(f"{what}, {whom} killed after {moment:.2f} of {usual:.2f} s", lambda: trial(whom, moment, k))


def kill_runs(programs, folder, trials, kills, choose):
    """vnv run is killed; what was finished then is skipped."""
    usual = timed(programs.run(folder / "usual"))
    expected = left.verdicts(folder / "usual")

    def trial(whom, moment, records):
        session = kill_at(programs.run(records), moment, whom, choose)
        require_none(left.torn(records))
        done = left.finished(records)
        output = done_again(programs.run(records))
        wait_for_orphans(session)
        skipped = int((re.search(r"(\d+) skipped", output) or [0, 0])[1])
        require(skipped == len(done), f"{skipped} skipped of {len(done)} that were finished")
        after = left.finished(records)
        require(all(after.get(name) == when for name, when in done.items()), "finished work was done again")
        require(left.verdicts(records) == expected, "other verdicts than undisturbed")
        if left.half_written(records):  # an orphan that brought bytes to the disk ended after its method was done again
            done_again(programs.run(records))
        require_none(left.torn(records) + left.half_written(records))
        return f"{len(done)} of {len(expected)} methods were finished"

    attempt_kills(trials, "vnv run", kills, choose, usual,
                  lambda whom, moment, k: trial(whom, moment, folder / f"run{k}"))
    return folder / "usual"


def write_tests(programs, folder):
    """A folder of ctest with the tests of these methods, which write here; says how to run them."""
    lists = [programs.build / "vnv" / "CTestTestfile.cmake", programs.build / "reports" / "CTestTestfile.cmake",
             *sorted((programs.build / "vnv").glob("*_tests.cmake"))]
    lines = [line for file in lists for line in file.read_text(encoding="utf-8").splitlines()
             if re.match(r"(add_test|set_tests_properties)\(\[=\[(?!selftest)\w+\.\w+\]=\]", line)]  # which spans lines
    text = "\n".join(lines) + "\n"
    for kept in ("records", "site"):
        text = text.replace(f"{programs.build}/{kept}/", f"{folder}/{kept}/")
    folder.mkdir(parents=True)
    (folder / "CTestTestfile.cmake").write_text(text, encoding="utf-8")
    names = "|".join(name.replace(".", "[.]") if "." in name else f"{name}[.][a-z0-9_]+" for name in programs.methods)
    return ["ctest", "--test-dir", folder, "-j", "2", "--no-tests=error", "-R", f"^({names})$"]


def kill_tests(programs, folder, trials, kills, choose, usual_records):
    """ctest is killed; it does all again, for a suite starts with nothing."""
    usual = timed(write_tests(programs, folder / "usual"))
    expected = left.verdicts(usual_records)

    def trial(whom, moment, place):
        words = write_tests(programs, place)
        records, site = place / "records" / "acceptance", place / "site" / "acceptance"
        session = kill_at(words, moment, whom, choose)
        wait_for_orphans(session)
        require_none(left.torn(records, site))
        judged = len(left.verdicts(records))
        done_again(words)
        require(left.verdicts(records) == expected, "other verdicts than those of vnv run")
        require((site / "index.html").is_file(), "no pages")
        require_none(left.torn(records, site) + left.half_written(records) + left.half_written(site.parent))
        return f"{judged} of {len(expected)} methods had a record"

    attempt_kills(trials, "ctest", kills, choose, usual,
                  lambda whom, moment, k: trial(whom, moment, folder / f"test{k}"))


def kill_reports(programs, folder, trials, kills, choose, records):
    """touchstone_report is killed while it makes anew what is there."""
    folder.mkdir()
    site, nights = folder / "site", folder / "nights"
    words = [programs.report, records, site, "--history", nights]
    usual = timed(words)
    expected = left.tree(site)

    def trial(whom, moment):
        wait_for_orphans(kill_at(words, moment, whom, choose))
        require(left.tree(site) == expected, "the former site is not there as it was")
        require_none(left.torn(site, nights))
        done_again(words)
        require(left.tree(site) == expected, "other pages than undisturbed")
        require_none(left.half_written(folder) + left.half_written(nights))
        return f"{len(expected)} files as before"

    attempt_kills(trials, "touchstone_report", kills, choose, usual, lambda whom, moment, _: trial(whom, moment))


@contextlib.contextmanager
def small_disk(folder, size):
    """A disk of so many bytes."""
    folder.mkdir(parents=True)
    subprocess.run(["mount", "-t", "tmpfs", "-o", f"size={size}", "none", folder], check=True, capture_output=True)
    try:
        yield folder
    finally:
        subprocess.run(["umount", "-l", folder], check=True)


def may_mount(folder):
    try:
        with small_disk(folder, "64k"):
            return True
    except (OSError, subprocess.CalledProcessError):
        return False


def fill(disk, but_for):
    """Fills a disk but for so many bytes."""
    free = os.statvfs(disk)
    (disk / "ballast").write_bytes(bytes(max(0, free.f_bavail * free.f_bsize - but_for)))


def fill_disks(programs, folder, trials, choose, records):
    """Records and pages where little space is left; afterwards there is enough, and the work goes on."""
    sizes = {name: (records / f"{name}.json").stat().st_size for name in left.verdicts(records)}
    first, second = min(sizes, key=sizes.get), max(sizes, key=sizes.get)
    expected = {name: judged for name, judged in left.verdicts(records).items() if name in (first, second)}

    def of_records(disk, space):
        here = disk / "records"
        require(run(programs.run(here, [first]))[0] == 0, f"{first} fails with space enough")
        earlier = left.tree(here)
        fill(disk, space)
        result = run(programs.run(here, [second]))
        if result[0] != 0:
            line = said_once(result, here)
            now = left.tree(here)
            require(all(now.get(file) == text for file, text in earlier.items()), "an earlier record has changed")
            require_none(left.torn(here) + left.half_written(here))
        (disk / "ballast").unlink()
        require(run(programs.run(here, [first, second]))[0] == 0, "with space again it fails")
        require(left.verdicts(here) == expected, "with space again other verdicts")
        return line if result[0] != 0 else "space enough"

    def of_pages(disk, space):
        site, nights = disk / "site", disk / "nights"
        words = [programs.report, records, site, "--history", nights]
        require(run(words)[0] == 0, "fails with space enough")
        earlier = left.tree(site)
        fill(disk, space)
        result = run(words)
        line = said_once(result, disk) if result[0] != 0 else "space enough"
        require(left.tree(site) == earlier, "the former site has changed")
        require_none(left.torn(nights) + left.half_written(disk) + left.half_written(nights))
        return line

    whole = sizes[second] + 4096 - sizes[second] % 4096  # the record goes in, and nothing beside it
    for k, space in enumerate([0, 4096, *(choose.randrange(whole) for _ in range(3)), whole]):
        with small_disk(folder / f"disk{k}", "8m") as disk:
            trials.attempt(f"vnv run on a full tmpfs, {space} bytes left", lambda: of_records(disk, space))
    for k, space in enumerate([0, *(choose.randrange(1 << 19) for _ in range(3))]):
        with small_disk(folder / f"site{k}", "64m") as disk:
            trials.attempt(f"touchstone_report on a full tmpfs, {space} bytes left", lambda: of_pages(disk, space))


def limit_files(programs, folder, trials, records):
    """No file may be longer than so many bytes, fewer than the largest record has: a full disk without a mount."""
    largest = max(records.glob("*.json"), key=lambda file: file.stat().st_size)
    most = largest.stat().st_size * 3 // 4

    def limited():
        signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
        resource.setrlimit(resource.RLIMIT_FSIZE, (most, resource.RLIM_INFINITY))

    def trial(words):
        line = said_once(run(words, preexec_fn=limited, restore_signals=False), "/")  # it may be a file of /tmp
        require_none(left.torn(folder) + left.half_written(folder) + left.half_written(folder / "records"))
        return line

    folder.mkdir()
    for what, words in {"vnv run": programs.run(folder / "records", [largest.stem]),
                        "touchstone_report": [programs.report, records, folder / "site"]}.items():
        trials.attempt(f"{what} with files of {most} bytes at most", lambda: trial(words))


def forbid_writing(programs, folder, trials, records, has_disks):
    """A disk that is read-only, and a place below a file, where not even root can write."""
    name = next(iter(left.verdicts(records)))
    case, method = name.split(".")

    def calls_at(place):
        report = [programs.report, records]
        return {"vnv run": [*programs.run(place / "records", [name]), "--again"],
                "touchstone_report": [*report, place / "site"],
                "touchstone_report --history": [*report, folder / "site", "--history", place / "nights"],
                "touchstone_guard begin": [programs.guard, "begin", place / "records"]}

    def trial(words, place):
        before = left.tree(place) if place.is_dir() else None
        line = said_once(run(words), place)
        require(before is None or left.tree(place) == before, "something was written")
        require(not (folder / "site").exists(), "a site without its night was written")
        return line

    folder.mkdir()
    file = folder / "file"
    file.write_text("a file\n", encoding="utf-8")
    for what, words in calls_at(file).items():
        trials.attempt(f"{what} below a regular file", lambda: trial(words, file))
    if not has_disks:
        return
    with small_disk(folder / "disk", "8m") as disk:
        run(programs.run(disk / "records", [name]))
        subprocess.run(["mount", "-o", "remount,ro", disk], check=True)
        alone = [programs.build / "vnv" / case, "--method", method, "--records", disk / "records"]
        for what, words in (calls_at(disk) | {f"{case} --records": alone}).items():
            trials.attempt(f"{what} on a read-only tmpfs", lambda: trial(words, disk))


def options_of(arguments):
    parser = Parser(__doc__)
    parser.add_argument("build", metavar="BUILD", type=pathlib.Path, help="build folder, only read")
    parser.add_argument("--kills", type=int, default=20, help="of vnv run, of ctest and of touchstone_report each")
    parser.add_argument("--seed", type=int, default=1, help="of the moments")
    parser.add_argument("--methods", nargs="+", default=["refinement", "shear_wave", "stokes_first"],
                        help="cases, or methods as CASE.METHOD, all of whose claims hold")
    parser.add_argument("--scratch", type=pathlib.Path, help="folder to work in, removed in the end; else below /tmp")
    parser.add_argument("--only", nargs="+", choices=PARTS, default=PARTS, help="of the trials only these")
    parser.add_argument("--mount-nothing", action="store_true", help="no tmpfs, also where this user may mount one")
    return parser.parse_args(arguments)


def main(arguments):
    options = options_of(arguments)
    programs, choose, trials = Programs(options.build.resolve(), options.methods), random.Random(options.seed), Trials()
    if options.scratch:
        options.scratch.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory(prefix="interruptions.", dir=options.scratch) as scratch:
        folder = pathlib.Path(scratch)
        has_disks = not options.mount_nothing and may_mount(folder / "disk")
        if not has_disks and {"full", "forbidden"} & set(options.only):
            print("no tmpfs is mounted: files are limited in length, and no disk is read-only")
        records = kill_runs(programs, folder, trials, options.kills if "run" in options.only else 0, choose)
        if "ctest" in options.only:
            kill_tests(programs, folder / "ctest", trials, options.kills, choose, records)
        if "report" in options.only:
            kill_reports(programs, folder / "report", trials, options.kills, choose, records)
        if "full" in options.only:
            if has_disks:
                fill_disks(programs, folder / "full", trials, choose, records)
            limit_files(programs, folder / "limited", trials, records)
        if "forbidden" in options.only:
            forbid_writing(programs, folder / "forbidden", trials, records, has_disks)
    print(f"{trials.count} trials, {trials.failed} failed")
    return 1 if trials.failed else 0


if __name__ == "__main__":
    exit_with(main)
