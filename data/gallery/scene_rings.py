"""Three rings that glow, and nothing else that gives light."""
import rabbit
from pose import tilted
from rooms import plain, slab, stand
from solids import sphere, torus


def build(model):
    for name in ("red ring", "blue ring", "gold ring"):
        model.material(name, (0.0, 0.0, 0.0), roughness=1.0)
    model.material("floor", (0.3, 0.3, 0.31), roughness=0.22)
    model.material("wall", (0.7, 0.7, 0.7), roughness=1.0)
    model.material("plaster", (0.78, 0.77, 0.75), roughness=1.0)
    model.material("steel", (0.9, 0.9, 0.92), metallic=1.0, roughness=0.12)
    slab(model, (-3.4, -0.2, -2.2), (3.4, 0.0, 4.0), "floor")
    slab(model, (-3.4, 0.0, -2.4), (3.4, 4.0, -2.0), "wall")
    for name, x, z, radius, turn in (("red ring", -1.75, 0.35, 0.8, 62), ("blue ring", 1.75, 0.25, 0.8, -62),
                                     ("gold ring", 0.0, -1.3, 1.15, 4)):
        ring = tilted(torus(radius, 0.06, 128, 16).shaded(60), "x", 90).turned(turn)
        model.add(ring.moved(x, radius + 0.061, z), name)
    stand(model, plain(rabbit.build(0.025), "plaster"), -0.05, -0.35, -50, size=1.0)
    for x, z, r in ((-0.75, 0.75, 0.2), (0.8, 0.6, 0.26)):
        model.add(sphere(r, 96, 48, (x, r, z)).shaded(60), "steel")
