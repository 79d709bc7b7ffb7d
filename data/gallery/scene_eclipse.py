"""A light behind a disc on the wall: all that the room has of it comes from the wall."""
import furniture
import knight
from furniture import placed
from pose import tilted
from rooms import plain, slab, stand
from solids import beveled_box, lathe
import palette


def vase():
    return lathe([(0, 0.0), (0.09, 0.0), (0.1, 0.01), (0.13, 0.09), (0.2, 0.25), (0.21, 0.34), (0.17, 0.46),
                  (0.09, 0.55), (0.07, 0.6), (0.08, 0.66), (0.11, 0.68), (0.1, 0.68), (0.06, 0.63),
                  (0.06, 0.58), (0, 0.5)], 72).shaded(38)


def build(model):
    palette.use(model, "wood")
    model.material("wall", (0.8, 0.77, 0.72), roughness=1.0)
    model.material("floor", (0.5, 0.36, 0.24), roughness=0.3)
    model.material("blue", (0.06, 0.16, 0.42), roughness=1.0)
    model.material("disc", (0.75, 0.73, 0.7), roughness=1.0)
    model.material("plinth", (0.74, 0.72, 0.68), roughness=1.0)
    model.material("marble", (0.78, 0.76, 0.72), roughness=0.25)
    model.material("glaze", (0.05, 0.3, 0.34), roughness=0.12)
    slab(model, (-3.0, -0.2, -1.3), (3.0, 0.0, 4.6), "floor")
    slab(model, (-3.0, 3.1, -1.3), (3.0, 3.3, 4.6), "wall")
    slab(model, (-3.0, 0.0, -1.3), (3.0, 3.1, -1.0), "wall")
    slab(model, (-3.0, 0.0, 4.3), (3.0, 3.1, 4.6), "wall")
    slab(model, (-3.0, 0.0, -1.0), (-2.7, 3.1, 4.3), "blue")
    slab(model, (2.7, 0.0, -1.0), (3.0, 3.1, 4.3), "wall")
    rim = [(0, 0.0), (0.86, 0.0), (0.88, 0.02), (0.86, 0.04), (0, 0.04)]
    model.add(tilted(lathe(rim, 128).shaded(30), "x", 90).moved(0.0, 1.62, -0.36), "disc")
    for x, high in ((-1.5, 0.55), (1.5, 0.8)):
        model.add(beveled_box((x - 0.27, 0.0, -0.2), (x + 0.27, high, 0.34), 0.012).shaded(20), "plinth")
    stand(model, plain(knight.build(0.03), "marble"), -1.5, 0.07, -35, 0.55, 0.72)
    stand(model, [(vase(), "glaze")], 1.5, 0.07, 0, 0.8, 1.0)
    palette.add(model, placed(furniture.wood_chair(), 0.35, 0.75, 60, 0.0, 1.15))
