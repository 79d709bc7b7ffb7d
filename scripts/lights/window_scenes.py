"""Rooms that a sky lights through windows and from above, as models and scenes that the Renderer reads."""
import os

from night_scenes import Boxes

SKY = "[sky]\nhour = 15.0\nlatitude = 48.0\nturbidity = 3.0\n"
VIEWS = {  # eye, forward, field of view, the rest of the scene's text
    "room": ((2.2, 1.6, 2.6), (-.8, -.12, -1), 70, "background = [1, 1, 1]\n", ""),
    "atrium": ((-6.5, 1.7, 4), (1, -.02, -.55), 75, "background = [0, 0, 0]\n", SKY),
    "flat": ((-4.4, 1.6, 2.4), (1, -.1, -.45), 75, "background = [0, 0, 0]\n", SKY),
    "open": ((-9, 3, 8), (1, -.25, -.9), 60, "background = [0, 0, 0]\n", SKY),
}
SCENES = tuple(VIEWS)


def walls(boxes, low, high, thick=.2, roof=True):
    """A room around the inside low..high, without its front wall at high z; that one is up to the caller."""
    (x0, y0, z0), (x1, y1, z1) = low, high
    boxes.add((x0 - thick, y0 - thick, z0 - thick), (x1 + thick, y0, z1 + thick))
    if roof:
        boxes.add((x0 - thick, y1, z0 - thick), (x1 + thick, y1 + thick, z1 + thick))
    boxes.add((x0 - thick, y0, z0 - thick), (x0, y1, z1 + thick))
    boxes.add((x0, y0, z0 - thick), (x1, y1, z0))


def pierced(boxes, axis, at, low, high, hole, thick=.2):
    """A wall across `axis` (0 or 2) with a hole (its low and high corner: along the wall, up)."""
    def part(a0, y0, a1, y1):
        if a1 <= a0 or y1 <= y0:
            return
        if axis == 0:
            boxes.add((at, y0, a0), (at + thick, y1, a1))
        else:
            boxes.add((a0, y0, at), (a1, y1, at + thick))
    (a0, y0), (a1, y1) = low, high
    (h0, b), (h1, t) = hole
    part(a0, y0, h0, y1)
    part(h1, y0, a1, y1)
    part(h0, y0, h1, b)
    part(h0, t, h1, y1)


def table(boxes, x, z):
    boxes.material("brick")
    boxes.add((x - .7, .7, z - .4), (x + .7, .75, z + .4))
    for side in (-.6, .6):
        boxes.add((x + side - .04, 0, z - .3), (x + side + .04, .7, z - .22))
        boxes.add((x + side - .04, 0, z + .22), (x + side + .04, .7, z + .3))
    boxes.material("wall")


def room(boxes):
    """5 x 6 m with one window of 1.2 x 1.2 m."""
    walls(boxes, (-2.5, 0, -3), (2.5, 2.7, 3))
    pierced(boxes, 2, 3, (-2.7, 0), (2.7, 2.7), ((0, 0), (0, 0)))
    pierced(boxes, 0, 2.5, (-3, 0), (3, 2.7), ((-2, .9), (-.8, 2.1)))
    table(boxes, -.8, -.6)


def atrium(boxes):
    """A court of 16 x 12 m among galleries on columns, open above."""
    boxes.add((-10, -.2, -8), (10, 0, 8))
    for x0, z0, x1, z1 in ((-10, -8, 10, -7.8), (-10, 7.8, 10, 8), (-10, -7.8, -9.8, 7.8), (9.8, -7.8, 10, 7.8)):
        boxes.add((x0, 0, z0), (x1, 9, z1))
    for up in (3.2, 6.4):
        for x0, z0, x1, z1 in ((-9.8, -7.8, 9.8, -5), (-9.8, 5, 9.8, 7.8), (-9.8, -5, -7, 5), (7, -5, 9.8, 5)):
            boxes.add((x0, up, z0), (x1, up + .25, z1))
    boxes.material("brick")
    for x in (-7, -3.5, 0, 3.5, 7):
        for z in (-5, 5):
            boxes.add((x - .2, 0, z - .2), (x + .2, 9, z + .2))
    for z in (-2.5, 0, 2.5):
        for x in (-7, 7):
            boxes.add((x - .2, 0, z - .2), (x + .2, 9, z + .2))


def flat(boxes):
    """Two rooms and a door between them; a window in the far one, a small one in the near one."""
    boxes.add((-5.2, -.2, -3.2), (5.2, 0, 3.2))
    boxes.add((-5.2, 2.6, -3.2), (5.2, 2.8, 3.2))
    pierced(boxes, 0, -5.2, (-3.2, 0), (3.2, 2.6), ((-2.6, 1.2), (-2, 1.8)))
    pierced(boxes, 0, 5, (-3.2, 0), (3.2, 2.6), ((-1, .8), (1.4, 2.2)))
    pierced(boxes, 0, -.1, (-3, 0), (3, 2.6), ((-.5, 0), (.5, 2.1)))
    boxes.add((-5, 0, -3.2), (5, 2.6, -3))
    boxes.add((-5, 0, 3), (5, 2.6, 3.2))
    table(boxes, -2.6, -.4)
    table(boxes, 2.8, 1)


def open_ground(boxes):
    """Blocks on a plain: most points see most of the sky."""
    boxes.add((-40, -.2, -40), (40, 0, 40))
    boxes.material("brick")
    for i in range(5):
        for k in range(3):
            boxes.add((4 * i - 9, 0, 4 * k - 7), (4 * i - 8, 1 + (i * 7 + k * 3) % 4 * .5, 4 * k - 6))


def write(folder, scene):
    """Gives the scene's path without its extension."""
    name = os.path.join(folder, "window-" + scene)
    boxes = Boxes(os.path.basename(name) + ".mtl")
    boxes.material("wall")
    {"room": room, "atrium": atrium, "flat": flat, "open": open_ground}[scene](boxes)
    with open(name + ".mtl", "w", encoding="ascii") as file:
        file.write("newmtl wall\nKd .7 .7 .7\nnewmtl brick\nKd .6 .25 .2\n")
    with open(name + ".obj", "w", encoding="ascii") as file:
        file.write("\n".join(boxes.lines) + "\n")
    eye, forward, fov, background, sky = VIEWS[scene]
    with open(name + ".scn", "w", encoding="ascii") as file:
        file.write("version = 2\nmodel = \"%s.obj\"\nambient = [0, 0, 0]\ndefaultLight = false\n%s[camera]\neye = %s\n"
                   "forward = %s\nfov = %.1f\n%s" % (os.path.basename(name), background, list(eye), list(forward),
                                                      fov, sky))
    return name
