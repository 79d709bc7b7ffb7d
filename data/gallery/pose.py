"""Turning and placing of finished meshes."""
import math

from implicit import polygonise
from mesh import Mesh, snapped


def _matrix(axis, degrees):
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    if axis == "x":
        return ((1, 0, 0), (0, c, -s), (0, s, c))
    if axis == "y":
        return ((c, 0, s), (0, 1, 0), (-s, 0, c))
    return ((c, -s, 0), (s, c, 0), (0, 0, 1))


def tilted(mesh, axis, degrees):
    """Turned about the axis "x", "y" or "z" through the origin."""
    rows = _matrix(axis, degrees)

    def turn(p):
        return tuple(r[0] * p[0] + r[1] * p[1] + r[2] * p[2] for r in rows)

    out = Mesh()
    out.positions = [snapped(turn(p)) for p in mesh.positions]
    out.normals = [turn(n) for n in mesh.normals]
    out.uvs, out.colours, out.faces = mesh.uvs, mesh.colours, mesh.faces
    return out


def mixed(a, b, t):
    """Between two colours; t is kept in 0..1."""
    t = min(1.0, max(0.0, t))
    return tuple(x + (y - x) * t for x, y in zip(a, b))


def implicit_mesh(body, inside, cell):
    """The polygonised body as a mesh; `inside` is a point of it."""
    surface, normals = polygonise(body, inside, cell)
    mesh = Mesh()
    mesh.positions, mesh.normals, mesh.faces = surface.closed().positions, normals, surface.faces
    return mesh
