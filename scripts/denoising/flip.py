"""FLIP: how different two images look when one is flipped into the other (Andersson et al. 2020), at 67 pixels per degree.

Images are as shown, sRGB from 0 to 1; 0 is no difference, 1 the largest.
"""
import numpy

PER_DEGREE = 0.7 * 3840 / 0.7 * numpy.pi / 180  # a display of 3840 pixels and 0.7 m, seen from 0.7 m
TO_XYZ = numpy.array(((0.4123908, 0.3575843, 0.1804808), (0.2126390, 0.7151687, 0.0721923),
                      (0.0193308, 0.1191948, 0.9505322)))
WHITE = TO_XYZ.sum(axis=1)
# The eye's contrast sensitivity for light, red to green, and blue to yellow: sums of Gaussians, as (weight, width).
SENSITIVITY = (((1.0, 0.0047),), ((1.0, 0.0053),), ((34.1, 0.04), (13.5, 0.025)))
COLOUR_POWER, FEATURE_POWER, FEATURE_WIDTH = 0.7, 0.5, 0.082
KNEE, AT_KNEE = 0.4, 0.95


def flip(image, truth):
    """The mean over all pixels."""
    one, other = (_opponent(_linear(v)) for v in (image, truth))
    colour = _colour_difference(_perceived(one), _perceived(other))
    return float((colour ** (1 - _feature_difference(one[..., 0], other[..., 0]))).mean())


def _linear(v):
    return numpy.where(v <= 0.04045, v / 12.92, ((v + 0.055) / 1.055) ** 2.4)


def _opponent(linear):
    """YCxCz: CIELAB without its roots."""
    x, y, z = numpy.moveaxis(linear @ TO_XYZ.T / WHITE, 2, 0)
    return numpy.stack((116 * y - 16, 500 * (x - y), 200 * (y - z)), axis=2)


def _from_opponent(v):
    y = (v[..., 0] + 16) / 116
    xyz = numpy.stack((y + v[..., 1] / 500, y, y - v[..., 2] / 200), axis=2) * WHITE
    return numpy.clip(xyz @ numpy.linalg.inv(TO_XYZ).T, 0, 1)


def _grid(radius):
    along = numpy.arange(-radius, radius + 1)
    return numpy.meshgrid(along, along)


def _filtered(plane, kernel):
    """The kernel's sum around each pixel; pixels at the border are repeated outwards."""
    radius = kernel.shape[0] // 2
    wide = numpy.pad(plane, radius, mode="edge")
    size = [n + 2 * radius for n in wide.shape]
    product = numpy.fft.rfft2(wide, size) * numpy.fft.rfft2(kernel[::-1, ::-1], size)
    whole = numpy.fft.irfft2(product, size)
    return whole[2 * radius:2 * radius + plane.shape[0], 2 * radius:2 * radius + plane.shape[1]]


def _perceived(opponent):
    """CIELAB, blurred as the eye does, with less colour where it is dark (Hunt)."""
    widest = max(width for parts in SENSITIVITY for _, width in parts)
    x, y = _grid(int(numpy.ceil(3 * numpy.sqrt(widest / (2 * numpy.pi ** 2)) * PER_DEGREE)))
    square = (x ** 2 + y ** 2) / PER_DEGREE ** 2
    planes = []
    for channel, parts in enumerate(SENSITIVITY):
        kernel = sum(weight * numpy.sqrt(numpy.pi / width) * numpy.exp(-numpy.pi ** 2 * square / width)
                     for weight, width in parts)
        planes.append(_filtered(opponent[..., channel], kernel / kernel.sum()))
    return _hunt(_lab(_from_opponent(numpy.stack(planes, axis=2))))


def _lab(linear):
    v = linear @ TO_XYZ.T / WHITE
    edge = 6 / 29
    x, y, z = numpy.moveaxis(numpy.where(v > edge ** 3, numpy.cbrt(v), v / (3 * edge ** 2) + 4 / 29), 2, 0)
    return numpy.stack((116 * y - 16, 500 * (x - y), 200 * (y - z)), axis=2)


def _hunt(lab):
    return numpy.concatenate((lab[..., :1], 0.01 * lab[..., :1] * lab[..., 1:]), axis=2)


def _hyab(one, other):
    apart = one - other
    return (abs(apart[..., 0]) + numpy.hypot(apart[..., 1], apart[..., 2])) ** COLOUR_POWER


def _colour_difference(one, other):
    green, blue = (_hunt(_lab(numpy.array([[c]], float))) for c in ((0, 1, 0), (0, 0, 1)))
    largest = float(_hyab(green, blue)[0, 0])
    apart, knee = _hyab(one, other), KNEE * largest
    beyond = AT_KNEE + (apart - knee) / (largest - knee) * (1 - AT_KNEE)
    return numpy.where(apart < knee, AT_KNEE / knee * apart, beyond)


def _feature_difference(one, other):
    """Edges and points that only one of them has, in light."""
    width = 0.5 * FEATURE_WIDTH * PER_DEGREE
    x, y = _grid(int(numpy.ceil(3 * width)))
    bell = numpy.exp(-(x ** 2 + y ** 2) / (2 * width ** 2))
    found = []
    for kernel in (-x * bell, (x ** 2 / width ** 2 - 1) * bell):
        kernel = numpy.where(kernel > 0, kernel / kernel[kernel > 0].sum(), kernel / -kernel[kernel < 0].sum())
        strength = [numpy.hypot(_filtered(light, kernel), _filtered(light, kernel.T))
                    for light in ((one + 16) / 116, (other + 16) / 116)]
        found.append(abs(strength[0] - strength[1]))
    return (numpy.maximum(*found) / numpy.sqrt(2)) ** FEATURE_POWER
