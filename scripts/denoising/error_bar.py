"""True squared error over the estimated one, in codes of 255, by blocks of 8 x 8: of what is shown by `base`, mixed.

The true error is that of light, in codes by the display's slope at the pixel that is shown, as the estimate counts it;
and that of what a display shows, which is far smaller where a pixel misses light that is brighter than white.
"""
import display
import numpy
from rendering import mean_of, sampled

BLOCK = 8


def blocks(values):
    rows, columns = values.shape[0] // BLOCK, values.shape[1] // BLOCK
    cut = values[:rows * BLOCK, :columns * BLOCK].reshape(rows, BLOCK, columns, BLOCK)
    return cut.mean(axis=(1, 3)).ravel()


def true_errors(image, reference, half):
    """Squares by blocks, under what they are errors of."""
    def product(differ):
        return (differ(reference.one) * differ(reference.other)).mean(axis=2)

    codes = 255 * display.shown(image, half)
    return {"light": blocks(display.slope(image, half) ** 2 * product(lambda truth: image - truth)),
            "display": blocks(product(lambda truth: codes - 255 * display.shown(truth, half)))}


def measure(setting, name, view):
    reference = setting.renderer.reference(name, view, setting.reference)
    for samples in setting.samples:
        exr = setting.renderer.image(name, view, samples, "base")
        if "error.Y" not in exr.channels:
            print("%-14s %5d its file has no estimate" % (name, samples))
            continue
        estimated = blocks(exr.channels["error.Y"].astype(float) ** 2)
        for kind, true in true_errors(exr.colours(), reference, display.exposure(sampled(exr))).items():
            _tell("%-14s %5d %-8s" % (name, samples, kind), true, estimated)


def _tell(label, true, estimated):
    both = (true > 0) & (estimated > 0)
    ratios = true[both] / estimated[both]
    low, high = numpy.percentile(ratios, (10, 90))
    print("%s true over estimated: %.2f in geometric mean of %d blocks of %d, 10 and 90 %%: %.2f %.2f; "
          "of the whole image %.2f, +-%.2f of 255 for +-%.2f" % (
              label, mean_of(ratios), both.sum(), len(both), low, high, true.sum() / estimated.sum(),
              numpy.sqrt(max(0, true.mean())), numpy.sqrt(estimated.mean())), flush=True)


def run(setting, views):
    for name, view in views:
        measure(setting, name, view)
