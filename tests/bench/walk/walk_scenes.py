"""Scenes that are lit by way of surfaces, to walk through: a furnished flat, a cellar with a bulb, a gallery
of glass, a street. Each is made as a model and a scene; make_walks.py has the walks."""
import pathlib
import random
import sys

sys.path.insert(1, str(pathlib.Path(__file__).resolve().parents[3] / "scripts/lights"))
from night_scenes import Boxes            # noqa: E402
from window_scenes import pierced, table  # noqa: E402

MATERIALS = {"wall": (.72, .7, .66), "brick": (.55, .24, .18), "wood": (.42, .26, .13), "cloth": (.2, .28, .5),
             "leaf": (.12, .35, .1), "stone": (.5, .48, .44), "dark": (.12, .12, .13), "red": (.62, .1, .08)}
SKY = "[sky]\nhour = %.1f\nlatitude = 48.0\nturbidity = 3.0\n"
POINT = "[[light]]\nkind = \"point\"\nposition = %s\nintensity = %s\n"


def of(boxes, material, *parts):
    boxes.material(material)
    for low, high in parts:
        boxes.add(low, high)


def bed(boxes, x, z):
    of(boxes, "wood", ((x, 0, z), (x + 2, .3, z + 1.6)), ((x - .06, 0, z), (x, .9, z + 1.6)))
    of(boxes, "cloth", ((x, .3, z), (x + 2, .5, z + 1.6)))


def shelf(boxes, x, z, chance):
    """Boards along x with books."""
    of(boxes, "wood", *(((x, .4 * k, z), (x + 1.6, .4 * k + .03, z + .3)) for k in range(6)),
       ((x - .03, 0, z), (x, 2.03, z + .3)), ((x + 1.6, 0, z), (x + 1.63, 2.03, z + .3)))
    for k in range(5):
        at = x + .02
        while at < x + 1.4:
            wide = chance.uniform(.02, .06)
            of(boxes, chance.choice(("red", "cloth", "leaf", "dark", "wall")),
               ((at, .4 * k + .03, z + .08), (at + wide, .4 * k + chance.uniform(.2, .36), z + .28)))
            at += wide + .005


def flat(boxes, chance):
    """Hall, living room, kitchen and bedroom of 11 x 8 m; the sky comes in by four windows."""
    of(boxes, "wood", ((-5.7, -.2, -4.2), (5.7, 0, 4.2)))
    of(boxes, "wall", ((-5.7, 2.6, -4.2), (5.7, 2.8, 4.2)))
    pierced(boxes, 2, -4.2, (-5.7, 0), (5.7, 2.6), ((-4, .8), (-1.8, 2.2)))
    pierced(boxes, 2, 4, (-5.7, 0), (5.7, 2.6), ((2.2, .9), (3.8, 2.1)))
    pierced(boxes, 0, -5.7, (-4, 0), (4, 2.6), ((1.2, .9), (2.4, 2.1)))
    pierced(boxes, 0, 5.5, (-4, 0), (4, 2.6), ((-2.6, .2), (-1, 2.2)))
    pierced(boxes, 0, -.1, (-4, 0), (.4, 2.6), ((-1.6, 0), (-.7, 2.1)), .12)
    pierced(boxes, 2, .4, (-5.5, 0), (5.5, 2.6), ((-3.2, 0), (-2.3, 2.1)), .12)
    pierced(boxes, 0, 1.4, (.52, 0), (4, 2.6), ((1, 0), (1.9, 2.1)), .12)
    table(boxes, -2.6, -2.2)
    table(boxes, -4.2, 2.6)
    bed(boxes, 2.6, -3.6)
    of(boxes, "cloth", ((-5.3, 0, -3.2), (-4.4, .42, -1)), ((-5.5, .42, -3.2), (-5.3, .85, -1)))
    of(boxes, "wall", ((4.9, 0, 1), (5.5, .9, 3.8)))
    of(boxes, "dark", ((4.88, .9, 1), (5.5, .94, 3.8)))
    of(boxes, "wood", ((.5, 0, -3.9), (2, 2.2, -3.4)))
    for x, z in ((-1.9, -.02), (-4.9, .54), (3, .1)):
        shelf(boxes, x, z if z > .4 else z - .32, chance)
    return "ambient = [0, 0, 0]\nbackground = [0, 0, 0]\n" + SKY % 15 + POINT % ([.6, 2.3, 2.4], [2, 1.7, 1.3])


def cellar(boxes, _):
    """Four vaults in a row, two passages and a stair; one bulb in the second of them."""
    of(boxes, "stone", ((-.3, -.2, -3.3), (20.3, 0, 3.3)), ((-.3, 2.4, -3.3), (20.3, 2.6, 3.3)),
       ((-.3, 0, -3.3), (20.3, 2.4, -3)), ((-.3, 0, 3), (20.3, 2.4, 3.3)), ((-.3, 0, -3), (0, 2.4, 3)),
       ((20, 0, -3), (20.3, 2.4, 3)))
    boxes.material("brick")
    for k, door in enumerate((-2.2, .8, -1.4)):
        pierced(boxes, 0, 5 * k + 4.85, (-3, 0), (3, 2.4), ((door, 0), (door + 1.1, 2)), .3)
    for x in range(20):  # ribs of the vaults
        boxes.add((x + .4, 2.15, -3), (x + .55, 2.4, 3))
    of(boxes, "wood", *(((.3 + .7 * k, 0, 2.2), (.85 + .7 * k, .9, 2.8)) for k in range(5)),
       *(((6.2, .5 * k, -2.9), (9.4, .5 * k + .04, -2.3)) for k in range(4)))
    of(boxes, "stone", *(((10.6 + .28 * k, 0, 1.6), (10.88 + .28 * k, .19 * k + .19, 2.9)) for k in range(11)))
    of(boxes, "dark", ((16, 0, -2.8), (17.2, 1.4, -1.6)), ((18, 0, 1), (19.2, .7, 2.4)))
    return "ambient = [0, 0, 0]\nbackground = [0, 0, 0]\n" + POINT % ([7.4, 2.1, .4], [9, 7.2, 4.6])


def gallery(boxes, _):
    """A hall under a roof of glass, with glass about its stairwell and between its rooms."""
    of(boxes, "stone", ((-12, -.2, -6), (12, 0, 6)))
    of(boxes, "wall", ((-12, 0, -6.2), (12, 6, -6)), ((-12, 0, 6), (12, 6, 6.2)), ((-12.2, 0, -6.2), (-12, 6, 6.2)),
       ((12, 0, -6.2), (12.2, 6, 6.2)))
    for x in range(-12, 13, 3):
        of(boxes, "dark", ((x - .05, 5.9, -6), (x + .05, 6.1, 6)))
        of(boxes, "wall", ((x - .15, 0, -3.2), (x + .15, 3, -2.9)), ((x - .15, 0, 2.9), (x + .15, 3, 3.2)))
    of(boxes, "wall", ((-12, 3, -6), (12, 3.2, -2.9)), ((-12, 3, 2.9), (12, 3.2, 6)))
    for k in range(6):
        of(boxes, "red" if k % 2 else "cloth", ((-10 + 4 * k, 1, -5.99), (-8 + 4 * k, 2.4, -5.9)))
        of(boxes, "stone", ((-9.3 + 4 * k, 0, 4), (-8.7 + 4 * k, 1, 4.6)))
        of(boxes, "leaf", ((-9.2 + 4 * k, 1, 4.1), (-8.8 + 4 * k, 1.7, 4.5)))
    pane = .012
    of(boxes, "pane", ((-12, 6, -6), (12, 6 + pane, 6)), *(((x, 0, -6), (x + pane, 3, -3)) for x in (-6, 0, 6)),
       ((-12, 3.2, -2.9), (12, 4.2, -2.9 + pane)), ((-12, 3.2, 2.9), (12, 4.2, 2.9 + pane)),
       *(((x, 0, -2.95), (x + 2.4, 2.6, -2.95 + pane)) for x in (-11.7, -8.7, 3.3, 6.3)))
    return "ambient = [0, 0, 0]\nbackground = [0, 0, 0]\n" + SKY % 11


def street(boxes, chance):
    """A street between houses with arcades, and a covered alley that leads from it."""
    of(boxes, "stone", ((-40, -.2, -30), (40, 0, 30)))
    for side in (-1, 1):
        for k in range(9):
            x, high = -36 + 8 * k, chance.uniform(7, 13)
            if side == 1 and k == 4:
                of(boxes, "wall", ((x, 3.4, 5), (x + 8, high, 14)), ((x, 0, 5), (x + 2, 3.4, 14)),
                   ((x + 6, 0, 5), (x + 8, 3.4, 14)))
                continue
            near, deep = sorted((side * 7.5, side * 14))
            of(boxes, chance.choice(("wall", "brick", "stone")), ((x, 0, near), (x + 7.8, high, deep)))
            near, deep = sorted((side * 5, side * 7.5))
            of(boxes, "wall", ((x, 3, near), (x + 7.8, 3.4 if k % 3 else high, deep)))
            for post in (0, 3.7, 7.4):
                near, deep = sorted((side * 5, side * 5.4))
                of(boxes, "wall", ((x + post, 0, near), (x + post + .4, 3, deep)))
            for floor in range(1, int(high / 3)):
                near, deep = sorted((side * 7.35, side * 7.5))
                of(boxes, "dark", *(((x + 1 + 2.4 * n, 3 * floor + .8, near), (x + 2 + 2.4 * n, 3 * floor + 2.2, deep))
                                    for n in range(3)))
    for x in range(-33, 34, 11):
        of(boxes, "wood", ((x - .15, 0, -3.2), (x + .15, 2.2, -2.9)))
        of(boxes, "leaf", ((x - 1, 2.2, -4), (x + 1, 4, -2)))
    return "ambient = [0, 0, 0]\nbackground = [0, 0, 0]\n" + SKY % 16


def showroom(boxes, _):
    """A hall with a polished floor, between a window and coloured walls; lacquer, and metal of three roughnesses."""
    of(boxes, "floor", ((-8, -.2, -5), (8, 0, 5)))
    of(boxes, "wall", ((-8, 3.4, -5), (8, 3.6, 5)), ((-8.2, 0, -5), (-8, 3.4, 5)))
    of(boxes, "red", ((8, 0, -5), (8.2, 3.4, 5)))
    pierced(boxes, 2, -5.2, (-8, 0), (8, 3.4), ((-6, .6), (-3, 2.8)))
    pierced(boxes, 2, 5, (-8, 0), (8, 3.4), ((3, .6), (6, 2.8)))
    for x in (-5, 0, 5):
        of(boxes, "stone", ((x - .2, 0, 2.6), (x + .2, 3.4, 3)))
        of(boxes, "cloth", ((x - 1, .9, -4.98), (x + 1, 2.5, -4.9)))
    of(boxes, "lacquer", ((-2, .7, -.6), (.4, .76, .6)), ((5.6, 0, -3.4), (7.4, .9, -1.6)))
    of(boxes, "dark", *(((x, 0, z), (x + .08, .7, z + .08)) for x in (-1.9, .2) for z in (-.5, .4)))
    of(boxes, "leaf", ((-1.2, .76, -.2), (-.8, 1.2, .2)))
    for k, metal in enumerate(("metal2", "metal3", "metal4")):
        of(boxes, metal, ((2.2 + 1.6 * k, 0, -3.9), (3.4 + 1.6 * k, 2, -3.8)))
    return "ambient = [0, 0, 0]\nbackground = [0, 0, 0]\n" + SKY % 15 + POINT % ([-2, 3, 0], [14, 12, 9])


SCENES = {"flat": flat, "cellar": cellar, "gallery": gallery, "street": street, "showroom": showroom}

# Roughness and metal of the materials that have these.
GLOSS = {"floor": (.2, 0, (.32, .26, .2)), "lacquer": (.3, 0, (.04, .05, .06)), "metal2": (.2, 1, (.9, .75, .5)),
         "metal3": (.3, 1, (.8, .8, .82)), "metal4": (.4, 1, (.85, .6, .5))}
GLOSSY = "[[material]]\nname = \"%s\"\nroughness = %g\nmetallic = %g\ndiffuse = [%g, %g, %g]\n"


def write(folder, name):
    """FOLDER/NAME.scn with its model beside it; False: none of these has that name."""
    if name not in SCENES:
        return False
    boxes = Boxes(name + ".mtl")
    scene = SCENES[name](boxes, random.Random(11))
    text = ["newmtl %s\nKd %g %g %g\n" % (material, *colour) for material, colour in MATERIALS.items()]
    text += ["newmtl %s\nKd .5 .5 .5\n" % material for material in GLOSS]
    text.append("newmtl pane\nKd 0 0 0\nKs 0 0 0\nd 0.1\n")
    (folder / (name + ".mtl")).write_text("".join(text))
    (folder / (name + ".obj")).write_text("\n".join(boxes.lines) + "\n")
    pane = "[[material]]\nname = \"pane\"\nopacity = 0.0\nindexOfRefraction = 1.0\ntransmission = [0.88, 0.93, 0.91]\n"
    (folder / (name + ".scn")).write_text("version = 2\nmodel = \"%s.obj\"\ndefaultLight = false\n%s%s" % (
        name, scene, pane if name == "gallery" else "" if name != "showroom" else "".join(
            GLOSSY % (material, *model, *colour) for material, (*model, colour) in GLOSS.items())))
    return True
