"""Images by the Renderer, kept so that a run that was stopped goes on, and the references that they are held against."""
import os

import paths  # noqa: F401

import images
import numpy
import programs
from exr import Exr

PART = 256         # samples of one image of a reference
FIRST_SEED = 1001  # of references: odd ones are the one, even ones the other
RAW = ("--setting=denoise.passes=0", "--setting=path.filter=0")
KINDS = {"filter": ("--setting=denoise.passes=3",), "small": RAW + ("--denoise=small",),
         "base": RAW + ("--denoise=base",), "large": RAW + ("--denoise=large",)}


class Renderer:
    def __init__(self, program, folder, size):
        self.program, self.folder, self.size = program, folder, size
        status = os.stat(program)
        self.version = "%d-%d" % (status.st_size, status.st_mtime)
        os.makedirs(os.path.join(folder, "references"), exist_ok=True)

    def render(self, view, output, samples, seed, options):
        """Seconds of user time, of one thread."""
        return programs.run(
            [self.program, *view, "-o", output, "-w", str(self.size[0]), "-h", str(self.size[1]), "--integrator=path",
             "--samples=%d" % samples, "--setting=path.seed=%d" % seed, "--threads=1", "--progress=none", *options],
            output + ".log")

    def image(self, name, view, samples, kind, seed=7):
        """An Exr with the image by one of KINDS, and what was sampled for it (`sampled`)."""
        output = os.path.join(self.folder, "%s-%s-%d-%d.exr" % (name, kind, samples, seed))
        if not _is_kept(output, self.version):
            self.render(view, output + ".part.exr", samples, seed, KINDS[kind] + ("--aovs",))
            _keep(output, ".part.exr", self.version)
        return Exr(output)

    def reference(self, name, view, samples):
        """Two images that share no sample, of so many each. They are kept whatever the Renderer's version."""
        parts = max(1, samples // PART)
        both = []
        for which in range(2):
            seeds = range(FIRST_SEED + which, FIRST_SEED + which + 2 * parts, 2)
            both.append(sum(self._part(name, view, seed) for seed in seeds) / parts)
        return Reference(*both)

    def _part(self, name, view, seed):
        output = os.path.join(self.folder, "references", "%s-%d.pfm" % (name, seed))
        if not images.exists(output):
            self.render(view, output + ".part.pfm", PART, seed, RAW)
            os.replace(output + ".part.pfm", output)
        return images.read_pfm(output)


class Reference:
    def __init__(self, one, other):
        self.one, self.other, self.mean = one, other, (one + other) / 2
        # How much the two differ says which pixels are the worst, whatever the image that is measured.
        self.order = abs(images.relative_errors(one, self.mean))

    def rel_mse(self, image):
        """Without the references' worst 0.1 % of the pixels, with them, and without the image's own worst."""
        errors = images.relative_errors(image, self.one, self.other)
        return images.without_worst(errors, self.order).mean(), errors.mean(), images.without_worst(errors).mean()


def sampled(exr):
    """The image before any effect; files without effects have no other."""
    return exr.colours("sampled." if exr.has("sampled.") else "")


def _is_kept(output, key):
    if not (images.exists(output) and images.exists(output + ".key")):
        return False
    with open(output + ".key", encoding="ascii") as file:
        return file.read() == key


def _keep(output, part, key):
    os.replace(output + part, output)
    with open(output + ".key", "w", encoding="ascii") as file:
        file.write(key)


def mean_of(values):
    return float(numpy.exp(numpy.mean(numpy.log(values))))
