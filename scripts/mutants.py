"""Breaks sources in a copy of them, one change at a time, and looks whether tests notice. For check_*_mutants.py."""
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

PATIENCE = 900  # seconds that a program of tests may take


def main(script, folder, mutants, targets, caught):
    """The exit code of a script.

    mutants: (name, [(file below `folder`, what stands there once, what comes in its place)]).
    targets: what is built before each look.
    caught(build folder): the first test that fails, None when all pass.
    """
    root = pathlib.Path(__file__).resolve().parent.parent
    if sys.argv[1:] == ["--list"]:
        print("\n".join(name for name, _ in mutants))
        return 0
    gone = [f"'{name}': {what}" for name, changes in mutants for what in misses(root / folder, changes)]
    for line in gone:
        print(f"{script}: {line}", file=sys.stderr)
    if gone or sys.argv[1:] == ["--check"]:
        return 1 if gone else 0
    wanted = [m for m in mutants if not sys.argv[1:] or any(part in m[0] for part in sys.argv[1:])]
    if not wanted:
        print(f"{script}: no mutant is called so; --list names them", file=sys.stderr)
        return 2
    try:
        with tempfile.TemporaryDirectory(prefix="rtsuite-mutants-") as work:
            return check(script, folder, wanted, targets, caught, root, pathlib.Path(work))
    except Failure as failure:
        print(f"{script}: {failure}", file=sys.stderr)
        return 1
    except KeyboardInterrupt:
        return 130


class Failure(Exception):
    pass


def pattern(old):
    return re.escape(old).replace(r"\ ", r"\s+")  # however the lines are broken


def misses(folder, changes):
    """Why a mutant cannot be made: one sentence for each place that does not stand once in the sources."""
    for file, old, _ in changes:
        path = folder / file
        count = len(re.findall(pattern(old), path.read_text())) if path.is_file() else 0
        if count != 1:
            yield f"'{old}' stands {count} times in {path}, not once; tell the mutant where its rule is now"


class Test(str):
    """The name of a test that fails, with what it printed."""

    def __new__(cls, name, output=""):
        test = super().__new__(cls, name)
        test.output = output
        return test


def check(script, folder, mutants, targets, caught, root, work):
    sources, build = work / "sources", work / "build"
    copy(root, sources)
    print(f"{script}: building", flush=True)
    run(["cmake", "--preset", "headless", "-B", str(build)], sources)

    def look():
        jobs = os.environ.get("RT_JOBS", str(os.cpu_count()))
        run(["cmake", "--build", str(build), "--target", *targets, "--parallel", jobs], work)
        return caught(build)

    failed = look()
    if failed:
        print(failed.output, file=sys.stderr)
        raise Failure(f"{failed} fails with nothing broken")
    survived = 0
    for name, changes in mutants:
        with Broken(sources / folder, changes):
            test = look()
        print(f"{name}: {test or 'SURVIVED'}", flush=True)
        survived += test is None
    if survived:
        return 1
    print(f"{script}: every mutant is noticed")
    return 0


def copy(root, sources):
    names = subprocess.run(["git", "ls-files", "-z"], cwd=root, check=True, capture_output=True).stdout
    for name in names.split(b"\0"):
        path = pathlib.Path(os.fsdecode(name))
        if not name or not (root / path).is_file():
            continue
        (sources / path).parent.mkdir(parents=True, exist_ok=True)
        shutil.copy2(root / path, sources / path)
    if (root / "build/cimg").is_dir():  # a library by scripts/setup.sh
        shutil.copytree(root / "build/cimg", sources / "build/cimg")


class Broken:
    """Files of a folder with changes, until the end of the block."""

    def __init__(self, folder, changes):
        self.folder, self.changes = folder, changes
        self.whole = {file: (folder / file).read_text() for file, _, _ in changes}

    def __enter__(self):
        texts = dict(self.whole)
        for file, old, new in self.changes:
            texts[file] = re.sub(pattern(old), lambda _, new=new: new, texts[file])
        for file, text in texts.items():
            (self.folder / file).write_text(text)

    def __exit__(self, *_):
        for file, text in self.whole.items():
            (self.folder / file).write_text(text)


def first_failure_of(build, programs, environment=None):
    """The first test of the programs, each with its options, that fails or hangs; None when all pass."""
    for name, *options in programs:
        test = first_failure(build / "bin" / name, options, environment)
        if test:
            return test
    return None


def first_failure(program, options, environment):
    try:
        result = subprocess.run([str(program), "--gtest_fail_fast", *options], capture_output=True, text=True,
                                timeout=PATIENCE, env=environment, errors="replace")
    except subprocess.TimeoutExpired as expired:
        started = re.findall(r"^\[ RUN      \] (\S+)", (expired.stdout or b"").decode(errors="replace"), re.M)
        return Test(f"{started[-1] if started else program.name} (hangs)")
    if result.returncode == 0:
        return None
    failed = re.search(r"^\[  FAILED  \] ([^ ,]+)", result.stdout, re.M)
    started = re.findall(r"^\[ RUN      \] (\S+)", result.stdout, re.M)
    name = failed.group(1) if failed else f"{started[-1] if started else program.name} (ended with {result.returncode})"
    return Test(name, result.stdout[result.stdout.rfind("[ RUN"):] + result.stderr[-4000:])


def run(command, place):
    result = subprocess.run(command, cwd=place, capture_output=True, text=True, errors="replace")
    if result.returncode != 0:
        print((result.stdout + result.stderr)[-4000:], file=sys.stderr)
        raise Failure(f"'{' '.join(command)}' failed")
