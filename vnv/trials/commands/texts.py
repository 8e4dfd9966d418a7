"""The commands that the texts print: lines of their ```sh blocks, whole commands within a sentence, and the examples of --help."""

import pathlib
import re
import subprocess

ROOT = pathlib.Path(__file__).resolve().parents[3]
PAGES = ("README.md", "CONTRIBUTING.md", "vnv/doors/IS_MY_SOLVER_RIGHT.md")
# A program and its arguments, after settings of the environment; or a program of the project alone. Files that are not run are named likewise.
COMMAND = re.compile(r"(?:\w+=(?:\"[^\"]*\"|\S+) )*(?:(?:vnv|cmake|ctest|cpack|source|(?:build|vnv|\.ci)/[\w./]+) .+|build/vnv/\w+|\.ci/\w+)")


def of_page(page):
    """A block of another kind is no list of commands: what stands after `$` in ```console another test runs, with what it prints."""
    for block in re.findall(r"^```sh\n(.*?)^```$", page, re.MULTILINE | re.DOTALL):
        for line in block.splitlines():
            if command := re.sub(r"(^|\s+)#.*", "", line):
                yield command
    sentences = re.sub(r"^```.*?^```$", "", page, flags=re.MULTILINE | re.DOTALL)
    for words in re.findall(r"`([^`]+)`", sentences):
        words = " ".join(words.split())
        if COMMAND.fullmatch(words):
            yield words


def of_first_block():
    """README's lines for a bare machine."""
    page = (ROOT / "README.md").read_text(encoding="utf-8")
    return of_page(re.search(r"^```sh\n.*?^```$", page, re.MULTILINE | re.DOTALL)[0])


def of_help(said):
    """Examples follow each other, indented, with what they are for; or one stands in the line; below them sentences name tests."""
    for one, several in re.findall(r"^Examples?:(.*)\n((?:  .*\n)*)", said, re.MULTILINE):
        for line in (one, *several.splitlines()):
            if command := re.split(r"\s{2,}", line.strip())[0]:
                yield command
    yield from re.findall(r"\bctest -\w (?:'[^']*'|\w+)", said)


def help_of(*words):
    return subprocess.run([*words, "--help"], check=True, capture_output=True, text=True, encoding="utf-8").stdout


def printed(vnv, *others):
    """Each command, once, and where it stands; `others` are programs that have examples, too."""
    found = {}
    for name in PAGES:
        for command in of_page((ROOT / name).read_text(encoding="utf-8")):
            found.setdefault(command, name)
    subcommands = re.findall(r"^  (\w+)  ", help_of(vnv).split("\nSubcommands:\n")[1].split("\n\n")[0], re.MULTILINE)
    for program, *words in ([vnv], *([vnv, subcommand] for subcommand in subcommands), *([other] for other in others)):
        for command in of_help(help_of(program, *words)):
            found.setdefault(command, " ".join((program.name, *words, "--help")))
    return found


def begins(mention, command):
    """Whether a mention is the beginning of a command, words in capitals standing for any."""
    words, of_command = mention.split(), command.split()
    return len(words) <= len(of_command) and all(re.fullmatch("[A-Z]+", word) or word == other for word, other in zip(words, of_command))
