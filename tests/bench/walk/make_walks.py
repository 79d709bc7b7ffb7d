#!/usr/bin/env python3
"""Makes the walks of bench_walk: make_walks.py FOLDER [NAME]...

Each is 300 cameras at 30 a second in FOLDER/NAME.lst, along points that are passed at even speed, with a head
that looks about: what the hand of a user does to a picture. Points are of data/nave, of data/mirrors, of
data/organic, of a flat, a cellar, a gallery of glass, a street and a showroom by day, of a street and a hall at
night, whose scenes are made beside their walks, and of the models Sibenik, Crytek Sponza and Lamborghini. Where
RT_TEST_SCENES names the folder of these, each has a scene beside its walk: FOLDER/NAME.scn.
"""
import math
import os
import pathlib
import sys

import walk_scenes

FRAMES, RATE = 300, 30
NIGHTS = (10, 100, 1000)

# Points (x, y, z) that are passed, with what is looked at (yaw, pitch; degrees; yaw 0 looks along -z and grows
# to the right) and up; `sway` degrees to each side in `period` seconds.
WALKS = {
    "nave": dict(fov=74, sway=25, period=5, points=[
        (1.0, 1.7, 13.4, 0, 6), (0.6, 1.7, 4, -5, 8), (-0.5, 1.7, -3, 5, 14), (-0.2, 1.7, -9, 0, 20)]),
    "mirrors": dict(fov=76, sway=20, period=5, points=[
        (-3.5, 1.75, 3.0, 50, -6), (-1.5, 1.75, 2.4, 30, -8), (0.6, 1.75, 2.2, 0, -8), (2.4, 1.75, 2.6, -40, -6)]),
    "sibenik": dict(fov=75, sway=25, period=5, points=[
        (-17, -12.5, 0, 90, 4), (-8, -12.5, 0.8, 85, 8), (0, -12.5, -0.6, 95, 14), (7, -12.0, 0, 90, 10)]),
    "sponza": dict(fov=75, sway=25, period=5, points=[
        (-1050, 50, -40, 90, 5), (-400, 50, -20, 95, 10), (300, 50, -60, 85, 8), (850, 50, -40, 90, 4)]),
    "lamborghini": dict(fov=60, sway=6, period=4, around=True, points=[
        (4.6, 1.5, 4.6, 0, 0), (0.5, 1.3, 5.8, 0, 0), (-4.2, 1.4, 4.2, 0, 0), (-6.0, 1.7, 0.0, 0, 0)]),
    "organic": dict(fov=66, sway=12, period=5, points=[
        (-0.2, 1.4, 13.8, -5, 2), (1.4, 1.3, 11.6, -15, 2), (3.2, 1.2, 9.4, -32, 2), (3.6, 1.3, 7.2, -50, 2)]),
    # Once around an object, as by a drag.
    "orbit": dict(fov=60, sway=0, period=1, around=True, points=[
        (5.8 * math.sin(math.tau * i / 16), 1.6, 5.8 * math.cos(math.tau * i / 16), 0, 0) for i in range(17)]),
    # Scenes that are lit by way of surfaces, by walk_scenes.py.
    "flat": dict(fov=75, sway=25, period=5, points=[
        (-4.6, 1.6, -.6, 60, -6), (-2.7, 1.6, .9, 190, -4), (-.6, 1.6, 1.8, 90, -4), (3.4, 1.6, 2.2, 60, -6)]),
    "cellar": dict(fov=75, sway=20, period=5, points=[
        (1.2, 1.6, 1, 80, -4), (5, 1.6, -1.6, 90, -4), (10, 1.6, 1.3, 95, -4), (14.4, 1.6, -.8, 90, -4)]),
    "gallery": dict(fov=75, sway=25, period=5, points=[
        (-11, 1.7, 1, 90, 4), (-4, 1.7, -1.5, 60, 6), (4, 1.7, 1.5, 110, 2), (10, 1.7, -1, 80, 4)]),
    "street": dict(fov=75, sway=25, period=5, points=[
        (-28, 1.7, 0, 90, 3), (-10, 1.7, -6.2, 85, 2), (-2, 1.7, 2, 150, 2), (0, 1.7, 12, 180, 2)]),
    "showroom": dict(fov=75, sway=25, period=5, points=[
        (-7, 1.6, 1.5, 70, -14), (-3, 1.6, 2, 80, -12), (1, 1.6, 1.2, 60, -10), (4.4, 1.6, -.4, 40, -12)]),
    # At night, by scripts/lights/night_scenes.py: 100 or 1,000 lights.
    **{f"street-{count}": dict(fov=70, sway=25, period=5, points=[
        (-27, 1.8, 3, 80, -3), (-12, 1.8, 1, 95, 0), (4, 1.8, -2, 85, 2), (20, 1.8, 0, 90, 0)]) for count in NIGHTS},
    **{f"hall-{count}": dict(fov=75, sway=25, period=5, points=[
        (-18, 1.7, 2.6, 90, 0), (-6, 1.7, 2.4, 80, 2), (3, 1.7, 2.6, 95, 0), (14, 1.7, 2.4, 90, -2)]) for count in NIGHTS},
}

LIGHT = "\n[[light]]\nkind = \"{}\"\n{}\nintensity = {}\n"


def lamp(position, intensity):
    return LIGHT.format("point", f"position = {position}", [intensity] * 3)


def sun(direction, intensity):
    return LIGHT.format("directional", f"direction = {direction}", intensity)


SKY = pathlib.Path(__file__).resolve().parents[3] / "data/environments/generated/day.hdr"

# The scenes of the walks: the model in RT_TEST_SCENES, and all else of the .scn.
SCENES = {
    "sibenik": ("sibenik/sibenik.obj",
                "ambient = [0.25, 0.25, 0.27]\n" + lamp([-15, -8, 0], 30) + lamp([0, -6, 0], 60) +
                lamp([8, -8, 0], 30) + "\n[live]\nambientOcclusion.on = true\nambientOcclusion.distance = 4\n"),
    "sponza": ("sponza.model/sponza.obj",
               "ambient = [0.2, 0.22, 0.26]\n" + sun([-0.2, -1, 0.15], [6, 5.4, 4.5]) + lamp([-900, 200, -30], 150000) +
               lamp([700, 200, -30], 150000)),
    "lamborghini": ("lamborghini/lamborghini.glb",
                    f'ambient = [0.3, 0.33, 0.38]\n\n[[environment]]\nequirectangular = "{SKY}"\n' +
                    sun([-0.5, -0.8, -0.35], [4, 3.8, 3.3])),
}


def spline(a, b, c, d, t):
    """Catmull and Rom 1974, between b and c."""
    return tuple(0.5 * (2 * q + (r - p) * t + (2 * p - 5 * q + 4 * r - s) * t * t + (3 * q - p - 3 * r + s) * t ** 3)
                 for p, q, r, s in zip(a, b, c, d))


def camera(walk, i):
    points = walk["points"]
    points = [points[0]] + points + [points[-1]]
    at = i / (FRAMES - 1) * (len(points) - 3)
    first = min(int(at), len(points) - 4)
    x, y, z, yaw, pitch = spline(*points[first:first + 4], at - first)
    swing = walk["sway"] * math.sin(2 * math.pi * i / RATE / walk["period"])
    if walk.get("around"):
        yaw, pitch = math.degrees(math.atan2(-x, z)), -math.degrees(math.atan2(y - 0.6, math.hypot(x, z)))
    yaw, pitch = math.radians(yaw + swing), math.radians(pitch)
    forward = (math.sin(yaw) * math.cos(pitch), math.sin(pitch), -math.cos(yaw) * math.cos(pitch))
    vector = lambda v: "[" + ", ".join(f"{c:.7g}" for c in v) + "]"
    return f"version = 1\neye = {vector((x, y, z))}\nforward = {vector(forward)}\nfov = {float(walk['fov'])}\n"


def dress_sponza(model, folder):
    """The model with its textures: it has them in a second list of materials."""
    folder.mkdir(exist_ok=True)
    for name, target in {"sponza.obj": "sponza.obj", "sponza.mtl": "sponza_textured.mtl", "textures": "textures"}.items():
        (folder / name).unlink(missing_ok=True)
        (folder / name).symlink_to(model / target)


def write_night(folder, name):
    """The scene of that name, such as street-100; False: it is none of these."""
    scene, dash, count = name.partition("-")
    if not dash:
        return False
    sys.path.insert(1, str(pathlib.Path(__file__).resolve().parents[3] / "scripts/lights"))
    import night_scenes
    path = pathlib.Path(night_scenes.write(folder, scene, "points", int(count)) + ".scn")
    path.rename(folder / f"{name}.scn")
    return True


def main():
    if len(sys.argv) < 2 or sys.argv[1].startswith("-"):
        print(__doc__)
        sys.exit(0 if sys.argv[1:2] in (["-h"], ["--help"]) else 2)
    folder = pathlib.Path(sys.argv[1])
    for name in sys.argv[2:] or WALKS:
        cameras = folder / f"{name}.cams"
        cameras.mkdir(parents=True, exist_ok=True)
        lines = []
        for i in range(FRAMES):
            (cameras / f"{i:05}.cam").write_text(camera(WALKS[name], i))
            lines.append(f"{name}.cams/{i:05}.cam\n")
        (folder / f"{name}.lst").write_text("".join(lines))
        if walk_scenes.write(folder, name) or write_night(folder, name):
            continue
        models = os.environ.get("RT_TEST_SCENES")
        if models and name in SCENES:
            if not pathlib.Path(models).is_dir():
                sys.exit(f"make_walks.py: RT_TEST_SCENES names {models}, which is no folder")
            model, rest = SCENES[name]
            if name == "sponza":
                dress_sponza(pathlib.Path(models) / "sponza_crytek", folder / "sponza.model")
            else:
                model = f"{models}/{model}"
            (folder / f"{name}.scn").write_text(f'version = 1\nmodel = "{model}"\n{rest}')


if __name__ == "__main__":
    main()
