"""What is installed into a folder with a blank in its path, and cannot be written there, runs each command of its page as it is printed
and says what is printed there; it reads its own data, leaves itself as it was, and no link of its pages dangles.

Usage: what_is_installed_judges_as_its_page_says.py BUILD
"""

import importlib.util
import itertools
import os
import pathlib
import re
import subprocess
import sys
import tempfile

BUILD = pathlib.Path(sys.argv[1]).resolve()
MEASURED_ANEW = r"[\d.e-]+(?= CPU s| sec\b)"


def commands_of(page):
    """Each command of the page with the lines that it says."""
    for block in re.findall(r"^```console\n(.*?)^```", page, re.MULTILINE | re.DOTALL):
        for command, said in re.findall(r"^\$ (.*)\n((?:(?!\$ ).*\n)*)", block, re.MULTILINE):
            yield command, said.splitlines(keepends=True)


def run(commands, folder, environment):
    """What each command said, in one shell."""
    script = "".join(f"{command}\n_status=$?; printf '\\001'; (exit $_status)\n" for command in commands)
    ended = subprocess.run(["bash", "-c", script], cwd=folder, env=environment, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False)
    return ended.stdout.decode().split("\1")[:-1]


def pattern(expected):
    """As it is printed, but for lines "..." and for what is measured anew."""
    parts = []
    for line in expected:
        if line == "...\n":
            parts.append(r"(?:.*\n)*?")
            continue
        words = re.split(f"({MEASURED_ANEW})", line)
        parts.append("".join(r"\S+" if k % 2 else re.sub(r"(\\ )+", " +", re.escape(word)) for k, word in enumerate(words)))
    return "".join(parts)


def without_venv(commands):
    """The same for a Python that has no venv."""
    print("Python has no venv here: touchstone.py is found by PYTHONPATH, not installed by pip")
    for command, said in commands:
        if "venv" in command:
            yield "export PYTHONPATH=~/touchstone/share/touchstone/python; python() { python3 -B \"$@\"; }", said
        elif not command.startswith("pip "):
            yield command, said


def dangling_links(prefix):
    for page in prefix.rglob("*.md"):
        for target in re.findall(r"\]\(([^)#]+)(?:#[^)]*)?\)", page.read_text(encoding="utf-8")):
            if not target.startswith("http") and not (page.parent / target).exists():
                yield f"{page.name}: no {target} beside it"


def reads_data_elsewhere(prefix, work, environment):
    """Without its own data it cannot judge by them."""
    data = prefix / "lib/touchstone/data"
    data.chmod(0o755)
    (data / "papers").rename(data / "elsewhere")
    (said,) = run(["vnv scene cavity --particles cavity.csv > /dev/null && vnv judge cavity cavity.csv --time 12"], work, environment)
    if str(data / "papers") not in said:
        yield f"vnv judge cavity, without {data}/papers, says\n{said}expected it to name that folder"


def complaints(scratch):
    home, work = scratch / "home", scratch / "work"
    prefix = home / "touchstone"
    home.mkdir()
    work.mkdir()
    (work / "build-portable").symlink_to(BUILD)
    environment = {"HOME": str(home), "PATH": os.environ["PATH"], "LANG": "C.UTF-8", "PYTHONDONTWRITEBYTECODE": "1"}
    (install, _), *commands = commands_of((pathlib.Path(__file__).parents[2] / "doors/IS_MY_SOLVER_RIGHT.md").read_text(encoding="utf-8"))
    run([install], work, environment)
    yield from dangling_links(prefix)
    subprocess.run(["chmod", "-R", "a-w", prefix], check=True)
    before = state_of(prefix)
    if not importlib.util.find_spec("ensurepip"):
        commands = list(without_venv(commands))
    for (command, expected), said in itertools.zip_longest(commands, run([command for command, _ in commands], work, environment), fillvalue=""):
        if not re.fullmatch(pattern(expected), said):
            yield f"$ {command}\n{said}expected\n{''.join(expected)}"
    if state_of(prefix) != before:
        yield f"{prefix}: changed by its use"
    yield from reads_data_elsewhere(prefix, work, {**environment, "PATH": f"{prefix}/bin:{os.environ['PATH']}"})


def state_of(prefix):
    return {file: (file.lstat().st_mtime_ns, file.lstat().st_size) for file in prefix.rglob("*")}


if __name__ == "__main__":
    with tempfile.TemporaryDirectory(prefix="what is installed ") as folder:
        found = list(complaints(pathlib.Path(folder)))
        subprocess.run(["chmod", "-R", "u+w", folder], check=True)
    print("\n".join(found) or "each command of the page says what is printed there")
    sys.exit(1 if found else 0)
