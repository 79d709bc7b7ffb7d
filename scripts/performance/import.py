#!/usr/bin/env python3
"""Times the import of models of ten million triangles beside Assimp and f3d, in turns.

usage: import.py [--rounds N] [--folder DIR] [--threads N] [--other RTIMPORT] [KIND.ENDING]...

Models (whole.glb bare.glb objects.glb whole.obj bare.obj quads.obj, which are the default) are made by bench_import
in DIR (by default a temporary one) and stay there where DIR is given. Medians over the rounds of processor time, wall
time and peak of resident memory of whole processes, files in the cache of the system:

  rtimport     all of it: the file, checked, to a .bsp in /dev/shm; vertices joined, normals made, triangles checked
  by-assimp    the same with Assimp's reader in place of our own, as it was before
  prepare      Assimp alone, nothing written: triangulated, vertices joined, normals made, validated
  triangulate  Assimp alone: triangulated
  parse        Assimp alone, no post-processing
  f3d          f3d --no-render: loading alone; where it is installed
  other        another rtimport, to compare two versions

Build first: cmake --build --preset release --target benches rtimport
"""
import argparse
import os
import pathlib
import shutil
import statistics
import subprocess
import sys
import tempfile
import time

REPOSITORY = pathlib.Path(__file__).resolve().parent.parent.parent
BIN = REPOSITORY / "build/release/bin"
MODELS = ["whole.glb", "bare.glb", "objects.glb", "whole.obj", "bare.obj", "quads.obj"]


def measured(command, environment):
    """Processor seconds, wall seconds, peak of resident megabytes."""
    begin = time.monotonic()
    process = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, env=environment)
    errors = process.stderr.read()
    _, status, usage = os.wait4(process.pid, 0)
    wall = time.monotonic() - begin
    process.returncode = os.waitstatus_to_exitcode(status)
    if process.returncode != 0:
        sys.exit(f"import: {' '.join(map(str, command))} failed: {errors.decode(errors='replace').strip()}")
    return usage.ru_utime + usage.ru_stime, wall, usage.ru_maxrss * 1024 / 1e6


def programs(arguments, model, output):
    bench = str(BIN / "bench_import")
    threads = ["--threads", str(arguments.threads)] if arguments.threads else []
    table = {"rtimport": [str(BIN / "rtimport"), *threads, str(model), output]}
    if arguments.other:
        table["other"] = [arguments.other, *threads, str(model), output]
    table["by-assimp"] = [bench, "by-assimp", str(model), output]
    for task in ["prepare", "triangulate", "parse"]:
        table[task] = [bench, task, str(model)]
    if shutil.which("f3d"):
        table["f3d"] = ["f3d", "--dry-run", "--no-render", str(model)]
    return {name: table[name] for name in table if not arguments.only or name in arguments.only.split(",")}


def compare(arguments, model, output):
    runs = programs(arguments, model, output)
    environment = dict(os.environ)
    if arguments.threads:
        environment["OMP_NUM_THREADS"] = str(arguments.threads)
    results = {name: [] for name in runs}
    for _ in range(arguments.rounds):
        for name, command in runs.items():
            results[name].append(measured(command, environment))
    medians = {name: [statistics.median(column) for column in zip(*rows)] for name, rows in results.items()}
    own = next(iter(medians.values()))
    print(f"{model.name}, {model.stat().st_size / 1e6:.0f} MB")
    for name, (processor, wall, memory) in medians.items():
        print(f"  {name:12} {processor:7.2f} s ({processor / own[0]:5.2f}) {wall:7.2f} s wall ({wall / own[1]:5.2f})"
              f" {memory:7.0f} MB", flush=True)
    if os.path.exists(output):
        print(f"  the .bsp has {os.path.getsize(output) / 1e6:.0f} MB", flush=True)
        os.unlink(output)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--rounds", type=int, default=5)
    parser.add_argument("--threads", type=int, default=0)
    parser.add_argument("--folder")
    parser.add_argument("--other", help="another rtimport")
    parser.add_argument("--only", help="names of the programs to run, with commas between them")
    parser.add_argument("models", nargs="*", default=MODELS)
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory(prefix="import-") as own:
        folder = pathlib.Path(arguments.folder or own)
        folder.mkdir(parents=True, exist_ok=True)
        for name in arguments.models:
            model = folder / name
            if not model.exists():
                subprocess.run([BIN / "bench_import", "make", model.stem, model], check=True)
            subprocess.run(["cat", model], stdout=subprocess.DEVNULL, check=True)  # into the cache
            compare(arguments, model, f"/dev/shm/import-{os.getpid()}.bsp")
            if not arguments.folder:
                model.unlink()


if __name__ == "__main__":
    main()
