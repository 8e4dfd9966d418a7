#!/usr/bin/env python3
"""Hostile inputs: gives each reader of text the samples of the project and what becomes of them when they are mutated.

With the touchstone_inputs of a build each sample and 200 mutations of it; with --runs, with the fuzz_inputs that Clang
builds, so many inputs that libFuzzer finds, under the address and undefined-behaviour sanitizers, none of which may
take longer than a second, or than --timeout on a machine with other work. A reader is a line. Exit status: 0 all inputs
were taken or refused in one line; 1 one was not: it is kept; 3 bad input.

Example: vnv/trials/inputs/try.py build-fuzz --runs 1000000 --corpora ~/corpora
"""

import pathlib
import re
import shutil
import sys
import tempfile

FOLDER = pathlib.Path(__file__).resolve().parent
ROOT = FOLDER.parents[2]
sys.path.insert(0, str(FOLDER.parent))

from shared import BadInput, Parser, exit_with, run  # noqa: E402

SEEDS = {"table": ("data/experiments/*.csv", "data/papers/*.csv", "data/peers/*.csv"),
         "baselines": ("data/baselines/stokes_*.csv",),
         "claims": ("data/claims/*.csv",),
         "known_failures": ("data/known_failures.csv", "vnv/trials/inputs/seeds/known_failures/*"),
         "fault_trials": ("vnv/trials/inputs/seeds/fault_trials/*",),
         "references": ("data/references.bib",),
         "record": ("vnv/record/former_records/*", "vnv/trials/inputs/seeds/record/*"),
         "night": ("vnv/trials/inputs/seeds/night/*",),
         "solver": ("vnv/peers/*.toml", "vnv/doors/examples/program/*.toml"),
         "case_options": ("vnv/trials/inputs/seeds/case_options/*",),
         "command": ("vnv/trials/inputs/seeds/command/*",)}
SPOKEN_IN = ("vnv/command/main.cpp", "vnv/harness/options.cpp", "vnv/doors/solver_file.cpp", "vnv/flows/flow.cpp", "vnv/record/record.cpp",
             "vnv/record/accepted_claims.cpp", "vnv/judge/baselines.cpp", "vnv/files/tables.cpp", "reports/read/*.cpp")
EDGES = ("-1", "1e999", "-1e308", "5e-324", "18446744073709551616", "null", "2026-02-30", "'''", "[[", "{", "\ufeff", "\x1b[2J", "\r\n", "../")


def seeds_of(reader):
    return [file for pattern in SEEDS[reader] for file in sorted(ROOT.glob(pattern))]


def write_dictionary(file):
    """The words of the readers and of their samples, as libFuzzer wants them."""
    words = set(EDGES)
    for path in [path for pattern in SPOKEN_IN for path in ROOT.glob(pattern)] + seeds_of("record") + seeds_of("night"):
        words |= set(re.findall(r'"([^"\\\n]{1,30})"', path.read_text(encoding="utf-8")))
    quoted = lambda word: "".join(f"\\x{byte:02x}" if byte < 32 or byte > 126 or byte in b'"\\' else chr(byte) for byte in word.encode())
    file.write_text("".join(f'"{quoted(word)}"\n' for word in sorted(words)), encoding="utf-8")


def fuzz(program, reader, folder, options):
    corpus = (options.corpora or folder) / reader
    corpus.mkdir(parents=True, exist_ok=True)
    for seed in seeds_of(reader):
        shutil.copy(seed, corpus)
    write_dictionary(folder / "words")
    done = run([program, reader, corpus, f"-runs={options.runs}", f"-seed={options.seed}", f"-dict={folder / 'words'}", f"-timeout={options.timeout}", "-max_len=1024",
                "-rss_limit_mb=1024", "-close_fd_mask=3", f"-artifact_prefix={(options.corpora or pathlib.Path.cwd()).resolve()}/{reader}-"])
    found = re.findall(r"#(\d+)\s+(?:DONE|NEW|REDUCE|pulse).*?cov: (\d+)", done.stdout)
    return done.returncode, f"{found[-1][0]} inputs, {found[-1][1]} edges" if done.returncode == 0 and found else "; ".join(re.findall(r"ERROR:.*|SUMMARY:.*|runtime error:.*|.*Test unit written to.*", done.stdout))


def main(arguments):
    parser = Parser(__doc__)
    parser.add_argument("build", metavar="BUILD", type=pathlib.Path, help="build folder; with --runs of Clang")
    parser.add_argument("--only", nargs="+", choices=SEEDS, default=SEEDS, metavar="READER", help=", ".join(SEEDS))
    parser.add_argument("--runs", type=int, default=0, help="inputs by libFuzzer of each reader")
    parser.add_argument("--seed", type=int, default=1, help="of libFuzzer")
    parser.add_argument("--timeout", type=int, default=1, help="longest time of an input [s]")
    parser.add_argument("--corpora", type=pathlib.Path, help="folder that keeps what was found; else nothing is kept but what fails")
    options = parser.parse_args(arguments)
    program = options.build.resolve() / "reports" / ("fuzz_inputs" if options.runs else "touchstone_inputs")
    if not program.is_file():
        raise BadInput(f"{program}: not there, expected it to be built")
    failed = 0
    with tempfile.TemporaryDirectory() as folder:
        for reader in options.only:
            if options.runs:
                status, said = fuzz(program, reader, pathlib.Path(folder), options)
            else:
                done = run([program, reader, *seeds_of(reader)])
                status, said = done.returncode, (done.stdout.splitlines() or [f"ended with status {done.returncode}"])[-1][:300]
            failed += status != 0
            print(f"{'passed' if status == 0 else 'FAILED'} {reader}: {said}", flush=True)
    return 1 if failed else 0


if __name__ == "__main__":
    exit_with(main)
