#!/usr/bin/env python3
"""Hostile inputs: gives each reader of text the samples of the project and what becomes of them when they are mutated.

With the touchstone_inputs of a build each sample and 200 mutations of it; with --runs, with the fuzz_inputs that Clang
builds, so many inputs that libFuzzer finds, under the address and undefined-behaviour sanitizers, none of which may
take longer than a second, or than --timeout on a machine with other work. A reader is a line. Exit status: 0 all inputs
were taken or refused in one line; 1 one was not: it is kept; 3 bad input.

Example: vnv/trials/inputs/try.py build-fuzz --runs 1000000 --corpora ~/corpora
"""

import functools
import pathlib
import re
import shutil
import sys

ROOT = pathlib.Path(__file__).resolve().parents[3]
sys.path.insert(0, str(ROOT / "vnv" / "trials"))

from shared import built, require, run, try_parts  # noqa: E402

SEEDS = {"table": ("data/experiments/*.csv", "data/papers/*.csv", "data/peers/*.csv"),
         "baselines": ("data/baselines/stokes_*.csv",),
         "claims": ("data/claims/*.csv",),
         "known_failures": ("data/known_failures.csv", "vnv/trials/inputs/seeds/known_failures/*"),
         "fault_trials": ("vnv/trials/inputs/seeds/fault_trials/*",),
         "references": ("data/references.bib",),
         "record": ("vnv/record/former_records/*", "vnv/trials/inputs/seeds/record/*"),
         "night": ("vnv/trials/inputs/seeds/night/*",),
         "solver": ("vnv/doors/peers/*.toml", "vnv/doors/examples/program/*.toml"),
         "flow": ("data/flows/*.toml",),
         "case_options": ("vnv/trials/inputs/seeds/case_options/*",),
         "command": ("vnv/trials/inputs/seeds/command/*",)}
SPOKEN_IN = ("vnv/command/main.cpp", "vnv/harness/options.cpp", "vnv/doors/solver_file.cpp", "vnv/flows/flow.cpp", "vnv/flows/formulas/*.cpp",
             "vnv/record/record.cpp",
             "vnv/record/accepted_claims.cpp", "vnv/judge/baselines.cpp", "vnv/files/tables.cpp", "reports/read/*.cpp")
EDGES = ("-1", "1e999", "-1e308", "5e-324", "18446744073709551616", "null", "2026-02-30", "'''", "[[", "{", "\ufeff", "\x1b[2J", "\r\n", "../")


def files_of(patterns):
    return [file for pattern in patterns for file in sorted(ROOT.glob(pattern))]


def write_dictionary(file):
    """The words of the readers and of their samples, as libFuzzer wants them."""
    words = set(EDGES)
    for path in files_of((*SPOKEN_IN, *SEEDS["record"], *SEEDS["night"])):
        words |= set(re.findall(r'"([^"\\\n]{1,30})"', path.read_text(encoding="utf-8")))
    quoted = lambda word: "".join(f"\\x{byte:02x}" if byte < 32 or byte > 126 or byte in b'"\\' else chr(byte) for byte in word.encode())
    file.write_text("".join(f'"{quoted(word)}"\n' for word in sorted(words)), encoding="utf-8")


def fuzzed(trials, program, reader):
    options, folder = trials.options, trials.folder()
    corpus = (options.corpora or folder) / reader
    corpus.mkdir(parents=True, exist_ok=True)
    for seed in files_of(SEEDS[reader]):
        shutil.copy(seed, corpus)
    write_dictionary(folder / "words")
    artifacts = (options.corpora or pathlib.Path.cwd()).resolve()
    done = run([program, reader, corpus, f"-runs={options.runs}", f"-seed={options.seed}",
                f"-timeout={options.timeout}", f"-dict={folder / 'words'}", "-max_len=1024", "-rss_limit_mb=1024", "-close_fd_mask=3",
                f"-artifact_prefix={artifacts}/{reader}-"])
    complaints = re.findall(r"ERROR:.*|SUMMARY:.*|runtime error:.*|.*Test unit written to.*", done.stdout)
    require(done.returncode == 0, "; ".join(complaints))
    found = re.findall(r"#(\d+)\s+(?:DONE|NEW|REDUCE|pulse).*?cov: (\d+)", done.stdout)
    return f"{found[-1][0]} inputs, {found[-1][1]} edges" if found else ""


def replayed(_, program, reader):
    """The last line that is said."""
    done = run([program, reader, *files_of(SEEDS[reader])])
    said = (done.stdout.splitlines() or [f"ended with status {done.returncode}"])[-1][:300]
    require(done.returncode == 0, said)
    return said


def try_reader(trials, reader):
    trial, program = (fuzzed, "fuzz_inputs") if trials.options.runs else (replayed, "touchstone_inputs")
    trials.attempt(reader, trial, trials, built(trials.build, f"reports/{program}"), reader)


if __name__ == "__main__":
    try_parts(__doc__, {reader: functools.partial(try_reader, reader=reader) for reader in SEEDS},
              runs={"type": int, "default": 0, "help": "inputs by libFuzzer of each reader, by a build of Clang"},
              seed={"type": int, "default": 1, "help": "of libFuzzer"},
              timeout={"type": int, "default": 1, "help": "longest time of an input [s]"},
              corpora={"type": pathlib.Path, "help": "folder that keeps what was found; else nothing is kept but what fails"})
