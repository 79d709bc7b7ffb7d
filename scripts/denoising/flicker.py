"""How much the same image differs between seeds, in codes of 255: the standard deviation over five, mean and 95 %."""
import display
import numpy
from rendering import sampled

SEEDS = range(7, 12)


def deviation(images, half):
    codes = numpy.stack([255 * display.shown(image, half) for image in images])
    of_pixels = codes.std(axis=0, ddof=1).mean(axis=2)
    return "%.2f / %.2f" % (of_pixels.mean(), numpy.percentile(of_pixels, 95))


def measure(setting, name, view):
    for samples in setting.samples:
        found, half = {}, None
        for kind in setting.kinds:
            files = [setting.renderer.image(name, view, samples, kind, seed) for seed in SEEDS]
            raw = [sampled(exr) for exr in files]
            half = half or display.exposure(sum(raw) / len(raw))
            found["raw"] = deviation(raw, half)
            found[kind] = deviation([exr.colours() for exr in files], half)
        print("| %s, %d | %s |" % (name, samples, " | ".join("%s %s" % pair for pair in found.items())), flush=True)


def run(setting, views):
    for name, view in views:
        measure(setting, name, view)
