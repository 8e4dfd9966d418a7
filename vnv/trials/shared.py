"""What all trials have in common: complaints of one line, programs that are run to their end, trials that are counted, and
how a command ends."""

import argparse
import contextlib
import os
import pathlib
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import typing

LONGEST = 300  # s, of a program


class BadInput(Exception):
    """Where, what, and what was expected, in one line that gives a terminal no orders."""

    def __str__(self):
        return "".join(letter if letter.isprintable() else "?" for letter in super().__str__())


class Failure(Exception):
    """What a trial found, in one line; outside of a trial, why none can be made."""


def require(condition, words):
    if not condition:
        raise Failure(words)


def require_none(complaints):
    require(not complaints, "; ".join(complaints[:3]))


class Trials(contextlib.ExitStack):
    """Runs trials, says in a line what came of each, and counts them; what they write is gone in the end."""

    def __init__(self, options, below=None):
        super().__init__()
        self.options, self.build, self.folders, self.count, self.failed = options, options.build, 0, 0, 0
        self.scratch = pathlib.Path(self.enter_context(tempfile.TemporaryDirectory(prefix="trials.", dir=below)))

    def folder(self, name=None):
        """An empty one, in the place of any that had this name."""
        self.folders += 1
        made = self.scratch / (name or str(self.folders))
        shutil.rmtree(made, ignore_errors=True)
        made.mkdir()
        return made

    def attempt(self, what, trial, *given):
        self.count += 1
        try:
            found, word = trial(*given), "passed"
        except (BadInput, Failure, OSError, ValueError, subprocess.SubprocessError) as problem:
            found, word, self.failed = str(problem), "FAILED", self.failed + 1
        print(f"{word} {what}{f': {found}' if found else ''}", flush=True)

    def conclude(self):
        """The exit status."""
        print(f"{self.count} trials, {self.failed} failed")
        return 1 if self.failed else 0


class Parser(argparse.ArgumentParser):
    """A command line that is refused in one line."""

    def __init__(self, description):
        super().__init__(description=description, formatter_class=argparse.RawDescriptionHelpFormatter)

    def take_build(self):
        self.add_argument("build", metavar="BUILD", type=lambda text: pathlib.Path(text).resolve(), help="build folder, only read")

    def error(self, message):
        raise BadInput(f"try.py: {message}")


def try_parts(description, parts, kind=Trials, **more):
    """The whole command: trials in parts, each a function of the trials, in this order; `more` are options of the command line."""

    def main(arguments):
        parser = Parser(description)
        parser.take_build()
        parser.add_argument("--only", nargs="+", choices=parts, default=list(parts), help="of the trials only these")
        for option, given in more.items():
            parser.add_argument("--" + option.replace("_", "-"), **given)
        options = parser.parse_args(arguments)
        with kind(options) as trials:
            for part in parts:
                if part in options.only:
                    parts[part](trials)
            return trials.conclude()

    exit_with(main)


def built(build, name):
    """A program of a build folder, or a library."""
    if not os.access(build / name, os.X_OK):
        raise BadInput(f"{build / name}: cannot be run, expected it to be built")
    return build / name


def start(words, **more):
    """A program that leads a session of its own, and whose words can be read."""
    more = {"stdout": subprocess.PIPE, "stderr": subprocess.STDOUT, "text": True, "errors": "replace", "start_new_session": True} | more
    return subprocess.Popen([str(word) for word in words], **more)


def run(words, timeout=None, **more):
    """Runs a program to its end, of so many seconds at most; whoever breaks off here ends all that it started, so that nothing is written later."""
    with start(words, **more) as process:
        try:
            output = process.communicate(timeout=timeout)[0]
        except BaseException:
            os.killpg(process.pid, signal.SIGTERM)
            raise
        return subprocess.CompletedProcess(process.args, process.returncode, output)


def said_by(words, timeout=LONGEST, **more):
    """Exit status, and what was said."""
    done = run(words, timeout, **more)
    return done.returncode, done.stdout


def require_end(words, status, said, expected=(0,)):
    """What was said by a program that ended as it should."""
    words = " ".join(str(word) for word in words[:3])
    require(status in expected, f"{words}: ended with status {status}, expected {expected[0]}; it said: {said.strip()[-300:]!r}")
    return said


def well(words, timeout=LONGEST, **more):
    """What is said by a program that ends well."""
    return require_end(words, *said_by(words, timeout, **more))


def refusal(words, place, cause, **more):
    """The one line in which a program that fails by itself says where and why."""
    status, said = said_by(words, **more)
    require(0 < status < 128, f"ended with status {status}, expected a failure; it said: {said.strip()[-200:]!r}")
    return only_line(said, place, cause)


def only_line(said, place, cause):
    lines = [line for line in said.splitlines() if str(place) in line and re.search(cause, line)]
    require(len(lines) == 1, f"{len(lines)} lines say where and why, expected one; it said: {said.strip()[-300:]!r}")
    return lines[0].strip()


class Process(typing.NamedTuple):
    state: str
    parent: int
    session: int
    name: str
    environment: tuple


def processes():
    """{id: what runs}"""
    found = {}
    for place in pathlib.Path("/proc").glob("[0-9]*"):
        with contextlib.suppress(OSError, ValueError, IndexError):  # it has ended meanwhile
            name, rest = (place / "stat").read_text().split("(", 1)[1].rsplit(")", 1)
            state, parent, _, session = rest.split()[:4]
            around = (place / "environ").read_bytes().decode(errors="replace").split("\0")
            found[int(place.name)] = Process(state, int(parent), int(session), name, tuple(around))
    return found


def kill(victims, kind=signal.SIGKILL):
    for victim in victims:
        with contextlib.suppress(ProcessLookupError):
            os.kill(victim, kind)


def until(holds, what, longest=LONGEST):
    """Waits for it, so many seconds at most."""
    end = time.monotonic() + longest
    while not holds():
        require(time.monotonic() < end, f"{what}: not within {longest} s")
        time.sleep(0.03)


def exit_with(main):
    """Exit status 3 for bad input, with one line that says what; ends in order when it is terminated."""
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(3))
    try:
        sys.exit(main(sys.argv[1:]))
    except (BadInput, Failure) as problem:
        print(problem, file=sys.stderr)
        sys.exit(3)
