#!/usr/bin/env python3
"""What it brings that paths know the visibility of the sky and of lights: beside another Renderer. Needs numpy.

    windows.py [OPTION]... [SCENE]...

For each scene (room, atrium, flat, open; or the path of a .scn) and Renderer: relMSE by two references, the seconds that
one thread takes for the same samples and what it takes before the first of them; and both by each other.
"""
import argparse
import os

from many_lights import PROJECT, Run  # noqa: I001 (it makes the modules of ../cycles known)
import images
import window_scenes


def options():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("scenes", nargs="*", metavar="SCENE", help="of: %s; or FILE.scn" % " ".join(window_scenes.SCENES))
    parser.add_argument("-o", "--output", default=os.path.join(PROJECT, "output", "windows"), help="[output/windows]")
    parser.add_argument("--samples", type=int, default=64, help="[%(default)s]")
    parser.add_argument("--reference", type=int, default=4096, help="samples of each of two references [%(default)s]")
    parser.add_argument("--size", default="320x200", help="[%(default)s]")
    parser.add_argument("--seeds", type=int, default=3, help="images whose errors are averaged [%(default)s]")
    parser.add_argument("--renderer", default=os.path.join(PROJECT, "build", "release", "bin", "Renderer"))
    parser.add_argument("--before", help="the Renderer beside which it is compared")
    return parser.parse_intermixed_args()


def references(run, scene):
    """Two, which are kept."""
    found = []
    for seed in (101, 102):
        label = "reference-%d" % seed
        path = "%s-%s.pfm" % (scene, label)
        if not os.path.exists(path):
            run.paths(scene, label, run.words.reference, seed, "--threads=0")
        found.append(images.read_pfm(path))
    return found


def measure(run, scene, one, other):
    """relMSE, and seconds of rendering and of what comes before."""
    noise = abs(images.relative_errors(one, (one + other) / 2))
    errors, seconds = [], []
    for seed in range(run.words.seeds):
        image, spent = run.paths(scene, "image", run.words.samples, seed)
        errors.append(images.without_worst(images.relative_errors(image, one, other), noise).mean())
        seconds.append(spent)
    start = min(run.paths(scene, "start", 1, seed)[1] for seed in range(2))
    return sum(errors) / len(errors), min(seconds) - start, start


def main():
    words = options()
    os.makedirs(words.output, exist_ok=True)
    programs = [words.before, words.renderer] if words.before else [words.renderer]
    print("%-12s %10s %8s %8s %22s" % ("scene", "relMSE", "seconds", "start", "error, error x time"))
    for name in words.scenes or window_scenes.SCENES:
        foreign = name.endswith(".scn")
        scene = os.path.abspath(name[:-4]) if foreign else window_scenes.write(words.output, name)
        run, first = Run(words), None
        one, other = references(run, scene)
        for program in programs:
            words.renderer = program
            error, seconds, start = measure(run, scene, one, other)
            first = first or (error, seconds)
            print("%-12s %10.5f %8.2f %8.2f %10.3f %10.3f" % (
                os.path.basename(name), error, seconds, start, error / first[0],
                error * seconds / (first[0] * first[1])), flush=True)


if __name__ == "__main__":
    main()
