#!/usr/bin/env python3
"""A machine in trouble: lets the first, second, third call and so on of open, write, rename, fsync, mkdir and fork fail,
sets the clock back or forth at the first question for it, the second and so on,
gives the disk room for one block more, then two, for one file more, then two, or the program a megabyte more of memory
than its --help needs, then two, until a program meets no trouble, and checks what is left.

Records, baselines and pages are old or new and never torn, a program that ends well has done all that it does
undisturbed, any other says why, no index is green without the verdicts, and the next run does what was left undone. The
build folder is only read. Disks need root. A program and a trouble are a line. Exit status: 0 all held; 1 something did
not; 3 bad input.

Example: vnv/trials/machine/try.py build
"""

import contextlib
import errno
import os
import pathlib
import resource
import shutil
import struct
import subprocess
import sys
import tempfile

FOLDER = pathlib.Path(__file__).resolve().parent
sys.path[:0] = [str(FOLDER), str(FOLDER.parent)]

from shared import BadInput, Failure, Parser, exit_with, require  # noqa: E402
from works import CASE, METHOD, WORKS, said_by  # noqa: E402

ERRORS = {"open": (errno.EACCES, errno.EMFILE), "write": (errno.ENOSPC, errno.EIO), "rename": (errno.EACCES, errno.ENOSPC),
          "fsync": (errno.EIO,), "mkdir": (errno.ENOSPC,), "fork": (errno.EAGAIN,), "clock": (-4000, 4000)}  # days
TROUBLES = (*ERRORS, "disk", "memory")


class FailingCall:
    """The call of that number fails."""

    place = contextlib.nullcontext

    def __init__(self, call, error, preloaded, build, scratch):
        self.call, self.error, self.preloaded, self.build, self.count = call, error, preloaded, build, scratch / "count"
        self.name = f"{call}: {errno.errorcode.get(error, f'{error} days')}"

    def run(self, words, folder, which):
        """Exit status, what was said, and whether there was such a call."""
        self.count.write_bytes(bytes(8))
        trouble = {"LD_PRELOAD": str(self.preloaded), "FAILING_CALL": f"{self.call}:{self.error}:{which}", "FAILING_COUNT": str(self.count),
                   "FAILING_IN": str(self.build)}
        status, said = said_by(words, env=os.environ | trouble)
        return status, said, struct.unpack("l", self.count.read_bytes())[0] >= which


class FullDisk:
    """A disk with room for so many steps of blocks, or of files, more than are there; afterwards it has enough."""

    ENOUGH = "size=1g,nr_inodes=100k"

    def __init__(self, what, step):
        self.option, self.step, self.name = {"blocks": "size", "files": "nr_inodes"}[what], step, f"disk: {step} {what} at a time"

    @contextlib.contextmanager
    def place(self, folder):
        self.mount(folder, self.ENOUGH)
        try:
            yield
        finally:
            subprocess.run(["umount", "-l", folder], check=True)

    @staticmethod
    def mount(folder, options):
        subprocess.run(["mount", "-t", "tmpfs", "-o", options, "none", folder], check=True, capture_output=True)

    def run(self, words, folder, which):
        disk = os.statvfs(folder)
        used = (disk.f_blocks - disk.f_bfree) * disk.f_bsize if self.option == "size" else disk.f_files - disk.f_ffree
        more = (which - 1) * self.step * (disk.f_bsize if self.option == "size" else 1)
        self.mount(folder, f"remount,{self.option}={max(used + more, 1)}")  # 0 is no limit
        status, said = said_by(words)
        self.mount(folder, f"remount,{self.ENOUGH}")
        return status, said, status != 0


class LittleMemory:
    """So many steps of a megabyte more than the program needs to be loaded, and to say what it is (ulimit -v)."""

    name, place = "memory: 1 MB at a time", contextlib.nullcontext

    def __init__(self, words):
        enough = lambda megabytes: self.limited([words[0], "--help"], megabytes)[0] == 0
        self.least = next(megabytes for megabytes in range(1, 1000) if enough(megabytes))

    @staticmethod
    def limited(words, megabytes):
        limit = megabytes << 20
        return said_by(words, preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_AS, (limit, limit)))

    def run(self, words, folder, which):
        status, said = self.limited(words, self.least + which - 1)
        return status, said, status != 0


class Trial:
    def __init__(self, work, folder):
        self.work, self.folder = work, folder
        self.fresh()
        self.work.prepare(folder)
        status, said = said_by(work.words(folder))
        if status != 0:
            raise BadInput(f"{work.words(folder)[0]}: ends with status {status} undisturbed: {said.strip()[-300:]!r}")
        self.expected = work.found(folder)

    def fresh(self):
        shutil.rmtree(self.folder, ignore_errors=True)
        self.folder.mkdir()

    def disturbed(self, trouble, which):
        """Whether the program met it."""
        self.fresh()
        with trouble.place(self.folder):
            self.work.prepare(self.folder)
            status, said, met = trouble.run(self.work.words(self.folder), self.folder, which)
            require(0 <= status < 128, f"ended by signal, status {status}: {said[-200:]!r}")
            if status == 0:
                require(self.work.found(self.folder) == self.expected, "ended well without having done its work")
            else:
                require(any(": " in line for line in said.splitlines()), f"ended with status {status} and does not say why: {said!r}")
            if met:
                self.work.check(self.folder, status, self.expected)
                self.work.goes_on(self.folder, self.expected)
            return met

    def attempt(self, trouble, first):
        """Complaints, and how many times it met the trouble."""
        found = []
        for which in range(1, first + 1):
            try:
                if not self.disturbed(trouble, which):
                    return found, which - 1
            except (Failure, OSError, subprocess.TimeoutExpired) as problem:
                found.append(f"{trouble.name} {which}: {problem}")
        return found, first


def may_mount(folder):
    try:
        with FullDisk("blocks", 1).place(folder):
            return True
    except (OSError, subprocess.CalledProcessError):
        return False


def main(arguments):
    parser = Parser(__doc__)
    parser.add_argument("build", metavar="BUILD", type=pathlib.Path, help="build folder, only read")
    parser.add_argument("--only", nargs="+", choices=WORKS, default=WORKS, help="of the programs only these")
    parser.add_argument("--troubles", nargs="+", choices=TROUBLES, default=TROUBLES, help="of the calls, disk and memory only these")
    parser.add_argument("--first", type=int, default=10000, help="go on only so far")
    parser.add_argument("--first-error", action="store_true", help="of each call only one error")
    parser.add_argument("--blocks", type=int, default=1, help="so many at a time, of 4 KB")
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
        (scratch / "disk").mkdir()
        has_disks = "disk" in options.troubles and may_mount(scratch / "disk")
        if "disk" in options.troubles and not has_disks:
            print("no tmpfs is mounted: no disk is full")
        for name in options.only:
            trial = Trial(WORKS[name](build, scratch / "former"), scratch / "here")
            troubles = [FailingCall(call, error, library, build, scratch) for call in ERRORS if call in options.troubles
                        for error in (ERRORS[call][:1] if options.first_error else ERRORS[call])]
            troubles += [FullDisk("blocks", options.blocks), FullDisk("files", 1)] if has_disks else []
            troubles += [LittleMemory(trial.work.words(trial.folder))] if "memory" in options.troubles else []
            for trouble in troubles:
                found, count = trial.attempt(trouble, options.first)
                failed += len(found)
                print(f"{'FAILED' if found else 'passed'} {name}, {trouble.name} {count} times", flush=True)
                for line in found:
                    print(f"  {line}", flush=True)
    print(f"{failed} failed")
    return 1 if failed else 0


if __name__ == "__main__":
    exit_with(main)
