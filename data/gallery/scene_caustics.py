"""A ball of glass and a ring of gold on plaster, under a small bright panel."""
from mesh import Surface
from rooms import slab
from solids import circle, sphere


def band(radius, thick, high, segments=256):
    """A ring that stands on the floor."""
    surface = Surface()
    profile = [(radius, 0.0), (radius, high), (radius + thick, high), (radius + thick, 0.0), (radius, 0.0)]
    rows = []
    for r, y in profile:
        points = circle(r, segments, y)
        rows.append(points + points[:1])
    surface.grid(rows)
    return surface.closed()


def build(model):
    model.material("plaster", (0.72, 0.7, 0.66), roughness=1.0)
    model.material("glass", (1.0, 1.0, 1.0), roughness=0.0, alpha=0.05)
    model.material("blue glass", (1.0, 1.0, 1.0), roughness=0.0, alpha=0.05)
    model.material("gold", (1.0, 0.74, 0.36), metallic=1.0, roughness=0.0)
    model.material("panel", (0.0, 0.0, 0.0), roughness=1.0)
    slab(model, (-8.0, -0.2, -8.0), (8.0, 0.0, 8.0), "plaster")
    model.add(sphere(0.5, 192, 96, (-0.75, 0.501, 0.0)).shaded(60), "glass")
    model.add(sphere(0.22, 128, 64, (0.02, 0.221, 0.85)).shaded(60), "blue glass")
    model.add(band(0.62, 0.03, 0.3).shaded(40).moved(0.8, 0.0, 0.15), "gold")
    slab(model, (-2.7, 2.6, -2.1), (-1.7, 2.62, -1.1), "panel")
