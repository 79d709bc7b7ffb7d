"""Scenes of well-known models, with Lambert surfaces: what both programs mean alike."""
import os

import geometry
from description import Light, Scene
from geometry import beside
from scenes import evening_sky, quad

SQUARE = 75.18  # degrees from left to right of a 4:3 view with 60 from top to bottom


def cornell(folder, _work):
    path = os.path.join(folder, "cornell", "CornellBox-Original.obj")
    scene = Scene((0.0, 1.0, 3.6), (0.0, 1.0, 0.0), 48.0, bounces=32)
    corners, _, numbers, names = geometry.read_obj(path)
    diffuse, emission = (geometry.mtl_values(path[:-3] + "mtl", key) for key in ("Kd", "Ke"))
    for name in names:
        colours = (tuple(map(float, values.get(name, [0, 0, 0])[:3])) for values in (diffuse, emission))
        scene.material(next(colours), emission=next(colours))
    scene.soup.add(corners, numbers)
    return scene


def sibenik(folder, _work):
    """Grey, with one sphere that shines."""
    scene = Scene((-16.0, -10.0, 0.0), (10.0, -9.0, 0.0), SQUARE, bounces=12)
    grey = scene.material((0.6, 0.6, 0.6))
    scene.soup.add(geometry.read_obj(os.path.join(folder, "sibenik", "sibenik.obj"))[0], grey)
    scene.lights = [Light("sphere", (100.0, 100.0, 100.0), (-2.0, -4.0, 0.0), radius=0.3)]
    return scene


def sponza(folder, _work):
    """With its textures, in metres, under a sky, and a light in the court. Materials with holes are of one colour."""
    folder = os.path.join(folder, "sponza_crytek")
    scene = Scene((-11.0, 3.5, -0.4), (8.0, 3.5, 0.0), SQUARE, bounces=12, sky=evening_sky())
    corners, coordinates, numbers, names = geometry.read_obj(os.path.join(folder, "sponza.obj"))
    mean = geometry.mtl_values(os.path.join(folder, "sponza.mtl"), "Kd")
    maps = geometry.mtl_values(os.path.join(folder, "sponza_textured.mtl"), "map_Kd")
    for name in names:
        path = os.path.join(folder, " ".join(maps.get(name, [])))
        if name in maps and geometry.png_channels(path) == 3:
            scene.material((1.0, 1.0, 1.0), texture=path)
        else:
            scene.material(tuple(map(float, mean.get(name, [0.5, 0.5, 0.5]))))
    scene.soup.add(corners / 100, numbers, coordinates)
    scene.lights = [Light("point", (60.0, 55.0, 45.0), (0.0, 10.0, 0.0))]
    return scene


def lamborghini(folder, _work):
    """By its base colours alone, on a floor under a sky."""
    scene = Scene((2.4, 2.2, 5.6), (0.2, 0.6, 0.0), 60.0, bounces=12, sky=evening_sky())
    corners, _, numbers, materials = geometry.read_glb(os.path.join(folder, "lamborghini", "lamborghini.glb"))
    for material in materials:
        base = material.get("pbrMetallicRoughness", {}).get("baseColorFactor", [1, 1, 1, 1])
        scene.material(tuple(0.9 * v for v in base[:3]))
    scene.soup.add(corners, numbers)
    low = float(corners[..., 1].min())
    quad(scene, scene.material((0.4, 0.4, 0.4)), (-20, low, 20), (20, low, 20), (20, low, -20), (-20, low, -20))
    return scene


def nave(_folder, work):
    """data/nave with its nine lights and its panes, which only tint here; its flames do not shine."""
    path = beside("..", "..", "data", "nave", "generated", "nave.glb")
    path = os.environ.get("RT_NAVE", path)
    if not os.path.isfile(path):
        return None
    scene = Scene((1.0, 1.7, 13.4), (-0.35, 4.9, -10.0), 74.0, bounces=12)
    corners, coordinates, numbers, materials = geometry.read_glb(path)
    panes = {"blue": (0.07, 0.2, 0.85), "ruby": (0.9, 0.06, 0.06), "amber": (1.0, 0.68, 0.14),
             "green": (0.16, 0.7, 0.24), "violet": (0.5, 0.12, 0.72), "pale": (0.9, 0.92, 0.84)}
    for material in materials:
        base = tuple(material["pbrMetallicRoughness"]["baseColorFactor"][:3])
        texture = ""
        if "image" in material:
            texture = os.path.join(work, "nave-%s.png" % material["name"])
            with open(texture, "wb") as file:
                file.write(material["image"])
        pane = panes.get(material["name"].replace("glass_", ""), ())
        scene.material((0.0, 0.0, 0.0) if pane else base, texture=texture, pane=pane)
    scene.soup.add(corners, numbers, coordinates)
    scene.lights = [Light("directional", (80, 64, 44), direction=(-0.5, -0.84, -0.1)),
                    Light("directional", (1.3, 1.8, 2.6), direction=(0.66, -0.72, 0.22))]
    for place, intensity in (((-2.3, 1.1, 3.0), (9, 7, 4.8)), ((-2.3, 1.1, -6.0), (9, 7, 4.8)),
                             ((0, 4.95, 12.5), (50, 29, 12)), ((0, 4.95, 2.5), (60, 35, 15)),
                             ((0, 4.95, -7.5), (60, 35, 15)), ((-1.9, 2.75, -14.1), (30, 17, 7)),
                             ((1.9, 2.75, -14.1), (30, 17, 7))):
        scene.lights.append(Light("point", intensity, place))
    return scene


MODELS = {"cornell": cornell, "sibenik": sibenik, "sponza": sponza, "lamborghini": lamborghini, "nave": nave}


def find(name, folder, work):
    try:
        return MODELS[name](folder, work)
    except FileNotFoundError:
        return None
