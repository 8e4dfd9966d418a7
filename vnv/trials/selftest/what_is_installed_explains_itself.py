"""What is installed says its version and what can be done there, has a page for man that roff sets without a warning, and lets bash, and zsh where
that is, complete commands, flows and files.

Usage: what_is_installed_explains_itself.py BUILD
"""

import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

BUILD = pathlib.Path(sys.argv[1]).resolve()
SAID = {  # by each command, with its exit status
    "--version": (0, r"vnv \(Touchstone\) \d+\.\d+\.\d+(, revision \S+)?\n"),
    "list": (0, r"No cases of our methods are installed(.*\n)*poiseuille +Start-up of plane Poiseuille flow +exact velocity\n(.*\n)*"),
    "list 'stokes*'": (0, r"(.*\n)*stokes_first .*\nstokes_second .*\n\n(.*\n)*"),
    "list --names": (0, ""),
    "list nothing": (3, r"vnv: no flow fits 'nothing', .*expected one of: cavity, .*\n"),
    "plan": (0, r"No cases of our methods are installed(.*\n)*  vnv plan mine.toml (.*\n)*"),
    "plan mine.toml": (0, r".*\npoiseuille.mine  20 across +5e-05 +1 +unknown\n1 tasks, .*\n"),
    "explain poiseuille": (0, r"poiseuille: Start-up .*\n(.*\n)*.*Morris, Fox & Zhu(.*\n)*  nu = 1e-06 m²/s: kinematic viscosity\n(.*\n)*"
                              r"Claimed of any code\n  order of L2 v_x.*at least 0\.9(.*\n)*"),
    "run poiseuille": (3, r"vnv: .*: an installed copy, which has no cases; expected the file of a solver .*\n"),
}
COMPLETED = {  # what is offered for the last word, in a folder with two files and a folder
    "ju": "judge",
    "judge poi": "poiseuille",
    "judge --set H = 1 poi": "poiseuille",
    "judge couette 'my '": "my runs.csv",
    "judge couette a.csv --axes y": "yx yz y-x y-z",
    "scene st": "standing_wave stokes_first stokes_second",
    "explain tay": "taylor_green",
    "run ''": "folder mine.toml",
    "run --suite n": "nightly",
    "report ''": "folder",
    "prepare ''": "folder mine.toml",
    "prepare mine.toml ''": "folder",
    "gate --json m": "mine.toml|my runs.csv",
    "judge --json taylor": "taylor_green",
    "order --v": "--values",
}


def said_otherwise(vnv, work):
    (work / "mine.toml").write_text('flow = "poiseuille"\nacross = [20]\ncommand = "true"\noutput = "*.csv"\n')
    for words, (status, expected) in SAID.items():
        ended = subprocess.run(f"'{vnv}' {words}", shell=True, cwd=work, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False)
        said = ended.stdout.decode()
        if ended.returncode != status or not re.fullmatch(expected, said):
            yield f"vnv {words}: {ended.returncode}, {said}\nexpected {status}, {expected}"
    if (work / "records").exists():
        yield "records: made by commands that ran nothing"


def page_with_warnings(prefix):
    page = prefix / "share/man/man1/vnv.1"
    if not shutil.which("groff"):
        print("groff is not here: the page for man is not set")
        return
    ended = subprocess.run(["groff", "-ww", "-man", "-K", "utf8", "-T", "utf8", page], capture_output=True, check=False)
    if ended.returncode != 0 or ended.stderr:
        yield f"{page}: {ended.stderr.decode()}"
    text = re.sub("\x1b\\[[0-9;]*m|.\b", "", ended.stdout.decode())
    for words in ("vnv judge [options] FLOW FILES...", "--at-most FLOAT", "vnv gate HEAD~1 HEAD --case poiseuille", "taken as different"):
        if words not in " ".join(text.split()):
            yield f"{page}: lacks '{words}'"


def completed_otherwise(prefix, work):
    (work / "my runs.csv").touch()
    (work / "folder").mkdir()
    script = prefix / "share/bash-completion/completions/vnv"
    environment = {**os.environ, "PATH": f"{prefix}/bin:{os.environ['PATH']}"}
    for words, expected in COMPLETED.items():
        said = subprocess.run(["bash", "-c", f"source '{script}'; COMP_WORDS=(vnv {words}); COMP_CWORD=$((${{#COMP_WORDS[@]}} - 1)); _vnv; "
                               "printf '%s\\n' \"${COMPREPLY[@]}\" | sort"], cwd=work, env=environment, capture_output=True, check=False)
        offered = said.stdout.decode().splitlines()
        if said.stderr or offered not in (sorted(expected.split("|")), sorted(expected.split())):
            yield f"vnv {words}: completed by {offered} {said.stderr.decode()}, expected {expected}"
    if not shutil.which("zsh"):
        print("zsh is not here: its script is not run")
        return
    script = prefix / "share/zsh/vendor-completions/_vnv"
    ended = subprocess.run(["zsh", "-f", "-c", f"compdef() {{ print $1 $2; }}; source '{script}'"], capture_output=True, check=False)
    if ended.stdout.decode() != "_vnv vnv\n" or ended.stderr:
        yield f"{script}: {ended.stdout.decode()}{ended.stderr.decode()}"


def complaints(scratch):
    prefix, work = scratch / "prefix", scratch / "work"
    work.mkdir()
    subprocess.run(["cmake", "--install", BUILD, "--prefix", prefix], stdout=subprocess.DEVNULL, check=True)
    yield from said_otherwise(prefix / "bin/vnv", work)
    yield from page_with_warnings(prefix)
    yield from completed_otherwise(prefix, work)


if __name__ == "__main__":
    with tempfile.TemporaryDirectory(prefix="what is installed ") as folder:
        found = list(complaints(pathlib.Path(folder)))
    print("\n".join(found) or "each command, the page for man and completion say what they should")
    sys.exit(1 if found else 0)
