"""Images in linear light: reading, how far two of them are apart, and both side by side."""
import os
import sys

import numpy

from geometry import beside

sys.path.insert(0, beside("..", "..", "data", "tools"))
import pictures  # noqa: E402

BLOCK = 16  # pixels along the edge of the blocks whose means are compared


def read_pfm(path):
    """Height x width x 3, top row first."""
    with open(path, "rb") as file:
        if file.readline().strip() != b"PF":
            raise SystemExit("%s: not a colour .pfm" % path)
        width, height = map(int, file.readline().split())
        order = "<f4" if float(file.readline()) < 0 else ">f4"
        values = numpy.frombuffer(file.read(), order)
    if len(values) != 3 * width * height or not numpy.isfinite(values).all():
        raise SystemExit("%s: not whole, or not finite" % path)
    return values.reshape(height, width, 3)[::-1].astype(float)


def blocks(image):
    """The pixels of each whole block, as blocks x pixels x channels."""
    rows, columns = image.shape[0] // BLOCK, image.shape[1] // BLOCK
    cut = image[:rows * BLOCK, :columns * BLOCK].reshape(rows, BLOCK, columns, BLOCK, 3)
    return cut.transpose(0, 2, 1, 3, 4).reshape(rows * columns, BLOCK * BLOCK, 3)


def relative_errors(image, one, other=None):
    """Squared error of each pixel over the square of what is right, with a hundredth of the mean's.

    With two independent references the product of what the image differs from each: their noise drops out of its mean.
    """
    other = one if other is None else other
    truth = (one + other) / 2
    return ((image - one) * (image - other) / (truth ** 2 + 0.01 * truth.mean() ** 2)).mean(axis=2).ravel()


def without_worst(errors, order=None):
    """Those of all but 0.1 % of the pixels: the worst by `order`, else by the errors themselves."""
    chosen = numpy.argsort(errors if order is None else order)
    return errors[chosen[:len(errors) - max(1, len(errors) // 1000)]]


def rel_mse(image, truth):
    """The mean of these errors, without the worst 0.1 % of the pixels, and with them."""
    errors = relative_errors(image, truth)
    return without_worst(errors).mean(), errors.mean()


def differences(ours, theirs):
    """How far two images of one scene are apart, and how much of it is noise: all in percent but relMSE.

    bias: of the means; sure: one standard error of it, by the pixels' differences; blocks: mean absolute difference of
    blocks; noise: what is to be expected of that if pixels differ by noise alone.
    """
    mean = theirs.mean()
    apart = (ours - theirs).mean(axis=2)
    sure = apart.std() / numpy.sqrt(apart.size)
    of_blocks = blocks(ours - theirs).mean(axis=2)
    expected = numpy.sqrt(2 / numpy.pi) * of_blocks.std(axis=1) / BLOCK
    trimmed, whole = rel_mse(ours, theirs)
    return {"bias": 100 * apart.mean() / mean, "sure": 100 * sure / mean,
            "blocks": 100 * abs(of_blocks.mean(axis=1)).mean() / mean, "noise": 100 * expected.mean() / mean,
            "relMSE": trimmed, "relMSE with worst": whole, "ours": ours.mean(), "theirs": mean}


def write_beside(path, ours, theirs):
    """Ours, theirs, and their difference, of which white is a fifth of the mean."""
    mean = theirs.mean()

    def shown(image):
        v = numpy.clip(image * 0.3 / mean, 0, 1)
        return numpy.where(v <= 0.0031308, 12.92 * v, 1.055 * v ** (1 / 2.4) - 0.055)

    write_shown(path, numpy.concatenate(
        (shown(ours), shown(theirs), numpy.clip(5 * abs(ours - theirs) / mean, 0, 1)), axis=1))


def write_shown(path, image):
    """A PNG of what a display shows, 0 to 1."""
    rows = (255 * image + 0.5).astype(numpy.uint8)
    pictures.write_png(path, rows.shape[1], rows.shape[0], [row.tobytes() for row in rows])


def exists(path):
    return os.path.isfile(path) and os.path.getsize(path) > 0
