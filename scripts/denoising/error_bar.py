"""True squared error over the estimated one, in codes of 255, by blocks of 8 x 8: of what is shown by `base`, mixed."""
import display
import numpy
from rendering import mean_of, sampled

BLOCK = 8


def blocks(values):
    rows, columns = values.shape[0] // BLOCK, values.shape[1] // BLOCK
    cut = values[:rows * BLOCK, :columns * BLOCK].reshape(rows, BLOCK, columns, BLOCK)
    return cut.mean(axis=(1, 3)).ravel()


def measure(setting, name, view):
    reference = setting.renderer.reference(name, view, setting.reference)
    for samples in setting.samples:
        exr = setting.renderer.image(name, view, samples, "base")
        if "error.Y" not in exr.channels:
            print("%-14s %5d its file has no estimate" % (name, samples))
            continue
        image = exr.colours()
        codes = display.slope(image, display.exposure(sampled(exr))) ** 2
        true = blocks(codes * ((image - reference.one) * (image - reference.other)).mean(axis=2))
        estimated = blocks(exr.channels["error.Y"].astype(float) ** 2)
        both = (true > 0) & (estimated > 0)
        ratios = true[both] / estimated[both]
        low, high = numpy.percentile(ratios, (10, 90))
        print("%-14s %5d  true over estimated: %.2f in geometric mean of %d blocks of %d, 10 and 90 %%: %.2f %.2f; "
              "of the whole image %.2f, +-%.2f of 255 for +-%.2f" % (
                  name, samples, mean_of(ratios), both.sum(), len(both), low, high, true.sum() / estimated.sum(),
                  numpy.sqrt(max(0, true.mean())), numpy.sqrt(estimated.mean())), flush=True)


def run(setting, views):
    for name, view in views:
        measure(setting, name, view)
