"""Processor seconds to a relMSE of 0.01 by the nets beside Cycles, one thread each, each program by its own references.

The start of the programs, the model and its tree are out, guides and nets are in. Cycles' errors are measured at two
numbers of samples and, like ours where they are still larger at the last one, continued by their power law.
"""
import math
import os

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


class Measured:
    """A program on a scene: errors and user seconds by samples."""

    def __init__(self, setting, program, path, checksum):
        self.setting, self.program, self.path, self.checksum = setting, program, path, checksum

    def image(self, samples, seed=SEED):
        label = "%d-%d" % (samples, seed)
        output, seconds = programs.cached(self.program, self.path, self.checksum, label, self.setting.size, samples, seed)
        return images.read_pfm(output), seconds

    def reference(self):
        return Reference(*(self.image(self.setting.reference, seed)[0] for seed in REFERENCE_SEEDS))

    def point(self, samples, reference):
        image, seconds = self.image(samples)
        return samples, reference.rel_mse(image)[0], seconds

    def once(self, few, many):
        """Seconds that do not depend on samples."""
        first, second = self.image(few)[1], self.image(many)[1]
        return first - few * (second - first) / (many - few)


def at_goal(first, second, column):
    """Samples (0) or seconds (2) at which the error is GOAL, by the power law through two points."""
    share = math.log(first[1] / GOAL) / math.log(first[1] / second[1])
    return math.exp(math.log(first[column]) + share * math.log(second[column] / first[column]))


def ours(setting, path, checksum):
    """Seconds, the net, and how it was reached."""
    raw = Measured(setting, programs.Ours(setting.renderer.program), path, checksum)
    reference, once, found = raw.reference(), raw.once(1, 17), []
    for kind in setting.kinds:
        one = Measured(setting, programs.Ours(raw.program.program, "ours-" + kind, KINDS[kind]), path, checksum)
        points = []
        for samples in SAMPLES:
            number, error, seconds = one.point(samples, reference)
            points.append((number, error, max(seconds - once, 1e-3)))
            if error <= GOAL:
                break
        if len(points) == 1:
            found.append((points[0][2], kind, "at %d sample, %.4f" % points[0][:2]))
            continue
        reached = "at %.1f samples" % at_goal(*points[-2:], 0)
        if points[-1][1] > GOAL:
            reached += ", continued from %.4f at %d" % (points[-1][1], points[-1][0])
        found.append((at_goal(*points[-2:], 2), kind, reached))
    return min(found)


def theirs(setting, path, checksum):
    cycles = Measured(setting, programs.Theirs(setting.blender), path, checksum)
    reference, once = cycles.reference(), cycles.once(*THEIR_SAMPLES)
    points = [(n, error, seconds - once) for n, error, seconds in (cycles.point(n, reference) for n in THEIR_SAMPLES)]
    return at_goal(*points, 2), "at %.0f samples, from %.3g at %d and %.3g at %d" % (
        at_goal(*points, 0), points[0][1], points[0][0], points[1][1], points[1][0])


def measure(setting, name, folder):
    scene = scenes.find(name, setting.models, folder)
    if scene is None:
        print("%-10s skipped: its model is not there" % name)
        return None
    path = os.path.join(folder, name)
    checksum = write_scene.write(scene, path)
    seconds, kind, reached = ours(setting, path, checksum)
    their_seconds, their_reached = theirs(setting, path, checksum)
    print("%-10s %s %.2f s (%s), Cycles %.1f s (%s): ratio %.4f" % (
        name, kind, seconds, reached, their_seconds, their_reached, seconds / their_seconds), flush=True)
    return seconds / their_seconds


def run(setting, names):
    if not setting.blender:
        raise SystemExit("skipped: Blender is not installed (scripts/setup.sh --peers)")
    folder = os.path.join(setting.folder, "time")
    os.makedirs(folder, exist_ok=True)
    ratios = [r for r in (measure(setting, name, folder) for name in names) if r]
    if ratios:
        print("geometric mean of %d: %.4f" % (len(ratios), mean_of(ratios)))
