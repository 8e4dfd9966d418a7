#!/usr/bin/env python3
"""Engines: the same methods here, on two hosts of ssh by GNU parallel and on two nodes of Slurm, all of them this machine.

Verdicts and errors are equal to the last bit, whatever is killed, nothing that has ended is lost or run again, and what
breaks off cancels what it submitted and nothing else. A trial is a line; an engine that is not installed is a line that
says so. Exit status: 0 all trials passed; 1 one failed; 3 bad input.

Example: vnv/trials/engines/try.py build --methods couette poiseuille
"""

import functools
import json
import os
import pathlib
import signal
import subprocess
import sys
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))

import cluster  # noqa: E402
import made_up  # noqa: E402
import shared  # noqa: E402
from shared import built, require, require_end, said_by, start, try_parts, until, well  # noqa: E402

LONGEST = 900  # s, of a program
LONGEST_SUITE = 4 * 3600  # s, of `equal`
NEEDS = {"parallel": ("parallel", "sshd", "ssh-keygen"), "slurm": ("sbatch", "slurmctld", "slurmd")}
EQUAL = ("shear_wave", "stokes_first", "couette")
MEAN = 17  # s, of processor time, that a method of a whole night takes: 86 minutes of one core for 300 methods


class Engine:
    """How `vnv run` uses an engine, and how one of its machines is ended."""

    def __init__(self, name, options=(), daemons=None, machines=()):
        self.name, self.options, self.daemons, self.machines = name, options, daemons, machines


class Trials(shared.Trials):
    """With a record of which others are made up, and the engines, which are started for the first who asks for them."""

    def __init__(self, options):
        signal.signal(signal.SIGINT, signal.default_int_handler)  # a shell ignores it, and so would `vnv`, in the background
        super().__init__(options)
        self.vnv, self.program, self.report = (built(self.build, name) for name in ("vnv/vnv", "vnv/shear_wave", "reports/touchstone_report"))
        self.record = self.folder() / "shear_wave.mpm.json"
        well([self.vnv, "run", "shear_wave.mpm", "--records", self.record.parent], LONGEST)

    def run_of(self, engine, *made):
        return Run(self.vnv, made_up.MadeUp(self.folder(), self.program, self.record, *made), self.folder(), engine)

    @functools.cached_property
    def processor_time(self):
        return self.enter_context(cluster.processor_time())

    @functools.cached_property
    def engines(self):
        """Local, and of the named engines all that are installed; what they take is counted, if that may be."""
        found, folder, _ = [Engine("local")], self.folder(), self.processor_time
        names = [name for name in self.options.engines if cluster.are_here(name, NEEDS[name])]
        if "parallel" in names:
            hosts, daemons = self.enter_context(cluster.ssh_hosts(folder / "ssh"))
            (folder / "hosts").write_text("\n".join(hosts) + "\n", encoding="utf-8")
            found.append(Engine("parallel", ["--engine", "parallel", "--hosts", folder / "hosts"], daemons, ["h1", "h2"]))
        if "slurm" in names:
            found.append(Engine("slurm", ["--engine", "slurm"], self.enter_context(cluster.slurm(folder / "slurm")), ["n1", "n2"]))
        return found


def judged(records, timed):
    """{CASE.METHOD: values, verdicts and orders, as they were written but for costs; methods that are timed run as long
    as their timing takes, so of these also but for the time that was reached}"""
    found = {}
    for file in sorted(records.glob("*.json")):
        record, left_out = json.loads(file.read_text(encoding="utf-8")), ("time", "sentence") if file.stem in timed else ()
        kept = ([value for value in record["values"] if value["quantity"]["kind"] != "cost"],
                [verdict for verdict in record["verdicts"] if verdict["kind"] != "cost"])
        kept = [[{key: of for key, of in one.items() if key not in left_out} for one in all_of] for all_of in kept]
        found[file.stem] = json.dumps([*kept, record["orders"]])
    return found


def try_equal(trials):
    """The same methods by all engines, or a night that was run here by all others."""
    vnv, suite, night = trials.vnv, trials.options.suite, trials.options.night
    methods = trials.options.methods or ([] if night else EQUAL)
    listed = json.loads(well([vnv, "list", "--suite", suite, "--json"], stderr=subprocess.DEVNULL))  # it names there what is not built
    timed = {f"{method['case']}.{method['method']}" for method in listed if method["timed"]}
    expected = {"judged": judged(night, timed)} if night else {}

    def trial(records, engine):
        began, words = time.monotonic(), [vnv, "run", *methods, "--suite", suite, "--records", records, *engine.options]
        status, said = said_by(words, LONGEST_SUITE)
        took, found = time.monotonic() - began, judged(records, timed)
        expected.setdefault("status", status)
        expected.setdefault("judged", found)
        require(found, f"nothing was judged; it said: {said.strip()[-300:]!r}")
        require_end(words, status, said, (expected["status"],))
        differs = [name for name in found | expected["judged"] if found.get(name) != expected["judged"].get(name)]
        require(not differs, f"{len(differs)} methods differ from local: {' '.join(differs)}")
        again = said_by(words, LONGEST)[1]
        require(f"{len(found)} skipped" in again, f"not all is skipped the next time: {again.strip()[-200:]!r}")
        return f"{len(found)} methods judged as by local, {took:.0f} s"

    for engine in trials.engines:
        if engine.machines or not night:
            trials.attempt(f"{suite} by {engine.name}", trial, trials.folder(), engine)


class Run:
    """`vnv run` by an engine, of a build of made-up methods."""

    def __init__(self, vnv, build, records, engine):
        self.build, self.records = build, records
        self.words = [vnv, "run", "--build", build.folder, "--records", records, *engine.options]

    def start(self, ends):
        """Until so many of its methods have ended."""
        self.process = start(self.words)
        until(lambda: len(self.ended()) >= ends, f"{ends} methods that end", LONGEST)

    def ended(self):
        return {file.name for file in (self.records / "engine" / "ended").glob("[!.]*")}

    def end(self, status, held=None):
        """What it says in the end, with so many methods that hold."""
        said = self.process.communicate(timeout=LONGEST)[0]
        require_end(self.words, self.process.returncode, said, (status,))
        return self.require_held(said, held) if held else said

    def again(self):
        return self.require_held(well(self.words, LONGEST), self.build.count)

    def require_held(self, said, held):
        require(f"{held} of {self.build.count} methods hold" in said, said.strip()[-400:])
        return said


def try_killed(trials):
    """A machine is killed with all that runs there, or `vnv` alone."""

    def vnv_alone(engine):
        run = trials.run_of(engine, 4, 3, 1, 60)
        run.start(3)
        run.process.kill()
        run.process.communicate()
        before = run.ended()
        run.again()
        runs = run.build.runs()
        require(all(runs.count(name) == 1 for name in before), "what had ended was run again")
        return f"{len(before)} of {run.build.count} had ended, and were not run again"

    def lost_machine(engine):
        run = trials.run_of(engine, 4, 3, 4, 60)
        run.start(2)
        time.sleep(3)  # in the middle of the next two
        engine.daemons.kill(engine.machines[0])
        before, began = run.ended(), time.monotonic()
        run.end(0, run.build.count)
        runs = run.build.runs()
        again = sorted(name for name in set(runs) if runs.count(name) > 1)
        require(not before & set(again), f"ended and was run again: {sorted(before & set(again))}")
        require(all(runs.count(name) == 2 for name in again), f"run more than twice: {again}")
        return f"{len(before)} of {run.build.count} had ended, {len(again)} tried again, all hold {time.monotonic() - began:.0f} s later"

    for engine in trials.engines[1:]:
        trials.attempt(f"vnv killed alone, {engine.name}", vnv_alone, engine)
        trials.attempt(f"{engine.machines[0]} killed, {engine.name}", lost_machine, engine)


def try_cancelled(trials):
    """vnv is interrupted, and one element of an array is cancelled by somebody else."""
    queue = lambda *options: said_by(["squeue", "--noheader", *options])[1].split()

    def interrupted(engine):
        run = trials.run_of(engine, 4, 3, 3, 60)
        runs_here = lambda: str(run.build.folder / "vnv" / "case") in well(["ps", "-eo", "args"])
        if engine.name == "slurm":
            other = well(["sbatch", "--parsable", "--mem=10M", "--output=/dev/null", "--wrap", "sleep 1000"]).strip()
        run.start(1)
        os.kill(run.process.pid, signal.SIGINT)
        began = time.monotonic()
        run.end(-signal.SIGINT)
        took = time.monotonic() - began
        until(lambda: not runs_here(), f"{engine.name}: still runs")
        if engine.name == "slurm":
            until(lambda: queue("--format=%A") == [other], f"{queue('--format=%A')} left in the queue, expected {other}")
            well(["scancel", other])
        count = len(run.ended())
        require(count < run.build.count, "all had ended before")
        run.again()
        return f"after {count} of {run.build.count} ended; nothing runs {took:.1f} s later, and the next run goes on"

    def element(engine):
        run = trials.run_of(engine, 4, 1, 5, 120)
        run.start(2)
        until(lambda: queue("--states=running"), "no element runs")
        job = queue("--states=running", "--array", "--format=%i")[0]
        well(["scancel", job])
        said = run.end(1, 3)
        require(f"lost by job {job}: CANCELLED on n" in said, said.strip()[-400:])
        return said.strip().splitlines()[-2]

    for engine in trials.engines[1:]:
        trials.attempt(f"interrupted, {engine.name}", interrupted, engine)
        if engine.name == "slurm":
            trials.attempt("an element cancelled, slurm", element, engine)


def try_overhead(trials):
    """What an engine takes for a method, with all its daemons, beyond what local takes."""
    if not trials.processor_time:
        print("SKIP: overhead: processor time of all that is started is not counted here")
        return
    of_local = 0

    def trial(engine):
        nonlocal of_local
        run = trials.run_of(engine, 10, 10, 0, 5)
        before = trials.processor_time()
        well(run.words, LONGEST)
        each = (trials.processor_time() - before) / run.build.count
        if engine.name == "local":
            of_local = each
            return f"{each:.3f} s a method, made up"
        more = each - of_local
        require(more < 0.02 * MEAN, f"{more:.3f} s a method, expected less than 2 % of {MEAN} s")
        return f"{more:.3f} s a method more: {100 * more / MEAN:.2f} % of {MEAN} s"

    for engine in trials.engines:
        trials.attempt(f"processor time of {engine.name}", trial, engine)


def costs(words, expected):
    """What a program takes that ends well and says what is expected: time of its own, without what it waited for, and memory."""
    began = time.monotonic()
    with start(words) as process:
        said = process.stdout.read()
        os.waitid(os.P_PID, process.pid, os.WEXITED | os.WNOWAIT)  # it has ended, and can still be read
        times = (pathlib.Path("/proc") / str(process.pid) / "stat").read_text().rsplit(")", 1)[1].split()[11:13]
        own = sum(map(int, times)) / os.sysconf("SC_CLK_TCK")
        _, status, used = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
    require(expected in require_end(words, process.returncode, said), said.strip()[-300:])
    took = (f"{own:.1f} s of its own, {used.ru_utime + used.ru_stime - own:.1f} s of what it started, {time.monotonic() - began:.0f} s "
            f"by the clock, {used.ru_maxrss / 1024:.0f} MB")
    require(own < 60 and used.ru_maxrss < 500 * 1024, f"{took}, expected less than 60 s and 500 MB")
    return took


def try_many(trials):
    """Many hosts of GNU parallel, all of them this machine: `ssh` is a script that runs what it is given. Then as many nodes of Slurm."""
    if not cluster.are_here("many", ["parallel"]):
        return
    folder, hosts, seconds = trials.folder(), trials.options.hosts, 5
    ssh = folder / "ssh"
    ssh.write_text('#!/bin/sh\nshift\n[ "$1" = -- ] && shift\nexec sh -c "$*"\n', encoding="utf-8")
    ssh.chmod(0o755)
    (folder / "hosts").write_text("".join(f"1/{ssh} h{k}\n" for k in range(hosts)), encoding="utf-8")
    by_parallel = Engine("parallel", ["--engine", "parallel", "--hosts", folder / "hosts"])
    run = trials.run_of(by_parallel, 50, hosts * 5 // 50, seconds, 30)
    all_hold = f"{run.build.count} of {run.build.count} methods hold"
    many = f"of {run.build.count} methods that take {seconds} s on {hosts}"
    for what, words, expected in (
            ("plan", [trials.vnv, "plan", "--build", run.build.folder], "tasks, "), ("run", run.words, all_hold),
            ("run again", run.words, f"{run.build.count} skipped"), ("pages", [trials.report, run.records, folder / "site"], "")):
        trials.attempt(f"{what} {many} hosts", costs, words, expected)
    if cluster.are_here("many by Slurm", NEEDS["slurm"]):
        with cluster.slurm(folder / "slurm", nodes=hosts, timeout=300):
            by_slurm = Run(trials.vnv, run.build, folder / "records", Engine("slurm", ["--engine", "slurm"]))
            trials.attempt(f"run {many} nodes of Slurm", costs, by_slurm.words, all_hold)


# The first has a Slurm of its own, while no other is there; the last ends machines.
PARTS = {"many": try_many, "equal": try_equal, "overhead": try_overhead, "cancelled": try_cancelled, "killed": try_killed}

if __name__ == "__main__":
    try_parts(__doc__, PARTS, Trials,
              engines={"nargs": "+", "choices": NEEDS, "default": list(NEEDS), "help": "beside local; `many` takes both"},
              hosts={"type": int, "default": 200, "help": "for `many`"},
              methods={"nargs": "+", "help": f"for `equal`: these, not {' '.join(EQUAL)}"},
              suite={"default": "acceptance", "help": "for `equal`"},
              night={"type": pathlib.Path, "metavar": "RECORDS",
                     "help": "for `equal`: of a whole suite by ctest on this machine, in place of a run by local"})
