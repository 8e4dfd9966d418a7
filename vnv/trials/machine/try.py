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

import errno
import functools
import os
import pathlib
import resource
import struct
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))

from shared import Failure, built, require, said_by, try_parts  # noqa: E402
from works import WORKS, FullDisk, TrialsOfWorks, Trouble, disturbed, may_mount  # noqa: E402

ERRORS = {"open": (errno.EACCES, errno.EMFILE), "write": (errno.ENOSPC, errno.EIO), "rename": (errno.EACCES, errno.ENOSPC),
          "fsync": (errno.EIO,), "mkdir": (errno.ENOSPC,), "fork": (errno.EAGAIN,), "clock": (-4000, 4000)}  # days
TROUBLES = (*ERRORS, "disk", "memory")


class FailingCall(Trouble):
    """The call of that number fails."""

    def __init__(self, call, error, build, scratch):
        self.count, self.name = scratch / "count", f"{call}: {errno.errorcode.get(error, f'{error} days')}"
        self.order, self.around = f"{call}:{error}", {"LD_PRELOAD": str(built(build, "vnv/libfailing_call.so")), "FAILING_IN": str(build),
                                                      "FAILING_COUNT": str(self.count)}

    def run(self, words, folder, which):
        self.count.write_bytes(bytes(8))
        status, said = said_by(words, env=os.environ | self.around | {"FAILING_CALL": f"{self.order}:{which}"})
        return status, said, struct.unpack("l", self.count.read_bytes())[0] >= which


class LittleMemory(Trouble):
    """So many megabytes; at first as many as the program needs to be loaded, and to say what it is (ulimit -v)."""

    name = "memory: 1 MB at a time"

    def __init__(self, program):
        self.first = next(megabytes for megabytes in range(1, 1000) if self.run([program, "--help"], None, megabytes)[0] == 0)

    def run(self, words, _, megabytes):
        limit = megabytes << 20
        status, said = said_by(words, preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_AS, (limit, limit)))
        return status, said, status != 0


def until_not_met(trials, work, trouble):
    """How many times a program met the trouble."""
    found, at_most = [], trials.options.first
    for count in range(at_most):
        try:
            if not disturbed(work, trials.folder("here"), trouble, trouble.first + count * trouble.step)[1]:
                break
        except (Failure, OSError, ValueError, subprocess.SubprocessError) as problem:
            found.append(f"\n  {count + 1}: {problem}")
    else:
        count = at_most
    require(not found, f"{count} times{''.join(found)}")
    return f"{count} times"


def troubles_of(trials, work):
    options, meets = trials.options, trials.options.troubles
    for call, errors in ERRORS.items():
        for error in errors[:1 if options.first_error else None] if call in meets else ():
            yield FailingCall(call, error, trials.build, trials.scratch)
    if "disk" in meets and may_mount(trials.folder()):
        yield FullDisk("size", options.blocks * 4096, f"disk: {options.blocks} blocks at a time")
        yield FullDisk("nr_inodes", 1, "disk: 1 files at a time")
    elif "disk" in meets:
        print("no tmpfs is mounted: no disk is full")
    if "memory" in meets:
        yield LittleMemory(work.words(trials.scratch)[0])


def try_work(trials, name):
    work = trials.work(name).undisturbed(trials.folder())
    for trouble in troubles_of(trials, work):
        trials.attempt(f"{name}, {trouble.name}", until_not_met, trials, work, trouble)


PARTS = {name: functools.partial(try_work, name=name) for name in WORKS}

if __name__ == "__main__":
    try_parts(__doc__, PARTS, TrialsOfWorks,
              troubles={"nargs": "+", "choices": TROUBLES, "default": TROUBLES, "help": "of the calls, disk and memory only these"},
              first={"type": int, "default": 10000, "help": "go on only so far"},
              first_error={"action": "store_true", "help": "of each call only one error"},
              blocks={"type": int, "default": 1, "help": "so many at a time, of 4 KB"})
