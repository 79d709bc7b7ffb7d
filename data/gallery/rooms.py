"""Rooms for the images by path tracing: walls as slabs, windows, and figures without their colours."""
from furniture import placed
from solids import box
from walls import Opening


def slab(model, low, high, material, uv=None):
    model.add(box(low, high).shaded(20, uv), material)


def window(centre, half, sill, top):
    """A hole with upright sides for walls.wall."""
    return Opening([(centre - half, sill, top), (centre + half, sill, top)], (centre, sill))


def plain(parts, material, *, without=()):
    """The meshes of (mesh, material) parts, all of one material and without colours at their vertices."""
    out = []
    for mesh, old in parts:
        if old not in without:
            mesh.colours = None
            out.append((mesh, material))
    return out


def stand(model, parts, x, z, degrees=0.0, y=0.0, size=1.0):
    for mesh, material in placed(parts, x, z, degrees, y, size):
        model.add(mesh, material)
