"""The images that denoising is measured on: names, and what the Renderer is told for each.

The first seven are the scenes of the laboratory that docs/lab/denoising.md tells of, whose views are not all known; at
the others nobody looked while denoising was made.
"""
import os
import subprocess
import sys

from paths import PROJECT

import scenes
import write_scene

STRANGERS = os.path.join(PROJECT, "tests", "strangers", "make_strangers.py")
ASSIMP = "/usr/share/assimp/models"  # of the Debian package assimp-testmodels
FOLIAGE = "version = 1\neye = [9.0, 1.6, 9.0]\nforward = [-0.7, 0.12, -0.7]\nfov = 60.0\n"
CAUSTICS = ("--lights=none", "--setting=path.emitters=on", "--setting=path.caustics=true")


class Views:
    def __init__(self, models, folder):
        self.models, self.folder = models, folder

    def find(self, name):
        """The Renderer's arguments; None where the model is not there."""
        arguments = VIEWS[name](self)
        return arguments if arguments and os.path.isfile(arguments[0]) else None

    def known(self, *path):
        return os.path.join(self.models, *path)

    def project(self, *path, options=()):
        """One of the scenes whose model scripts/make_data.sh makes."""
        scene = os.path.join(PROJECT, *path)
        model = os.path.join(os.path.dirname(scene), "generated", os.path.basename(scene)[:-3] + "glb")
        return [scene, *options] if os.path.isfile(model) else None

    def stranger(self, name):
        """A model that tests/strangers makes."""
        folder = os.path.join(self.folder, "strangers")
        if not os.path.isfile(os.path.join(folder, "strangers.txt")):
            subprocess.run([sys.executable, STRANGERS, folder], check=True, stdout=subprocess.DEVNULL)
        return os.path.join(folder, name)

    def foliage(self):
        camera = os.path.join(self.folder, "foliage.cam")
        with open(camera, "w", encoding="ascii") as file:
            file.write(FOLIAGE)
        return [self.stranger("forest.glb"), "--look=sky", "--camera=" + camera]

    def shared(self, name):
        """A scene that Cycles renders as well."""
        path, scene = os.path.join(self.folder, name), scenes.find(name, self.models, self.folder)
        if scene is None:
            return None
        write_scene.write(scene, path)
        return [path + ".scn"]


VIEWS = {
    "sibenik": lambda v: v.shared("sibenik"),
    "sponza": lambda v: [v.known("sponza_crytek", "sponza.obj"), "--look=sky"],
    "nave": lambda v: v.project("data", "nave", "nave.scn"),
    "cornell-balls": lambda v: [v.known("cornell", "CornellBox-Sphere.obj")],
    "lamborghini": lambda v: [v.known("lamborghini", "lamborghini.glb"), "--look=sky"],
    "room": lambda v: [v.stranger("room.glb")],
    "mirrors": lambda v: v.project("data", "mirrors", "mirrors.scn"),
    "house": lambda v: [os.path.join(ASSIMP, "IFC", "AC14-FZK-Haus.ifc"), "--look=sky"],
    "engine": lambda v: [os.path.join(ASSIMP, "glTF2", "2CylinderEngine-glTF-Binary", "2CylinderEngine.glb"), "--look=studio"],
    "foliage": lambda v: v.foliage(),
    "glass": lambda v: v.shared("glass") + ["--setting=path.caustics=false"],
    "caustics": lambda v: v.project("data", "gallery", "caustics.scn", options=CAUSTICS),
    "sibenik-sky": lambda v: [v.known("sibenik", "sibenik.obj"), "--look=sky"],
}
