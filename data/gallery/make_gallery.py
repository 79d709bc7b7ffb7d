#!/usr/bin/env python3
"""Builds the models and the sky that only the gallery needs, those that are missing or older than the scripts.

Usage: make_gallery.py [--force] [NAME...]
NAME: a scene, or space; all of them without a name. Two are made at a time.
"""
import glob
import importlib
import multiprocessing
import os
import sys
import time

HERE = os.path.dirname(os.path.abspath(__file__))
DATA = os.path.dirname(HERE)
SHARED = [os.path.join(DATA, folder) for folder in ("tools", "environments", "organic", "nave", "mirrors")]
sys.path[:0] = [HERE] + SHARED

NAMES = ("meadow", "toys", "chess", "orbit", "space", "terrace", "cube",        # those that take longest first
         "cloister", "room", "box", "rings", "eclipse", "rough", "caustics")


def output(name):
    return os.path.join(HERE, "generated", name + (".hdr" if name == "space" else ".glb"))


def fresh(name):
    scripts = [f for folder in (HERE, *SHARED) for f in glob.glob(os.path.join(folder, "*.py"))]
    path = output(name)
    return os.path.exists(path) and os.path.getmtime(path) >= max(map(os.path.getmtime, scripts))


def make(name):
    started = time.monotonic()
    if name == "space":
        write_space(output(name))
        size = ""
    else:
        from glb import Model
        model = Model()
        importlib.import_module("scene_" + name).build(model)
        model.write(output(name))
        size = f", {model.triangles} triangles"
    print(f"data/gallery/{name}: made in {time.monotonic() - started:.0f} s{size}", flush=True)


def write_space(path):
    from make_environments import HEIGHT, WIDTH, equirectangular
    from pictures import write_hdr
    from space import Space
    write_hdr(path, WIDTH, HEIGHT, equirectangular(Space()))


def main():
    arguments = sys.argv[1:]
    force = "--force" in arguments
    names = [a for a in arguments if a != "--force"] or list(NAMES)
    for name in names:
        if name not in NAMES:
            print(f"make_gallery.py: no scene '{name}'; there are {', '.join(NAMES)}", file=sys.stderr)
            return 2
    os.makedirs(os.path.join(HERE, "generated"), exist_ok=True)
    names = [name for name in names if force or not fresh(name)]
    with multiprocessing.Pool(2) as pool:
        pool.map(make, names, chunksize=1)
    return 0


if __name__ == "__main__":
    sys.exit(main())
