"""A white room with a red and a green wall, a light in its ceiling, a block and a rabbit of plaster."""
import rabbit
from rooms import plain, slab, stand
from solids import beveled_box

HALF, HIGH, THICK = 1.0, 2.0, 0.1


def build(model):
    model.material("white", (0.75, 0.75, 0.73), roughness=1.0)
    model.material("red", (0.62, 0.045, 0.035), roughness=1.0)
    model.material("green", (0.1, 0.42, 0.08), roughness=1.0)
    model.material("panel", (0.0, 0.0, 0.0), roughness=1.0)
    out = HALF + THICK
    slab(model, (-out, -THICK, -out), (out, 0.0, HALF), "white")
    slab(model, (-out, HIGH, -out), (out, HIGH + THICK, HALF), "white")
    slab(model, (-out, 0.0, -out), (out, HIGH, -HALF), "white")
    slab(model, (-out, 0.0, -HALF), (-HALF, HIGH, HALF), "red")
    slab(model, (HALF, 0.0, -HALF), (out, HIGH, HALF), "green")
    slab(model, (-0.3, HIGH - 0.012, -0.3), (0.3, HIGH, 0.3), "panel")
    block = beveled_box((-0.28, 0.0, -0.28), (0.28, 1.15, 0.28), 0.012).shaded(20)
    model.add(block.turned(20).moved(-0.36, 0.0, -0.36), "white")
    stand(model, plain(rabbit.build(0.03), "white"), 0.38, 0.3, -50, size=0.72)
