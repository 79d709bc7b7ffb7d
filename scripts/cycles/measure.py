"""Speed of the path tracer beside Cycles, for scripts/performance/cycles.sh.

    measure.py FOLDER WIDTH HEIGHT ROUNDS REFERENCE TIMES RENDERER BLENDER MODELS NAME...

One thread each, in turns, in seconds of user processor time; what is done once (start, model, tree) is out, since only
differences between two numbers of samples count. REFERENCE: seconds that the image takes which a program's own errors
are measured against; TIMES: the times at which they are, with commas between.
"""
import math
import os
import statistics
import sys

import images
import programs
import scenes
import write_scene

PILOT = 8      # samples of a first guess
LONG = 8.0     # seconds that the longer of the two renderings shall take beyond the shorter
SEED = 7       # of the references, so that they share no sample with what is measured


class Measured:
    """One program on one scene."""

    def __init__(self, program, scene, checksum, size):
        self.program, self.scene, self.checksum, self.size = program, scene, checksum, size
        self.pixels = size[0] * size[1]
        self.once, self.differences = [], []
        once = self.seconds(1)
        self.rate = PILOT / max(self.seconds(1 + PILOT) - once, 0.05)
        if self.rate * LONG > 8 * PILOT:
            self.rate = 8 * PILOT / max(self.seconds(1 + 8 * PILOT) - once, 0.05)
        self.samples = max(PILOT, round(self.rate * LONG))

    def seconds(self, samples):
        return self.program.render(self.scene, "%s-%s-timed.pfm" % (self.scene, self.program.name), self.size, samples)

    def round(self):
        once, many = self.seconds(1), self.seconds(1 + self.samples)
        self.once.append(once)
        self.differences.append(many - once)
        self.rate = self.samples / statistics.median(self.differences)

    @property
    def paths(self):
        """Per second."""
        return self.rate * self.pixels

    def image(self, label, seconds, seed=0):
        samples = max(1, round(self.rate * seconds))
        path, _ = programs.cached(self.program, self.scene, self.checksum, "speed-%s" % label, self.size, samples, seed)
        return images.read_pfm(path), samples

    def errors(self, seconds, reference):
        """relMSE without the worst 0.1 % of the pixels, and with them. The reference's own error is taken off."""
        truth, behind = reference
        image, samples = self.image("%g" % seconds, seconds)
        own = 1 + samples / behind
        return tuple(value / own for value in images.rel_mse(image, truth))


def measure(name, scene, setting):
    path = os.path.join(setting.folder, name)
    checksum = write_scene.write(scene, path)
    both = [Measured(program, path, checksum, setting.size) for program in setting.programs]
    for _ in range(setting.rounds):
        for one in both:
            one.round()
    ours, theirs = both
    row = {"paths": ours.paths / theirs.paths}
    print("%-12s paths/s %8.0f %8.0f  ratio %5.2f   once, s %6.2f %6.2f" % (
        name, ours.paths, theirs.paths, row["paths"], *(statistics.median(b.once) for b in both)), flush=True)
    if not setting.times:
        return row
    references = [b.image("reference", setting.reference, SEED) for b in both]
    for seconds in setting.times:
        (first, first_all), (second, second_all) = (b.errors(seconds, r) for b, r in zip(both, references))
        row["%g s" % seconds], row["%g s, with worst" % seconds] = first / second, first_all / second_all
        print("%-12s %5g s   relMSE %8.2e %8.2e  ratio %5.3f   with the worst 0.1 %% %8.2e %8.2e  ratio %5.3f" % (
            name, seconds, first, second, first / second, first_all, second_all, first_all / second_all), flush=True)
    return row


class Setting:
    def __init__(self, words):
        self.folder, width, height, rounds, reference, times, renderer, blender, self.models = words
        self.size, self.rounds, self.reference = (int(width), int(height)), int(rounds), float(reference)
        self.times = [float(t) for t in times.split(",") if float(t) > 0]
        # A sphere light of Cycles' own: for its speed it does not matter that it is a disc.
        self.programs = programs.Ours(renderer), programs.Theirs(blender, own_spheres=True)


def main():
    setting = Setting(sys.argv[1:10])
    print("%d x %d, ours and Cycles (%s)" % (*setting.size, setting.programs[1].version))
    rows = []
    for name in sys.argv[10:]:
        scene = scenes.find(name, setting.models, setting.folder)
        if scene is None:
            print("%-12s skipped: its model is not there" % name)
            continue
        try:
            rows.append(measure(name, scene, setting))
        except programs.Failed as error:
            print("%-12s %s" % (name, error))
    for key in rows[0] if rows else ():
        values = [row[key] for row in rows]
        print("geometric mean of %d: %-18s %.3f" % (len(values), key, math.exp(statistics.fmean(map(math.log, values)))))


if __name__ == "__main__":
    main()
