"""A copy of the sources in which one change at a time is made, built and undone; the work tree is never changed."""

import contextlib
import fcntl
import hashlib
import os
import pathlib
import re
import shutil

import seeded
from shared import BadInput, run

ROOT = pathlib.Path(__file__).resolve().parents[3]
UNREAD = ("vnv/trials/faults/", "vnv/trials/losses/", "vnv/trials/mutants/")


def source_files():
    """What belongs to the sources, committed or not, but for what is seeded and what is only to be read."""
    listed = run(["git", "-C", ROOT, "ls-files", "-co", "--exclude-standard", "-z"])
    if listed.returncode != 0:
        raise BadInput(f"{ROOT}: git lists no files: {listed.stdout.strip()}")
    names = sorted(name for name in listed.stdout.split("\0") if name and (ROOT / name).is_file())
    return [name for name in names if not name.endswith(".md") and not name.startswith(UNREAD)]


def digest(*texts):
    sums = hashlib.sha256()
    for text in texts:
        sums.update(hashlib.sha256(text if isinstance(text, bytes) else text.encode()).digest())
    return sums.hexdigest()[:16]


def empty_records(build):
    """The folders of the records, as the tests that make room for a suite leave them, which a trial leaves out."""
    shutil.rmtree(build / "records", ignore_errors=True)
    for suite in ("acceptance", "report", "nightly"):
        (build / "records" / suite).mkdir(parents=True)


def programs_of_tests(source, pattern):
    """The programs of unit tests; all of the folder where no file names them in so many words."""
    files = [file for name, file in seeded.unit_tests(source).items() if re.fullmatch(pattern, name)]
    return {seeded.program_of_tests(file.relative_to(source)) for file in files} or {pattern.split(".")[1] + "_unit"}


class Scratch:
    """A copy of the sources and the builds of it."""

    def __init__(self, folder, jobs):
        self.source, self.builds, self.jobs = folder / "source", folder, jobs
        self.source.mkdir(parents=True, exist_ok=True)
        self.lock = open(folder / "lock", "w", encoding="utf-8")
        try:
            fcntl.flock(self.lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except OSError as error:
            raise BadInput(f"{folder}: another trial runs here, expected a folder of its own") from error
        self.equal_the_sources()

    def equal_the_sources(self):
        names, contents = source_files(), []
        for name in names:
            content, copy = (ROOT / name).read_bytes(), self.source / name
            contents.append(content)
            if not copy.is_file() or copy.read_bytes() != content:
                copy.parent.mkdir(parents=True, exist_ok=True)
                copy.write_bytes(content)
                copy.chmod((ROOT / name).stat().st_mode)
        known = set(names)
        for file in sorted(self.source.rglob("*")):
            if file.is_file() and str(file.relative_to(self.source)) not in known:
                file.unlink()
        self.digest = digest(*names, *contents)

    def configure(self, build, arguments=()):
        """Without precompiled headers: they take in the solvers, and one change there would compile all anew."""
        launcher = ["-DCMAKE_CXX_COMPILER_LAUNCHER=ccache"] if shutil.which("ccache") else []
        done = run(["cmake", "-S", self.source, "-B", build, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release",
                    "-DTOUCHSTONE_NATIVE=ON", "-DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON", *launcher, *arguments])
        if done.returncode != 0:
            raise BadInput(f"{build}: cannot be configured: {done.stdout.strip().splitlines()[-1]}")

    def targets(self, build, patterns):
        """The programs that the named tests need."""
        lists = (build / "vnv" / "CTestTestfile.cmake").read_text(encoding="utf-8")
        found = set()
        for pattern in patterns:
            if pattern == seeded.THE_BUILD:
                found.add("all_methods")
            elif case := seeded.case_of(pattern):
                found.add(case)
            elif pattern.startswith("unit."):
                found |= programs_of_tests(self.source, pattern)
            elif pattern.startswith("selftest."):
                for line in lists.splitlines():
                    name = re.match(r'add_test\((?:\[=\[)?"?([\w.]+)', line)
                    if name and re.fullmatch(pattern, name[1]):
                        of_build = re.findall(re.escape(str(build)) + r"/vnv/(\w+)", line)
                        found |= {"vnv_command" if program == "vnv" else program for program in of_build}
        return sorted(found)

    def remove_others(self, build, targets):
        """Removes programs that are no targets, with the tests of a case: ctest would run what an earlier fault left."""
        kept = {"vnv" if target == "vnv_command" else target for target in targets}
        for folder in seeded.TOPS:
            for file in (build / folder).glob("*"):
                is_of_folder = f"{folder}_unit" in targets and file.name.endswith("_test")
                if file.is_file() and os.access(file, os.X_OK) and file.name not in kept and not is_of_folder:
                    file.unlink()
                    file.with_name(f"{file.name}_tests.cmake").unlink(missing_ok=True)

    def make(self, build, targets):
        """Builds these targets, and nothing else is left."""
        if "all" not in targets:
            self.remove_others(build, targets)
        return self.compile(build, targets)

    def compile(self, build, targets):
        """What the compiler said where it failed, else nothing."""
        done = run(["cmake", "--build", build, "-j", self.jobs, "--target", *targets])
        if done.returncode == 0:
            return ""
        said = [line for line in done.stdout.splitlines() if "error: " in line] or done.stdout.splitlines()
        return self.without_place(said[0])[:300]

    def without_place(self, text):
        """What a compiler or a test says, without where the copy lies, which is of no interest to who reads it."""
        return text.replace(f"{self.source}/", "").replace("../source/", "")

    @contextlib.contextmanager
    def with_change(self, fault):
        """The sources as a fault makes them, for as long as this lasts."""
        texts = seeded.changed(fault, self.source)
        try:
            for file, (_, after) in texts.items():
                (self.source / file).write_text(after, encoding="utf-8")
            yield
        finally:
            for file, (before, _) in texts.items():
                (self.source / file).write_text(before, encoding="utf-8")
