"""What a display shows of an image: an exposure, the curve `luminance`, sRGB. docs/post.md has the formulas."""
import numpy

LUMINANCE = numpy.array((0.2126, 0.7152, 0.0722))
BLOCK, KEY = 16, 0.18


def luminance(image):
    return image @ LUMINANCE


def exposure(image):
    """The luminance that is shown as half of the range: as the nets take it, by the geometric mean of blocks."""
    light = luminance(image)
    blocks = [light[y:y + BLOCK, x:x + BLOCK].mean()
              for y in range(0, light.shape[0], BLOCK) for x in range(0, light.shape[1], BLOCK)]
    seen = [b for b in blocks if b > 1e-8]
    return numpy.exp(numpy.log(seen).mean()) / KEY if seen else 1.0


def srgb(linear):
    v = numpy.clip(linear, 0, 1)
    return numpy.where(v <= 0.0031308, 12.92 * v, 1.055 * v ** (1 / 2.4) - 0.055)


def shown(image, half):
    """0 to 1; `half`: the exposure. What is brighter than 1 in a channel fades to the grey of its luminance."""
    light = numpy.maximum(luminance(image), 0)
    grey, mapped = (light / (half + light))[..., None], image / (half + light)[..., None]
    largest = mapped.max(axis=-1, keepdims=True)
    bright = largest > 1
    kept = numpy.where(bright, (1 - grey) / numpy.where(bright, largest - grey, 1), 1)
    return srgb(grey + (mapped - grey) * kept)


def slope(image, half):
    """Codes of 255 by which a pixel changes with its luminance, in the units of radiance."""
    x = numpy.maximum(luminance(image), 0) / half
    v = x / (1 + x)
    curve = numpy.where(v <= 0.0031308, 12.92, 1.055 / 2.4 * numpy.maximum(v, 0.0031308) ** (1 / 2.4 - 1))
    return 255 * curve / (half * (1 + x) ** 2)


def psnr(image, truth):
    """Decibels, of two images as shown."""
    return -10 * numpy.log10(((image - truth) ** 2).mean())
