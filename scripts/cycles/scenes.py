"""The scenes of scripts/compare-cycles.sh that need no files. `models.py` has those of well-known models."""
import math
import os
import sys

import numpy

from description import Light, Scene
from geometry import beside

sys.path[:0] = [beside("..", "..", "data", "tools"), beside("..", "lights")]
import mesh           # noqa: E402
import solids         # noqa: E402
import window_scenes  # noqa: E402

WHITE, RED, GREEN = (0.725, 0.71, 0.68), (0.63, 0.065, 0.05), (0.14, 0.45, 0.091)


def quad(scene, material, *corners):
    scene.soup.polygon(material, *corners)


def ball(scene, material, centre, radius, levels=5):
    scene.soup.surface(material, solids.displaced(
        solids.icosphere(levels), lambda p: mesh.add(centre, mesh.scale(p, radius))))


def block(scene, material, centre, half, degrees):
    """A box turned about the vertical; `centre` is the middle of its bottom."""
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    surface = solids.box((-half[0], 0.0, -half[2]), (half[0], 2 * half[1], half[2]))
    surface.positions = [(centre[0] + c * x + s * z, centre[1] + y, centre[2] + c * z - s * x)
                         for x, y, z in surface.positions]
    scene.soup.surface(material, surface)


def chequers(scene, light, dark, low, high, count):
    step = (high - low) / count
    for i in range(count):
        for k in range(count):
            x, z = low + i * step, low + k * step
            quad(scene, (light, dark)[(i + k) % 2],
                 (x, 0, z), (x, 0, z + step), (x + step, 0, z + step), (x + step, 0, z))


def evening_sky(width=256):
    """A bright patch, wide enough to be the same however a program samples it, over a gradient and darker ground."""
    height = width // 2
    up = numpy.cos(math.pi * (numpy.arange(height) + 0.5) / height)[:, None]
    turn = 2 * math.pi * ((numpy.arange(width) + 0.5) / width - 0.5)[None, :]
    flat = numpy.sqrt(1 - up * up)
    at = (flat * numpy.sin(turn), up + 0 * turn, -flat * numpy.cos(turn))
    middle = numpy.array((0.55, 0.6, 0.58))
    cosine = sum(a * m for a, m in zip(at, middle / numpy.linalg.norm(middle)))
    sun = numpy.exp(-(1 - cosine) / 0.01)[..., None] * (60.0, 42.0, 25.0)
    blue = 0.5 + 0.5 * numpy.clip(at[1], -1, 1)[..., None] ** 3 * (0.2, 0.5, 1.0)
    return (sun + blue * (0.5, 0.7, 1.0)).astype(numpy.float32)


def plane(light=None, background=(0.0, 0.0, 0.0)):
    """A grey floor lit directly by one light: whether both mean the same by its strength."""
    scene = Scene((0, 1.5, 1.5), (0, 0, 0), 40.0, bounces=0, background=background)
    quad(scene, scene.material((0.5, 0.5, 0.5)), (-4, 0, 4), (4, 0, 4), (4, 0, -4), (-4, 0, -4))
    scene.lights = [light] if light else []
    return scene


def plane_emission():
    scene = plane()
    high = scene.material(emission=(3.0, 2.0, 1.0))
    quad(scene, high, (-0.5, 2, -0.5), (0.5, 2, -0.5), (0.5, 2, 0.5), (-0.5, 2, 0.5))
    return scene


PLACE = {"position": (0.4, 2.0, -0.3), "direction": (0.0, -1.0, 0.0)}


def cube():
    """The closed cube of a Cornell box's colours, with a black square that emits in its ceiling."""
    scene = Scene((0.5, 0.5, 0.98), (0.5, 0.5, 0.0), 80.0, bounces=32)
    white, red, green = (scene.material(c) for c in (WHITE, RED, GREEN))
    lit = scene.material(emission=(1.0, 1.0, 1.0))
    steps = (0.0, 0.3, 0.7, 1.0)
    for i in range(3):
        for k in range(3):
            a, b, c, d = steps[i], steps[i + 1], steps[k], steps[k + 1]
            quad(scene, lit if i == k == 1 else white, (a, 1, c), (b, 1, c), (b, 1, d), (a, 1, d))
    quad(scene, white, (0, 0, 1), (1, 0, 1), (1, 0, 0), (0, 0, 0))
    quad(scene, white, (0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0))
    quad(scene, white, (1, 0, 1), (0, 0, 1), (0, 1, 1), (1, 1, 1))
    quad(scene, red, (0, 0, 1), (0, 0, 0), (0, 1, 0), (0, 1, 1))
    quad(scene, green, (1, 0, 0), (1, 0, 1), (1, 1, 1), (1, 1, 0))
    return scene


def sky():
    """Balls and a block on a chequered floor under a sky."""
    scene = Scene((0.4, 1.3, 3.6), (0.0, 0.5, 0.0), 50.0, bounces=12, sky=evening_sky())
    chequers(scene, scene.material((0.8, 0.78, 0.72)), scene.material((0.12, 0.16, 0.3)), -3.0, 3.0, 12)
    ball(scene, scene.material((0.75, 0.2, 0.12)), (-0.8, 0.5, 0.2), 0.5)
    ball(scene, scene.material((0.6, 0.6, 0.55)), (0.5, 0.35, 0.7), 0.35)
    block(scene, scene.material((0.2, 0.5, 0.25)), (0.6, 0.0, -0.7), (0.4, 0.6, 0.3), 25.0)
    return scene


def sunny_sky(width=2048):
    """A sun of its true size, some ten texels that shine as a real one does over a sky, as photographs have it."""
    height = width // 2
    up = numpy.cos(math.pi * (numpy.arange(height) + 0.5) / height)[:, None]
    turn = 2 * math.pi * ((numpy.arange(width) + 0.5) / width - 0.5)[None, :]
    flat = numpy.sqrt(1 - up * up)
    middle = numpy.array((0.48, 0.62, 0.62))
    cosine = sum(a * m for a, m in zip((flat * numpy.sin(turn), up, -flat * numpy.cos(turn)),
                                       middle / numpy.linalg.norm(middle)))
    sun = (cosine > math.cos(math.radians(0.27)))[..., None] * (40000.0, 36000.0, 30000.0)
    blue = numpy.where(up + 0 * turn > 0, 0.6 - 0.3 * up, 0.25)[..., None] * (0.5, 0.7, 1.0)
    return (sun + blue).astype(numpy.float32)


def sun():
    """The scene of `sky` under a sun."""
    scene = sky()
    scene.sky = sunny_sky()
    return scene


class Boxes:
    """Takes boxes of the scenes that light comes into by windows and from above."""

    def __init__(self, scene, colours):
        self.scene, self.materials = scene, {name: scene.material(colour) for name, colour in colours.items()}
        self.material(next(iter(colours)))

    def material(self, name):
        self.now = self.materials[name]

    def add(self, low, high):
        self.scene.soup.surface(self.now, solids.box(low, high))


def court():
    """A court among galleries on columns, open above, under a sky with a sun."""
    eye, forward, fov, *_ = window_scenes.VIEWS["atrium"]
    scene = Scene(eye, mesh.add(eye, forward), fov, bounces=12, sky=sunny_sky())
    window_scenes.atrium(Boxes(scene, {"wall": (0.7, 0.7, 0.7), "brick": (0.6, 0.25, 0.2)}))
    return scene


def room(scene, panel):
    """A matte room under a panel in its ceiling that emits."""
    x, y, z = 3.0, 3.0, 3.0
    white, red = scene.material((0.75, 0.75, 0.7)), scene.material((0.7, 0.15, 0.1))
    green, blue = scene.material((0.15, 0.55, 0.2)), scene.material((0.1, 0.2, 0.65))
    ochre, lit = scene.material((0.7, 0.5, 0.2)), scene.material(emission=panel)
    quad(scene, ochre, (-x, 0, z), (x, 0, z), (x, 0, -z), (-x, 0, -z))
    quad(scene, white, (-x, y, -z), (x, y, -z), (x, y, z), (-x, y, z))
    quad(scene, white, (-x, 0, -z), (x, 0, -z), (x, y, -z), (-x, y, -z))
    quad(scene, blue, (x, 0, z), (-x, 0, z), (-x, y, z), (x, y, z))
    quad(scene, red, (-x, 0, z), (-x, 0, -z), (-x, y, -z), (-x, y, z))
    quad(scene, green, (x, 0, -z), (x, 0, z), (x, y, z), (x, y, -z))
    quad(scene, lit, (-1.2, y - 0.05, -1.2), (1.2, y - 0.05, -1.2), (1.2, y - 0.05, 1.2), (-1.2, y - 0.05, 1.2))
    return white, blue


def mirrors():
    """A mirror on the wall, a mirrored block and a mirrored ball in a matte room."""
    scene = Scene((0.4, 1.7, 2.8), (-0.1, 1.0, -1.0), 75.0, bounces=48, caustics=True)
    white, blue = room(scene, (5.0, 4.6, 4.0))
    mirror = scene.material((0.2, 0.2, 0.2), mirror=0.8)
    quad(scene, mirror, (-1.6, 0.9, -2.95), (0.6, 0.9, -2.95), (0.6, 2.4, -2.75), (-1.6, 2.4, -2.75))
    block(scene, mirror, (1.5, 0.0, -1.2), (0.45, 0.8, 0.35), 25.0)
    ball(scene, mirror, (1.1, 0.35, 0.3), 0.35)
    block(scene, white, (-1.3, 0.0, -1.4), (0.35, 0.7, 0.35), -20.0)
    block(scene, blue, (0.1, 0.0, -0.6), (0.4, 0.25, 0.3), 35.0)
    return scene


def glass():
    """A ball and a block of glass in the same room."""
    scene = Scene((0.4, 1.5, 2.8), (0.0, 0.7, -0.6), 65.0, bounces=48, caustics=True)
    white, blue = room(scene, (5.0, 4.6, 4.0))
    ball(scene, scene.material(glass=1.5), (0.75, 0.6, 0.5), 0.5)
    block(scene, scene.material(glass=1.33), (-0.8, 0.1, 0.3), (0.35, 0.5, 0.3), 25.0)
    block(scene, white, (-1.3, 0.0, -1.6), (0.35, 0.7, 0.35), -20.0)
    block(scene, blue, (0.6, 0.0, -1.4), (0.4, 0.25, 0.3), 35.0)
    return scene


def under_sky(*materials):
    """A ball and a block on chequers under a sky, of glass."""
    scene = Scene((0.4, 1.5, 3.2), (0.0, 0.5, 0.0), 50.0, bounces=32, caustics=True, sky=evening_sky())
    chequers(scene, scene.material((0.8, 0.78, 0.72)), scene.material((0.3, 0.3, 0.36)), -3.0, 3.0, 8)
    one, other = (scene.material(**told) for told in materials)
    ball(scene, one, (-0.65, 0.62, 0.2), 0.6)
    block(scene, other, (0.7, 0.02, 0.1), (0.45, 0.55, 0.3), 25.0)
    return scene


def tinted():
    return under_sky({"glass": 1.5, "absorbs": (0.2, 0.9, 1.6)}, {"glass": 1.33, "absorbs": (1.2, 0.3, 0.15)})


def frosted():
    return under_sky({"glass": 1.5, "roughness": 0.13}, {"glass": 1.33, "roughness": 0.1, "absorbs": (0.5, 0.2, 0.1)})


def metals():
    """Balls of rough metal in the same room."""
    scene = Scene((0.4, 1.5, 2.8), (0.0, 0.6, -0.6), 65.0, bounces=24, caustics=True)
    room(scene, (5.0, 4.6, 4.0))
    for i, roughness in enumerate((0.2, 0.4, 0.7, 1.0)):
        ball(scene, scene.material(metal=(0.9, 0.75, 0.4), roughness=roughness), (-1.5 + i, 0.45, -0.4), 0.42)
    return scene


def whites():
    """Balls of white rough metal on a floor of it, under a rectangle."""
    scene = Scene((0.0, 1.2, 4.0), (0.0, 0.1, 0.0), 55.0, bounces=24, caustics=True)
    quad(scene, scene.material(metal=(1.0, 1.0, 1.0), roughness=0.5), (-5, 0, 5), (5, 0, 5), (5, 0, -5), (-5, 0, -5))
    for i, roughness in enumerate((0.2, 0.35, 0.7, 1.0)):
        ball(scene, scene.material(metal=(1.0, 1.0, 1.0), roughness=roughness), (-1.5 + i, 0.45, 0.3), 0.42)
    scene.lights = [Light("rectangle", (20.0, 20.0, 20.0), position=(0.0, 2.0, -3.0), direction=(0.0, -0.3, 1.0),
                          size=(1.5, 1.0))]
    return scene


def furnished():
    import furnished as furniture  # noqa: PLC0415
    return furniture.furnished()


SCENES = {
    "plane-point": lambda: plane(Light("point", (4.0, 3.0, 2.0), **PLACE)),
    "plane-directional": lambda: plane(Light("directional", (3.0, 2.0, 1.0), direction=(-0.3, -1.0, 0.2))),
    "plane-sphere": lambda: plane(Light("sphere", (4.0, 3.0, 2.0), radius=0.3, **PLACE)),
    "plane-rectangle": lambda: plane(Light("rectangle", (4.0, 3.0, 2.0), size=(1.2, 0.6), **PLACE)),
    "plane-emission": plane_emission,
    "plane-background": lambda: plane(background=(0.7, 0.5, 0.3)),
    "cube": cube, "court": court, "sky": sky, "sun": sun, "mirrors": mirrors, "glass": glass, "metals": metals,
    "whites": whites, "tinted": tinted, "frosted": frosted, "furnished": furnished,
}


def find(name, models, work):
    """The scene of that name; None when its model is not to be had. `work`: folder for textures that are unpacked."""
    if name in SCENES:
        return SCENES[name]()
    import models as known  # noqa: PLC0415
    return known.find(name, models, work) if os.path.isdir(models) else None
