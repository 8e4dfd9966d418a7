#!/usr/bin/env python3
"""Engines: the same methods here, on two hosts of ssh by GNU parallel and on two nodes of Slurm, all of them this machine.

Verdicts and errors are equal to the last bit, whatever is killed, nothing that has ended is lost or run again, and what
breaks off cancels what it submitted and nothing else. A trial is a line; an engine that is not installed is a line that
says so. Exit status: 0 all trials passed; 1 one failed; 3 bad input.

Example: vnv/trials/engines/try.py build --methods couette poiseuille
"""

import contextlib
import json
import os
import pathlib
import re
import resource
import signal
import subprocess
import sys
import tempfile
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))

import cluster  # noqa: E402
import made_up  # noqa: E402
import shared  # noqa: E402
from shared import BadInput, Parser, Trials, exit_with, require  # noqa: E402

LONGEST = 900  # s, of a program
LONGEST_SUITE = 4 * 3600  # s, of `equal`
PARTS = ("equal", "killed", "cancelled", "overhead", "many")
NEEDS = {"parallel": ("parallel", "sshd", "ssh-keygen"), "slurm": ("sbatch", "slurmctld", "slurmd")}
EQUAL = ("shear_wave", "stokes_first", "couette")
MEAN = 17  # s, of processor time, that a method of a whole night takes: 86 minutes of one core for 300 methods


class Engine:
    """How `vnv run` uses an engine, and how one of its machines is ended."""

    def __init__(self, name, options, daemons=None, machines=()):
        self.name, self.options, self.daemons, self.machines = name, options, daemons, machines


def installed(name):
    if program := cluster.missing(*NEEDS[name]):
        print(f"SKIP: {name}: no {program}")
    return not program


@contextlib.contextmanager
def engines_here(folder, names):
    """Local, and of the named engines all that are installed."""
    with contextlib.ExitStack() as stack:
        found = [Engine("local", [])]
        names = [name for name in names if installed(name)]
        if "parallel" in names:
            hosts, daemons = stack.enter_context(cluster.ssh_hosts(folder / "ssh"))
            (folder / "hosts").write_text("\n".join(hosts) + "\n", encoding="utf-8")
            found.append(Engine("parallel", ["--engine", "parallel", "--hosts", folder / "hosts"], daemons, ["h1", "h2"]))
        if "slurm" in names:
            daemons = stack.enter_context(cluster.slurm(folder / "slurm"))
            found.append(Engine("slurm", ["--engine", "slurm"], daemons, ["n1", "n2"]))
        yield found


def cpu_of_children():  # s
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def judged(records, timed):
    """{CASE.METHOD: values, verdicts and orders, as they were written but for costs; methods that are timed run as long
    as their timing takes, so of these also but for the time that was reached}"""
    found = {}
    for file in sorted(records.glob("*.json")):
        record = json.loads(file.read_text(encoding="utf-8"))
        values = [value for value in record["values"] if value["quantity"]["kind"] != "cost"]
        verdicts = [verdict for verdict in record["verdicts"] if verdict["kind"] != "cost"]
        if file.stem in timed:
            values, verdicts = ([{key: of for key, of in one.items() if key not in ("time", "sentence")} for one in all_of]
                                for all_of in (values, verdicts))
        found[file.stem] = json.dumps([values, verdicts, record["orders"]])
    return found


def timed_methods(vnv, suite):
    words = [vnv, "list", "--suite", suite, "--json"]  # of cases that are not built it speaks on the other stream
    listed = json.loads(subprocess.run(words, check=True, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL).stdout)
    return {f"{method['case']}.{method['method']}" for method in listed if method["timed"]}


def run(vnv, records, engine, methods=(), options=(), longest=LONGEST):
    done = shared.run([vnv, "run", *methods, "--records", records, *engine.options, *options], timeout=longest)
    return done.returncode, done.stdout


def try_equal(vnv, folder, engines, trials, methods, suite, night):
    """The same methods by all engines, or a night that was run here by all others."""
    timed = timed_methods(vnv, suite)
    expected = {"judged": judged(night, timed)} if night else {}

    def trial(engine):
        records, began = folder / engine.name, time.monotonic()
        status, output = run(vnv, records, engine, methods, ["--suite", suite], LONGEST_SUITE)
        took, found = time.monotonic() - began, judged(records, timed)
        expected.setdefault("status", status)
        expected.setdefault("judged", found)
        require(found, f"nothing was judged; it said: {output.strip()[-300:]!r}")
        require(status == expected["status"], f"status {status}, expected {expected['status']}: {output.strip()[-300:]!r}")
        differs = [name for name in found | expected["judged"] if found.get(name) != expected["judged"].get(name)]
        require(not differs, f"{len(differs)} methods differ from local: {' '.join(differs)}")
        again = run(vnv, records, engine, methods, ["--suite", suite])[1]
        require(f"{len(found)} skipped" in again, f"not all is skipped the next time: {again.strip()[-200:]!r}")
        return f"{len(found)} methods judged as by local, {took:.0f} s"

    for engine in engines:
        if engine.machines or not night:
            trials.attempt(f"{suite} by {engine.name}", lambda: trial(engine))


def start(vnv, build, records, engine):
    return subprocess.Popen([str(word) for word in (vnv, "run", "--build", build.folder, "--records", records, *engine.options)],
                            stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, start_new_session=True)


def ended(records):
    return {file.name for file in (records / "engine" / "ended").glob("[!.]*")}


def wait_for_ends(records, count):
    end = time.monotonic() + LONGEST
    while len(ended(records)) < count and time.monotonic() < end:
        time.sleep(0.05)


def try_killed(vnv, folder, engines, trials, program, record):
    """A machine is killed with all that runs there, or `vnv` alone."""

    def lost_machine(engine):
        build = made_up.MadeUp(folder / f"{engine.name}.build", program, record, 4, 3, 4, 60)
        records = folder / engine.name
        process = start(vnv, build, records, engine)
        wait_for_ends(records, 2)
        time.sleep(3)  # in the middle of the next two
        engine.daemons.kill(engine.machines[0])
        before, began = ended(records), time.monotonic()
        output = process.communicate(timeout=LONGEST)[0]
        require(process.returncode == 0, f"ended with status {process.returncode}: {output.strip()[-400:]!r}")
        require(f"{build.count} of {build.count} methods hold" in output, output.strip()[-400:])
        runs = build.runs()
        again = sorted(name for name in set(runs) if runs.count(name) > 1)
        require(not before & set(again), f"ended and was run again: {sorted(before & set(again))}")
        require(all(runs.count(name) == 2 for name in again), f"run more than twice: {again}")
        return f"{len(before)} of {build.count} had ended, {len(again)} tried again, all hold {time.monotonic() - began:.0f} s later"

    def vnv_alone(engine):
        build = made_up.MadeUp(folder / f"{engine.name}.vnv.build", program, record, 4, 3, 1, 60)
        records = folder / f"{engine.name}.vnv"
        process = start(vnv, build, records, engine)
        wait_for_ends(records, 3)
        process.kill()
        process.communicate()
        before = ended(records)
        status, output = run(vnv, records, engine, options=["--build", build.folder])
        require(status == 0 and f"{build.count} of {build.count} methods hold" in output, output.strip()[-400:])
        runs = build.runs()
        require(all(runs.count(name) == 1 for name in before), "what had ended was run again")
        return f"{len(before)} of {build.count} had ended, and were not run again"

    for engine in engines:
        if engine.machines:
            trials.attempt(f"vnv killed alone, {engine.name}", lambda: vnv_alone(engine))
            trials.attempt(f"{engine.machines[0]} killed, {engine.name}", lambda: lost_machine(engine))


def try_cancelled(vnv, folder, engines, trials, program, record):
    """vnv is interrupted, and one element of an array is cancelled by somebody else."""

    def running(build):
        heard = subprocess.run(["ps", "-eo", "args"], capture_output=True, text=True).stdout
        return [line for line in heard.splitlines() if str(build.folder / "vnv" / "case") in line]

    def queue(*options):
        return subprocess.run(["squeue", "--noheader", *options], capture_output=True, text=True).stdout.split()

    def interrupted(engine):
        build = made_up.MadeUp(folder / f"{engine.name}.build", program, record, 4, 3, 3, 60)
        records = folder / engine.name
        if engine.name == "slurm":
            other = subprocess.run(["sbatch", "--parsable", "--mem=10M", "--output=/dev/null", "--wrap", "sleep 1000"],
                                   check=True, capture_output=True, text=True).stdout.strip()
        process = start(vnv, build, records, engine)
        wait_for_ends(records, 1)
        os.kill(process.pid, signal.SIGINT)
        began = time.monotonic()
        output = process.communicate(timeout=LONGEST)[0]
        took = time.monotonic() - began
        require(process.returncode == -signal.SIGINT, f"ended with status {process.returncode}: {output.strip()[-300:]!r}")
        cluster.until(lambda: not running(build), f"{engine.name}: still runs")
        if engine.name == "slurm":
            cluster.until(lambda: queue("--format=%A") == [other], f"{queue('--format=%A')} left in the queue, expected {other}")
            subprocess.run(["scancel", other], check=True)
        count = len(ended(records))
        require(count < build.count, "all had ended before")
        status, output = run(vnv, records, engine, options=["--build", build.folder])
        require(status == 0, f"goes on and ends with status {status}: {output.strip()[-300:]!r}")
        return f"after {count} of {build.count} ended; nothing runs {took:.1f} s later, and the next run goes on"

    def element(engine):
        build = made_up.MadeUp(folder / "element.build", program, record, 4, 1, 5, 120)
        records = folder / "element"
        process = start(vnv, build, records, engine)
        wait_for_ends(records, 2)
        cluster.until(lambda: queue("--states=running"), "no element runs")
        job = queue("--states=running", "--array", "--format=%i")[0]
        subprocess.run(["scancel", job], check=True)
        output = process.communicate(timeout=LONGEST)[0]
        require(process.returncode == 1, f"ended with status {process.returncode}: {output.strip()[-300:]!r}")
        require("3 of 4 methods hold" in output and f"lost by job {job}: CANCELLED on n" in output, output.strip()[-400:])
        return output.strip().splitlines()[-2]

    for engine in engines:
        if engine.machines:
            trials.attempt(f"interrupted, {engine.name}", lambda: interrupted(engine))
        if engine.name == "slurm":
            trials.attempt("an element cancelled, slurm", lambda: element(engine))


def try_overhead(vnv, folder, engines, trials, program, record, processor_time):
    """What an engine takes for a method, with all its daemons, beyond what local takes."""
    build = made_up.MadeUp(folder / "build", program, record, 10, 10, 0, 5)
    local = 0

    def trial(engine):
        nonlocal local
        before = processor_time()
        status, output = run(vnv, folder / engine.name, engine, options=["--build", build.folder])
        require(status == 0, output.strip()[-300:])
        each = (processor_time() - before) / build.count
        if engine.name == "local":
            local = each
            return f"{each:.3f} s a method, made up"
        require(each - local < 0.02 * MEAN, f"{each - local:.3f} s a method, expected less than 2 % of {MEAN} s")
        return f"{each - local:.3f} s a method more: {100 * (each - local) / MEAN:.2f} % of {MEAN} s"

    for engine in engines:
        trials.attempt(f"processor time of {engine.name}", lambda: trial(engine))


class Watched:
    """A program run to its end: its own processor time, without what it waited for, and its largest memory."""

    def __init__(self, words):
        began, before, self.own, self.memory = time.monotonic(), cpu_of_children(), 0.0, 0
        with tempfile.TemporaryFile("w+") as said:
            process = subprocess.Popen([str(word) for word in words], stdout=said, stderr=subprocess.STDOUT)
            place, tick = pathlib.Path("/proc") / str(process.pid), os.sysconf("SC_CLK_TCK")
            while process.poll() is None:
                with contextlib.suppress(OSError, IndexError):
                    used = (place / "stat").read_text().rsplit(")", 1)[1].split()[11:13]
                    self.own = sum(map(int, used)) / tick or self.own
                    self.memory = int((re.search(r"VmHWM:\s+(\d+)", (place / "status").read_text()) or [0, self.memory])[1])
                time.sleep(0.02)
            said.seek(0)
            self.status, self.output, self.wall = process.returncode, said.read(), time.monotonic() - began
            self.others = cpu_of_children() - before - self.own

    def sentence(self):
        return (f"{self.own:.1f} s of its own, {self.others:.1f} s of what it started, {self.wall:.0f} s by the clock, "
                f"{self.memory / 1024:.0f} MB")


def try_many(vnv, folder, trials, program, record, hosts, seconds):
    """Many hosts of GNU parallel, all of them this machine: `ssh` is a script that runs what it is given. Then as many nodes of Slurm."""
    folder.mkdir()
    build = made_up.MadeUp(folder / "build", program, record, 50, hosts * 5 // 50, seconds, 30)
    ssh = folder / "ssh"
    ssh.write_text('#!/bin/sh\nshift\n[ "$1" = -- ] && shift\nexec sh -c "$*"\n', encoding="utf-8")
    ssh.chmod(0o755)
    (folder / "hosts").write_text("".join(f"1/{ssh} h{k}\n" for k in range(hosts)), encoding="utf-8")
    records = folder / "records"
    run_words = ["run", "--build", build.folder, "--records", records, "--engine", "parallel", "--hosts", folder / "hosts"]
    by_slurm = ["run", "--build", build.folder, "--records", folder / "of_slurm", "--engine", "slurm"]

    def trial(words, expected):
        watched = Watched(words)
        require(watched.status == 0 and expected in watched.output,
                f"ended with status {watched.status}: {watched.output.strip()[-300:]!r}")
        require(watched.own < 60 and watched.memory < 500 * 1024, watched.sentence() + ", expected less than 60 s and 500 MB")
        return watched.sentence()

    report = vnv.parent.parent / "reports" / "touchstone_report"
    for what, words, expected in (
            ("plan", [vnv, "plan", "--build", build.folder], "tasks, "),
            ("run", [vnv, *run_words], f"{build.count} of {build.count} methods hold"),
            ("run again", [vnv, *run_words], f"{build.count} skipped"),
            ("pages", [report, records, folder / "site"], "")):
        trials.attempt(f"{what} of {build.count} methods that take {seconds} s on {hosts} hosts", lambda: trial(words, expected))
    if not cluster.missing(*NEEDS["slurm"]):
        with cluster.slurm(folder / "slurm", nodes=hosts, timeout=300):
            trials.attempt(f"run of {build.count} methods that take {seconds} s on {hosts} nodes of Slurm",
                           lambda: trial([vnv, *by_slurm], f"{build.count} of {build.count} methods hold"))


def conclude(trials):
    print(f"{trials.count - trials.failed} of {trials.count} trials passed")
    return 1 if trials.failed else 0


def main(arguments):
    parser = Parser(__doc__)
    parser.add_argument("build", type=pathlib.Path, help="build folder")
    parser.add_argument("--only", nargs="+", choices=PARTS, default=PARTS)
    parser.add_argument("--engines", nargs="+", choices=NEEDS, default=list(NEEDS), help="beside local; `many` takes both")
    parser.add_argument("--hosts", type=int, default=200, help="for `many`")
    parser.add_argument("--methods", nargs="+", help=f"for `equal`: these, not {' '.join(EQUAL)}")
    parser.add_argument("--suite", default="acceptance", help="for `equal`")
    parser.add_argument("--night", type=pathlib.Path, metavar="RECORDS",
                        help="for `equal`: of a whole suite by ctest on this machine, in place of a run by local")
    options = parser.parse_args(arguments)
    signal.signal(signal.SIGINT, signal.default_int_handler)  # a shell ignores it, and so would `vnv`, in the background
    vnv, program = (options.build.resolve() / "vnv" / name for name in ("vnv", "shear_wave"))
    for one in (vnv, program):
        if not os.access(one, os.X_OK):
            raise BadInput(f"{one}: cannot be run, expected a program of a build folder")
    trials = Trials()
    with tempfile.TemporaryDirectory(prefix="engines.") as scratch:
        folder = pathlib.Path(scratch)
        done = shared.run([vnv, "run", "shear_wave.mpm", "--records", folder / "one"], timeout=LONGEST)
        record = folder / "one" / "shear_wave.mpm.json"
        if done.returncode != 0:
            raise BadInput(f"shear_wave.mpm: {done.stdout.strip()[-300:]}")
        if "many" in options.only and not cluster.missing("parallel"):
            try_many(vnv, folder / "many", trials, program, record, options.hosts, 5)
        if options.only == ["many"]:
            return conclude(trials)
        with cluster.processor_time() as processor_time, engines_here(folder, options.engines) as engines:
            if "equal" in options.only:
                try_equal(vnv, folder / "equal", engines, trials, options.methods or ([] if options.night else EQUAL),
                          options.suite, options.night)
            if "overhead" in options.only:
                if processor_time:
                    try_overhead(vnv, folder / "overhead", engines, trials, program, record, processor_time)
                else:
                    print("SKIP: overhead: processor time of all that is started is not counted here")
            if "cancelled" in options.only:
                try_cancelled(vnv, folder / "cancelled", engines, trials, program, record)
            if "killed" in options.only:
                try_killed(vnv, folder / "killed", engines, trials, program, record)
    return conclude(trials)


exit_with(main)
