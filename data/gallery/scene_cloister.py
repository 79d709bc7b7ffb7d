"""A vaulted walk beside a court in the sun: what lights the vault is the floor."""
import nave_parts as parts
from make_nave import AISLE_HALF, rib_set
from mesh import box_mapping
from nave_textures import ashlar
from rooms import slab
from scene_terrace import tiles, topiary
from solids import beveled_box, moved, vault_shell
from walls import lancet, wall

BAYS = (5.0, 0.0, -5.0, -10.0)
SPRING, HALF = 2.5, AISLE_HALF
NEAR, FAR = BAYS[0] + 2.5, BAYS[-1] - 2.5
STONE = box_mapping(2.0)


def vaults(model):
    for z in BAYS:
        bay = moved(vault_shell(HALF, 2.5, SPRING, 12, 0.2), (0.0, 0.0, z)).closed()
        model.add(bay.shaded(25), "plaster")
        ribs, across = rib_set(HALF, SPRING, 0.12, 0.22, 0.2, 12)
        for rib in ribs + [across]:
            model.add(rib.shaded(38).moved(0.0, 0.0, z), "stone trim")


def responds(model):
    shaft = parts.pier(0.12, SPRING - 0.15, 0.17, 0.085, 0.06, samples=4).shaded(32)
    foot = parts.octagon_block(0.36, 0.0, 0.16, 0.02).shaded(20)
    head = parts.octagon_block(0.4, SPRING - 0.18, SPRING + 0.02, 0.03).shaded(20)
    for z in [NEAR] + [z - 2.5 for z in BAYS]:
        for mesh in (shaft, foot, head):
            for side in (-1, 1):
                model.add(mesh.moved(side * 2.22, 0.0, z), "stone trim")


def walls(model):
    arches = [lancet(z, 1.65, 0.55, 2.45, steps=12) for z in BAYS[::-1]]
    model.add(wall(lambda u, y, d: (d, y, u), (FAR - 0.4, NEAR + 0.4), (-0.2, 5.6), (2.3, 2.9),
                   arches).shaded(25, STONE), "stone")
    for z in BAYS:
        for bar in parts.tracery(1.65, 0.5, 2.45, 0.075):
            model.add(bar.shaded(50).turned(90).moved(2.6, 0.0, z), "stone trim")
    slab(model, (-2.9, -0.2, FAR - 0.4), (-2.3, 5.6, NEAR + 0.4), "plaster")
    ends = wall(lambda u, y, d: (u, y, FAR + 0.1 - d), (-2.4, 2.4), (0.0, 5.6), (0.0, 0.4),
                [lancet(0.0, 0.8, 0.0, 1.9, steps=12)])
    model.add(ends.shaded(25), "plaster")
    slab(model, (-2.4, -0.2, NEAR), (2.4, 5.6, NEAR + 0.3), "plaster")


def court(model):
    slab(model, (2.8, -0.3, -30.0), (14.0, -0.05, 20.0), "grass")
    slab(model, (-8.0, -0.3, -30.0), (2.8, -0.21, FAR - 0.4), "grass")
    slab(model, (14.0, -0.3, -30.0), (14.6, 3.6, 20.0), "plaster")
    topiary(model, 4.9, 0.6)
    topiary(model, 4.9, -4.4)
    topiary(model, 4.9, -9.4)


def build(model):
    model.material("plaster", (0.78, 0.74, 0.66), roughness=1.0)
    model.material("stone", (1, 1, 1), roughness=1.0, texture=model.texture(ashlar(4, 0.8)))
    model.material("stone trim", (0.66, 0.58, 0.46), roughness=1.0)
    model.material("tiles", (1.0, 0.66, 0.46), roughness=0.45, texture=model.texture(tiles()))
    model.material("grass", (0.09, 0.17, 0.035), roughness=1.0)
    model.material("terracotta", (0.42, 0.15, 0.075), roughness=0.9)
    model.material("bark", (0.12, 0.085, 0.06), roughness=1.0)
    model.material("leaf", (1, 1, 1), roughness=1.0)
    floor = beveled_box((-2.5, -0.3, FAR - 0.4), (2.5, 0.0, NEAR + 0.4), 0.01)
    model.add(floor.shaded(20, box_mapping(2.4)), "tiles")
    vaults(model)
    responds(model)
    walls(model)
    court(model)
