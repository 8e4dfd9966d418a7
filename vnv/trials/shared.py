"""What all trials have in common: complaints of one line, programs that are run to their end, and how a trial itself ends."""

import argparse
import os
import signal
import subprocess
import sys


class BadInput(Exception):
    """Where, what, and what was expected, in one line that gives a terminal no orders."""

    def __str__(self):
        return "".join(letter if letter.isprintable() else "?" for letter in super().__str__())


class Failure(Exception):
    """What a trial found, in one line."""


def require(condition, words):
    if not condition:
        raise Failure(words)


class Trials:
    """Runs trials and counts them."""

    def __init__(self):
        self.count, self.failed = 0, 0

    def attempt(self, what, work):
        self.count += 1
        try:
            found, word = work(), "passed"
        except (Failure, BadInput, subprocess.TimeoutExpired, OSError) as error:
            found, word, self.failed = str(error), "FAILED", self.failed + 1
        print(f"{word} {what}: {found}", flush=True)


class Parser(argparse.ArgumentParser):
    """A command line that is refused in one line."""

    def __init__(self, description):
        super().__init__(description=description, formatter_class=argparse.RawDescriptionHelpFormatter)

    def error(self, message):
        raise BadInput(f"try.py: {message}")


def run(words, timeout=None, **more):
    """Runs a program to its end, of so many seconds at most; whoever breaks off here ends all that it started, so that nothing is written later."""
    words = [str(word) for word in words]
    with subprocess.Popen(words, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, errors="replace",
                          start_new_session=True, **more) as process:
        try:
            output = process.communicate(timeout=timeout)[0]
        except BaseException:
            os.killpg(process.pid, signal.SIGTERM)
            raise
        return subprocess.CompletedProcess(words, process.returncode, output)


def exit_with(main):
    """Exit status 3 for bad input, with one line that says what; ends in order when it is terminated."""
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(3))
    try:
        sys.exit(main(sys.argv[1:]))
    except BadInput as error:
        print(error, file=sys.stderr)
        sys.exit(3)
