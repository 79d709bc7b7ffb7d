"""A room with the gallery's furniture, matte, under a panel in its ceiling that emits."""
import sys

from description import Scene
from geometry import beside
from scenes import WHITE, block, room

sys.path[1:1] = [beside("..", "..", "data", folder) for folder in ("gallery", "organic")]
import furniture  # noqa: E402

COLOURS = {"wood": (0.4, 0.22, 0.1), "chrome": (0.5, 0.5, 0.5), "leather": (0.15, 0.08, 0.05), "porcelain": (0.8, 0.78, 0.72),
           "orange": (0.8, 0.3, 0.05), "apple": (0.5, 0.05, 0.04), "lime": (0.3, 0.5, 0.08), "top": (0.6, 0.45, 0.3)}


def furnished():
    scene = Scene((2.3, 1.6, 2.6), (-0.3, 0.7, -0.6), 70.0, bounces=16)
    _, blue = room(scene, (5.0, 4.6, 4.0))
    numbers = {name: scene.material(colour) for name, colour in COLOURS.items()}
    for parts in (furniture.placed(furniture.round_table("top"), 0.35, -0.2),
                  furniture.placed(furniture.wood_chair(), 1.15, -0.75, 205),
                  furniture.placed(furniture.wood_chair(), -0.55, 0.1, 10),
                  furniture.placed(furniture.tube_chair(), 0.6, 0.7, 100),
                  furniture.placed(furniture.teapot("porcelain"), 0.25, -0.3, 150, 0.75, 1.35),
                  furniture.placed(furniture.bowl_of_fruit("porcelain"), 0.62, -0.15, 10, 0.75, 0.9)):
        for mesh, material in parts:
            scene.soup.surface(numbers[material], mesh)
    block(scene, blue, (-2.4, 0.0, -1.2), (0.45, 0.22, 1.1), 0.0)    # a sofa: seat, back
    block(scene, blue, (-2.75, 0.44, -1.2), (0.12, 0.22, 1.1), 0.0)
    shelf = scene.material(WHITE)
    for level in range(5):
        block(scene, shelf, (1.6, 0.45 * level, -2.75), (0.8, 0.015, 0.2), 0.0)
    for side in (0.8, 2.4):
        block(scene, shelf, (side, 0.0, -2.75), (0.015, 0.92, 0.2), 0.0)
    return scene
