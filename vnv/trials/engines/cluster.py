"""A Slurm of several nodes and hosts of ssh, all of them this machine, for a while."""

import contextlib
import os
import pathlib
import pwd
import shutil
import signal
import socket
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))

import shared  # noqa: E402

START = 120  # s, that a daemon may take
os.environ["PATH"] += os.pathsep + "/usr/sbin"


def are_here(what, programs):
    """Or a line says what is left out for want of which."""
    if program := next((program for program in programs if not shutil.which(program)), None):
        print(f"SKIP: {what}: no {program}")
    return not program


def free_ports(count):
    with contextlib.ExitStack() as stack:
        sockets = [stack.enter_context(socket.socket()) for _ in range(count)]
        for one in sockets:
            one.bind(("127.0.0.1", 0))
        return [one.getsockname()[1] for one in sockets]


def kill_all(process, marks):
    """Kills a process and all that it started, as a machine does that loses its power: its children, and what has
    these marks in its environment, with the daemon of Slurm that started it."""
    known = shared.processes()
    marked = [one for one, found in known.items() if marks <= set(found.environment)]
    daemons = [one for one in (known[mark].parent for mark in marked) if one in known and known[one].name == "slurmstepd"]
    victims = [process.pid, *marked, *daemons]
    for victim in victims:
        victims.extend(one for one, found in known.items() if found.parent == victim and one not in victims)
    for kind in (signal.SIGSTOP, signal.SIGKILL):  # none tells of another's end
        shared.kill(victims, kind)
    process.wait()


@contextlib.contextmanager
def processor_time():
    """What all take that is started here, daemons that leave their parent included: a function [s], or None where this
    may not be counted."""
    group = pathlib.Path("/sys/fs/cgroup/cpuacct") / f"engines.{os.getpid()}"
    try:
        group.mkdir()
        (group / "cgroup.procs").write_text(str(os.getpid()))
    except OSError:
        yield None
        return
    try:
        yield lambda: int((group / "cpuacct.usage").read_text()) * 1e-9
    finally:
        (group.parent / "cgroup.procs").write_text(str(os.getpid()))
        with contextlib.suppress(OSError):  # some daemon is slow to end
            group.rmdir()


class Daemons:
    """Programs that run until all of this ends, each with what it says in a file."""

    def __init__(self, folder):
        self.folder, self.running = folder, {}
        folder.mkdir(parents=True)

    def start(self, name, words):
        with open(self.folder / f"{name}.txt", "w", encoding="utf-8") as said:
            self.running[name] = shared.start(words, stdout=said, stdin=subprocess.DEVNULL)

    def kill(self, name):
        kill_all(self.running.pop(name), {f"SLURMD_NODENAME={name}", f"SLURM_CONF={self.folder}/slurm.conf"})

    def end(self):
        for name in list(self.running):
            self.kill(name)


CONFIGURATION = """ClusterName=trial
SlurmctldHost={host}(127.0.0.1)
SlurmUser={user}
SlurmdUser={user}
SlurmctldPort={port}
AuthType=auth/none
CredType=cred/none
MpiDefault=none
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SwitchType=switch/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core_Memory
SchedulerParameters=sched_interval=5,defer_batch
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool.%n
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdPidFile={folder}/slurmd.%n.pid
SlurmctldLogFile={folder}/slurmctld.log
SlurmdLogFile={folder}/slurmd.%n.log
SlurmdTimeout={timeout}
ReturnToService=2
KillWait=5
AuthInfo=cred_expire=10
NodeName=n[1-{nodes}] NodeHostname={host} NodeAddr=127.0.0.1 Port=[{ports}] CPUs={processors} RealMemory={memory}
PartitionName=all Nodes=ALL Default=YES MaxTime=INFINITE State=UP
"""


@contextlib.contextmanager
def slurm(folder, nodes=2, processors=1, memory=10000, timeout=15):
    """Sets SLURM_CONF; `kill("n1")` of what is given ends a node with all that runs there."""
    port, *ports = free_ports(1 + nodes)
    daemons = Daemons(folder)
    (folder / "state").mkdir()
    (folder / "slurm.conf").write_text(CONFIGURATION.format(
        host=socket.gethostname(), user=pwd.getpwuid(os.getuid()).pw_name, port=port, folder=folder, nodes=nodes,
        ports=",".join(map(str, ports)), processors=processors, memory=memory, timeout=timeout), encoding="utf-8")
    os.environ["SLURM_CONF"] = str(folder / "slurm.conf")
    try:
        daemons.start("slurmctld", ["slurmctld", "-D"])
        for k in range(1, nodes + 1):
            daemons.start(f"n{k}", ["slurmd", "-D", "-N", f"n{k}"])

        idle = lambda: f"{nodes} idle" in shared.said_by(["sinfo", "--noheader", "--format=%D %T"])[1]
        shared.until(idle, f"{nodes} nodes of Slurm, see {folder}", START)
        yield daemons
    finally:
        shared.said_by(["scancel", "--me"])
        daemons.end()
        del os.environ["SLURM_CONF"]


@contextlib.contextmanager
def ssh_hosts(folder, count=2):
    """Hosts as GNU parallel names them, and the daemons by which one is ended. Their home is the folder: what a shell reads
    in the user's own when it starts, pyenv's initialisation of 1 s for one, is not what an engine takes."""
    daemons = Daemons(folder)
    key = folder / "key"
    shared.well(["ssh-keygen", "-q", "-t", "ed25519", "-N", "", "-f", key])
    shutil.copy(f"{key}.pub", folder / "allowed")
    pathlib.Path("/run/sshd").mkdir(exist_ok=True)
    ports = free_ports(count)
    try:
        for k, port in enumerate(ports, 1):
            daemons.start(f"h{k}", [shutil.which("sshd"), "-D", "-e", "-f", "/dev/null", "-p", port, "-h", key,
                                    "-o", "ListenAddress=127.0.0.1", "-o", f"AuthorizedKeysFile={folder}/allowed",
                                    "-o", "StrictModes=no", "-o", "UsePAM=no", "-o", "PermitRootLogin=yes",
                                    "-o", f"SetEnv=HOME={folder}", "-o", "MaxStartups=100", "-o", f"PidFile={folder}/h{k}.pid"])

        def answers(port):
            with socket.socket() as one:
                return one.connect_ex(("127.0.0.1", port)) == 0

        for port in ports:
            shared.until(lambda: answers(port), f"sshd at port {port}, see {folder}", START)
        words = f"ssh -i {key} -o StrictHostKeyChecking=no -o UserKnownHostsFile=/dev/null -o LogLevel=ERROR"
        yield [f"1/{words} -p {port} 127.0.0.1" for port in ports], daemons
    finally:
        daemons.end()
