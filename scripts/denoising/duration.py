"""Processor seconds to a relMSE of 0.01 by the nets beside Cycles, one thread each, each program by its own references.

The start of the programs, the model and its tree are out, guides and nets are in. Cycles' errors are measured at two
numbers of samples and, like ours where they are still larger at the last one, continued by their power law. The first
figure is without the references' worst 0.1 % of the pixels, the second without the image's own.
"""
import math
import os
from collections import namedtuple

import images
import programs
import scenes
import write_scene
from rendering import KINDS, Reference, mean_of

SCENES = ("nave", "sponza", "sibenik", "cornell", "mirrors", "furnished")
GOAL = 0.01
SAMPLES = (1, 2, 4, 8, 16, 32, 64, 128, 256)
THEIR_SAMPLES = (16, 64)
SEED, REFERENCE_SEEDS = 7, (1001, 1002)
TRIMMED = ("trimmed", "own")
Point = namedtuple("Point", "samples seconds trimmed whole own")


class Measured:
    """A program on a scene: errors and user seconds by samples."""

    def __init__(self, setting, program, path, checksum):
        self.setting, self.program, self.path, self.checksum = setting, program, path, checksum

    def image(self, samples, seed=SEED):
        label = "%d-%d" % (samples, seed)
        output, seconds = programs.cached(self.program, self.path, self.checksum, label, self.setting.size, samples, seed)
        return images.read_pfm(output), seconds

    def reference(self, samples):
        return Reference(*(self.image(samples, seed)[0] for seed in REFERENCE_SEEDS))

    def point(self, samples, reference, once):
        image, seconds = self.image(samples)
        return Point(samples, max(seconds - once, 1e-3), *reference.rel_mse(image))

    def once(self, few, many):
        """Seconds that do not depend on samples."""
        first, second = self.image(few)[1], self.image(many)[1]
        return first - few * (second - first) / (many - few)


def at_goal(points, error, value):
    """Samples or seconds at which the error is GOAL: by the power law through the two points around it, or the last."""
    reached = next((i for i, p in enumerate(points) if getattr(p, error) <= GOAL), len(points) - 1)
    if reached == 0 and points[0].samples == 1:
        return getattr(points[0], value)
    reached = max(reached, 1)
    one, two = points[reached - 1:reached + 1]
    share = math.log(getattr(one, error) / GOAL) / math.log(getattr(one, error) / getattr(two, error))
    return getattr(one, value) * (getattr(two, value) / getattr(one, value)) ** share


def ours(setting, path, checksum):
    """The points of each net."""
    raw = Measured(setting, programs.Ours(setting.renderer.program), path, checksum)
    reference, once, found = raw.reference(setting.reference), raw.once(1, 17), {}
    for kind in setting.kinds:
        one = Measured(setting, programs.Ours(raw.program.program, "ours-" + kind, KINDS[kind]), path, checksum)
        found[kind] = []
        for samples in setting.samples or SAMPLES:
            found[kind].append(one.point(samples, reference, once))
            if found[kind][-1].trimmed <= GOAL:
                break
    return found


def theirs(setting, path, checksum):
    cycles = Measured(setting, programs.Theirs(setting.blender), path, checksum)
    reference, once = cycles.reference(setting.cycles_reference), cycles.once(*THEIR_SAMPLES)
    return [cycles.point(n, reference, once) for n in THEIR_SAMPLES]


def told(points):
    return ", ".join("%.3g (%.3g) at %d" % (p.trimmed, p.own, p.samples) for p in points[-2:])


def measure(setting, name, folder):
    """Our seconds over theirs, by both ways to leave pixels out."""
    scene = scenes.find(name, setting.models, folder)
    if scene is None:
        print("%-10s skipped: its model is not there" % name)
        return None
    path = os.path.join(folder, name)
    checksum = write_scene.write(scene, path)
    nets, cycles, ratios = ours(setting, path, checksum), theirs(setting, path, checksum), []
    for error in TRIMMED:
        kind = min(nets, key=lambda k: at_goal(nets[k], error, "seconds"))  # noqa: B023 (called at once)
        seconds, their_seconds = (at_goal(p, error, "seconds") for p in (nets[kind], cycles))
        ratios.append(seconds / their_seconds)
        print("%-10s %-7s %s %.2f s, %.1f samples (%s); Cycles %.1f s, %.0f samples (%s): ratio %.4f" % (
            name, error, kind, seconds, at_goal(nets[kind], error, "samples"), told(nets[kind]),
            their_seconds, at_goal(cycles, error, "samples"), told(cycles), ratios[-1]), flush=True)
    return ratios


def run(setting, names):
    if not setting.blender:
        raise SystemExit("skipped: Blender is not installed (scripts/setup.sh --peers)")
    folder = os.path.join(setting.folder, "time")
    os.makedirs(folder, exist_ok=True)
    rows = [row for row in (measure(setting, name, folder) for name in names) if row]
    for error, ratios in zip(TRIMMED, zip(*rows)):
        print("geometric mean of %d, %s: %.4f" % (len(ratios), error, mean_of(ratios)))
