#!/usr/bin/env python3
"""How much noise and time many lights cost, beside ten. docs/shading.md has what was found. Needs numpy.

    many_lights.py [OPTION]... [SCENE]...

For each scene (street, hall, tree) and kind of light: relative error (root of relMSE, by two references) and seconds at
equal samples; and how far the mean of direct light is from that of all lights visited (Whitted's rays), in its own
standard errors. Boxes are emissive triangles, which Whitted's rays do not take for lights.
"""
import argparse
import os
import sys

sys.path.insert(1, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "cycles"))
import images  # noqa: E402
import programs  # noqa: E402

import night_scenes  # noqa: E402

PROJECT = os.path.normpath(os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", ".."))

RAW = ("--setting=denoise.passes=0", "--setting=path.filter=0", "--denoise=off")  # whatever a scene's settings are


def options():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("scenes", nargs="*", metavar="SCENE", help="of: " + " ".join(night_scenes.SCENES))
    parser.add_argument("-o", "--output", default=os.path.join(PROJECT, "output", "many-lights"),
                        help="[output/many-lights]")
    parser.add_argument("--counts", default="10,100,1000,10000", help="[%(default)s]")
    parser.add_argument("--kinds", default=",".join(night_scenes.KINDS), help="[%(default)s]")
    parser.add_argument("--samples", type=int, default=48, help="[%(default)s]")
    parser.add_argument("--reference", type=int, default=1024,
                        help="samples of each of the two references [%(default)s]")
    parser.add_argument("--size", default="160x90", help="[%(default)s]")
    parser.add_argument("--renderer", default=os.path.join(PROJECT, "build", "release", "bin", "Renderer"))
    return parser.parse_intermixed_args()


class Run:
    def __init__(self, words):
        self.words, (self.width, self.height) = words, words.size.split("x")

    def render(self, scene, label, *settings):
        """An image, and the seconds that one thread took for it."""
        output = "%s-%s.pfm" % (scene, label)
        seconds = programs.run([self.words.renderer, scene + ".scn", "-o", output, "-w", self.width, "-h", self.height,
                                "--threads=1", "--progress=none", *RAW, *settings], output + ".log")
        return images.read_pfm(output), seconds

    def paths(self, scene, label, samples, seed, *settings):
        return self.render(scene, label, "--integrator=path", "--samples=%d" % samples,
                           "--setting=path.seed=%d" % seed, *settings)

    def measure(self, scene):
        """The relative error, and the seconds of rendering alone."""
        one, other = (self.paths(scene, "reference", self.words.reference, seed)[0] for seed in (101, 102))
        image, seconds = self.paths(scene, "image", self.words.samples, 7)
        _, start = self.paths(scene, "start", 1, 7)
        noise = abs(images.relative_errors(one, (one + other) / 2))
        errors = images.without_worst(images.relative_errors(image, one, other), noise)
        return max(errors.mean(), 0) ** .5, (seconds - start) * self.words.samples / (self.words.samples - 1)

    def deviation(self, scene):
        """Of the mean of direct light from that of all lights, in standard errors of 8 seeds."""
        settings = ("--setting=path.bounces=0", "--setting=path.filter=0")
        truth = self.render(scene, "all", "--setting=antialiasing=8")[0].mean()
        means = [self.paths(scene, "direct", 16, seed, *settings)[0].mean() for seed in range(8)]
        mean = sum(means) / len(means)
        error = (sum((m - mean) ** 2 for m in means) / (len(means) * (len(means) - 1))) ** .5
        return (mean - truth) / max(error, 1e-6 * truth)


def main():
    words = options()
    os.makedirs(words.output, exist_ok=True)
    run = Run(words)
    print("%-8s %-8s %6s %15s %7s %12s %6s %10s" % (
        "scene", "kind", "lights", "relative error", "by 10", "seconds", "by 10", "deviation"))
    for name in words.scenes or night_scenes.SCENES:
        for kind in words.kinds.split(","):
            first = None
            for count in map(int, words.counts.split(",")):
                scene = night_scenes.write(words.output, name, kind, count)
                error, seconds = run.measure(scene)
                first = first or (error, seconds)
                apart = "" if kind == "boxes" else "%+.1f" % run.deviation(scene)
                print("%-8s %-8s %6d %15.3f %7.2f %12.2f %6.2f %10s" % (
                    name, kind, count, error, error / first[0], seconds, seconds / first[1], apart), flush=True)


if __name__ == "__main__":
    main()
