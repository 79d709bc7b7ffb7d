"""A room with one window: breakfast table, two chairs, a wall of the colour of clay."""
import furniture
import palette
from furniture import placed
from mesh import box_mapping
from parquet import parquet
from rooms import slab, window
from solids import beveled_box, box
from walls import wall

LEFT, RIGHT, NEAR, FAR, HIGH = -2.0, 2.2, 3.4, -1.8, 2.7


def shell(model):
    floor = box((LEFT - 0.3, -0.2, FAR - 0.3), (RIGHT + 0.3, 0.0, NEAR + 0.3))
    model.add(floor.shaded(20, box_mapping(1.8)), "floor")
    slab(model, (LEFT - 0.3, HIGH, FAR - 0.3), (RIGHT + 0.3, HIGH + 0.2, NEAR + 0.3), "white")
    slab(model, (LEFT, 0.0, FAR - 0.3), (RIGHT, HIGH, FAR), "white")
    slab(model, (LEFT, 0.0, NEAR), (RIGHT, HIGH, NEAR + 0.3), "white")
    slab(model, (RIGHT, 0.0, FAR - 0.3), (RIGHT + 0.3, HIGH, NEAR + 0.3), "clay")
    left = wall(lambda u, y, d: (-d, y, u), (FAR - 0.3, NEAR + 0.3), (0.0, HIGH), (-LEFT, -LEFT + 0.3),
                [window(-0.3, 0.75, 0.75, 2.3)])
    model.add(left.shaded(20), "white")
    for low, high in (((-0.33, 0.75), (-0.27, 2.3)), ((-1.05, 1.7), (0.45, 1.76)), ((-1.05, 0.75), (0.45, 0.8)),
                      ((-1.05, 2.25), (0.45, 2.3)), ((-1.05, 0.8), (-1.0, 2.25)), ((0.4, 0.8), (0.45, 2.25))):
        slab(model, (LEFT - 0.17, low[1], low[0]), (LEFT - 0.12, high[1], high[0]), "frame")
    sill = beveled_box((LEFT - 0.1, 0.72, -1.15), (LEFT + 0.1, 0.76, 0.55), 0.008)
    model.add(sill.shaded(20), "frame")
    for z0, z1, x in ((FAR, NEAR, RIGHT - 0.015), (FAR, NEAR, LEFT)):
        slab(model, (x, 0.0, z0), (x + 0.015, 0.09, z1), "frame")
    slab(model, (LEFT, 0.0, FAR), (RIGHT, 0.09, FAR + 0.015), "frame")


def build(model):
    palette.use(model, "chrome", "porcelain", "orange", "apple", "lime", "wood")
    model.material("white", (0.8, 0.78, 0.74), roughness=1.0)
    model.material("frame", (0.82, 0.81, 0.78), roughness=0.6)
    model.material("clay", (0.68, 0.2, 0.09), roughness=1.0)
    model.material("floor", (1, 1, 1), roughness=0.4, texture=model.texture(parquet(9)))
    model.material("table top", (0.72, 0.7, 0.66), roughness=0.35)
    shell(model)
    for parts in (placed(furniture.round_table("table top"), 0.35, -0.35),
                  placed(furniture.wood_chair(), 1.15, -0.75, 205, 0.0, 1.1),
                  placed(furniture.wood_chair(), -0.55, -0.75, -25, 0.0, 1.1),
                  placed(furniture.teapot("porcelain"), 0.25, -0.45, 150, 0.75, 1.35),
                  placed(furniture.bowl_of_fruit("porcelain"), 0.62, -0.3, 10, 0.75, 0.9),
                  placed(furniture.cup("porcelain"), 0.2, -0.08, 60, 0.75)):
        palette.add(model, parts)
