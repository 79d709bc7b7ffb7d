#!/usr/bin/env python3
"""Collects the models of tests/known_models/models.txt that do not lie in the repository.

usage: known_models.py FOLDER [--share DIR]... [--data DIR]

Writes them into FOLDER, under the names of the list: copies of what packages install below a share folder
(/usr/share, and each --share), and what Blender, OpenSCAD, FreeCAD, MeshLab and Assimp export, with the options
that they have by default. What is not installed is left out, and said. Their licences keep them out of the repository.
Then: RT_KNOWN_MODELS=FOLDER build/release/bin/test_known_models
"""
import argparse
import pathlib
import shutil
import subprocess
import sys
import tempfile
import zipfile

REPOSITORY = pathlib.Path(__file__).resolve().parent.parent

# Name of the list -> file below a share folder.
COPIES = {
    "duck.dae": "assimp/models/Collada/duck.dae",
    "kwxport.dae": "assimp/models/Collada/kwxport_test_vcolors.dae",
    "ultimaker3.obj": "cura/resources/meshes/ultimaker3_platform.obj",
    "sidewinder.stl": "cura/resources/meshes/artillery_swx1.stl",
    "thinker.obj": "cura/resources/meshes/eryone_thinker_platform.obj",
    "tinyboy.obj": "cura/resources/meshes/tinyboy_ra20.obj",
    "nebula.stl": "cura/resources/meshes/trimaker_nebula_platform.stl",
    "deltacomb.stl": "cura/resources/meshes/deltacomb_dc20.stl",
    "screw.stl": "PrusaSlicer/shapes/M3x10_screw.stl",
    "ender3.stl": "PrusaSlicer/profiles/Creality/ender3_bed.stl",
    "sailboat.ac": "games/flightgear/Models/Maritime/Civilian/SailBoatUnderPower11m.ac",
    "humvee.ac": "games/flightgear/Models/Military/humvee-pickup-odrab-low-poly.ac",
    "tower.ac": "games/flightgear/Models/Power/coolingtower.ac",
    "outhouse.ac": "games/crrcsim/objects/outhouse.ac",
}

# Name of the list -> catalogue of Sweet Home 3D, and the model in it.
FURNITURE = {
    "armchair.obj": ("BlendSwap-CC-0", "blendswap-cc-0/armchair/armchair.obj"),
    "mixer.obj": ("BlendSwap-CC-0", "blendswap-cc-0/kitchenaid/kitchenaid.obj"),
    "bottle.obj": ("BlendSwap-CC-BY", "blendswap-cc-by/beer_bottle/beer_bottle.obj"),
    "hut.obj": ("BlendSwap-CC-0", "blendswap-cc-0/childHut/childHut.obj"),
    "stair.obj": ("BlendSwap-CC-0", "blendswap-cc-0/spiralStaircase/spiralStaircase.obj"),
    "woman.obj": ("Reallusion", "reallusion/female03/female03.obj"),
    "car.obj": ("Scopia", "scopia/renault-scenic/renault-scenic.obj"),
    "light.obj": ("Scopia", "scopia/little_lamp2/little_lamp2.obj"),
    "table.obj": ("Scopia", "scopia/table3/table3.obj"),
    "horse.obj": ("BlendSwap-CC-0", "blendswap-cc-0/horse2/horse2.obj"),
    "tray.obj": ("Scopia", "scopia/bandeja/bandeja.obj"),
}

# Models made by FreeCAD, in its millimetres: a house without a roof, and a bracket.
FREECAD = """
import FreeCAD, Part, Mesh, MeshPart
def export(shape, path):
    mesh = MeshPart.meshFromShape(Shape=shape, LinearDeflection=0.5, AngularDeflection=0.5)
    document = FreeCAD.newDocument()
    feature = document.addObject("Mesh::Feature", "Mesh")
    feature.Mesh = mesh
    Mesh.export([feature], path)
V = FreeCAD.Vector
house = Part.makeBox(8000, 6000, 2800).cut(Part.makeBox(7400, 5400, 2800, V(300, 300, 200)))
house = house.fuse(Part.makeBox(150, 5400, 2800, V(4000, 300, 0)))
for hole in (Part.makeBox(900, 300, 2000, V(1000, 0, 200)), Part.makeBox(1500, 300, 1200, V(5200, 0, 1000)),
             Part.makeBox(150, 900, 2000, V(4000, 3500, 200)), Part.makeBox(300, 1200, 1200, V(0, 2000, 1000))):
    house = house.cut(hole)
export(house, "FOLDER/house.obj")
bracket = Part.makeBox(60, 40, 5).fuse(Part.makeBox(5, 40, 50))
bracket = bracket.cut(Part.makeCylinder(4, 5, V(25, 20, 0))).cut(Part.makeCylinder(4, 5, V(45, 20, 0)))
bracket = bracket.cut(Part.makeCylinder(6, 5, V(0, 20, 30), V(1, 0, 0)))
export(bracket, "FOLDER/bracket.stl")
"""

# Blender imports what is known and exports it by default. Furniture is in centimetres there: metres here.
BLENDER = """
import bpy
import numpy
numpy.bool = bool # a name of earlier versions, which Blender 3.4 takes
def load(path, scale=1.0):
    bpy.ops.wm.read_factory_settings(use_empty=True)
    if path.endswith(".glb"):
        bpy.ops.import_scene.gltf(filepath=path)
    else:
        bpy.ops.wm.obj_import(filepath=path, global_scale=scale)
load("FOLDER/table.obj")
bpy.ops.export_scene.gltf(filepath="FOLDER/blender-table.glb")
load("FOLDER/armchair.obj", 0.01 * 1.05 / 1.15015)
bpy.ops.export_mesh.stl(filepath="FOLDER/blender-armchair.stl")
bpy.ops.export_scene.fbx(filepath="FOLDER/blender-armchair.fbx")
load("FOLDER/hut.obj", 0.01)
bpy.ops.export_mesh.ply(filepath="FOLDER/blender-hut.ply")
load("NAVE")
bpy.ops.wm.obj_export(filepath="FOLDER/blender-nave.obj")
bpy.ops.export_mesh.stl(filepath="FOLDER/blender-nave.stl")
bpy.ops.export_mesh.ply(filepath="FOLDER/blender-nave.ply")
"""


def find(shares, path):
    return next((share / path for share in shares if (share / path).is_file()), None)


def say(missing):
    print(f"known_models.py: left out: {missing}", file=sys.stderr)


def run(*command):
    try:
        done = subprocess.run([str(word) for word in command], stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                              text=True, timeout=600, check=False)
    except FileNotFoundError:
        return say(f"what {command[0]} makes, which is not installed")
    if done.returncode != 0:
        say(f"{' '.join(map(str, command))}\n{done.stdout[-2000:]}")


def copy_installed(folder, shares):
    for name, path in COPIES.items():
        source = find(shares, path)
        if source is None:
            say(f"{name}: no {path}")
        else:
            shutil.copy(source, folder / name)


def unpack_furniture(folder, shares):
    for name, (catalogue, path) in FURNITURE.items():
        source = find(shares, f"sweethome3d/furniture/{catalogue}.sh3f")
        if source is None:
            say(f"{name}: no {catalogue}.sh3f")
            continue
        with zipfile.ZipFile(source) as archive:
            (folder / name).write_bytes(archive.read(path))


def make_openscad(folder, shares):
    for name, example in (("temple.stl", "Old/example005.scad"), ("assembly.stl", "Old/example020.scad"),
                          ("letters.amf", "Basics/LetterBlock.scad")):
        source = find(shares, f"openscad/examples/{example}")
        run("openscad", "-o", folder / name, source) if source else say(f"{name}: no {example}")


def make_others(folder, nave):
    with tempfile.TemporaryDirectory() as scratch:
        script = pathlib.Path(scratch) / "make.py"
        # Blender takes the libraries of whatever Python it finds first: the system's has NumPy.
        blender = ("env", "PATH=/usr/bin:/bin", "blender", "-b", "--python-exit-code", "1", "--python")
        for program, text in ((("freecadcmd",), FREECAD), (blender, BLENDER)):
            script.write_text(text.replace("FOLDER", str(folder)).replace("NAVE", str(nave)))
            run(*program, script)
    for source, target in (("temple.stl", "meshlab-temple.obj"), ("bracket.stl", "meshlab-bracket.ply")):
        run("xvfb-run", "-a", "meshlabserver", "-i", folder / source, "-o", folder / target) # it wants a display
    run("assimp", "export", nave, folder / "assimp-nave.stl")


def main():
    parser = argparse.ArgumentParser(usage=__doc__)
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--share", type=pathlib.Path, action="append", default=[])
    parser.add_argument("--data", type=pathlib.Path, default=REPOSITORY / "data")
    arguments = parser.parse_args()
    folder = arguments.folder.resolve()
    folder.mkdir(parents=True, exist_ok=True)
    shares = [*arguments.share, pathlib.Path("/usr/share")]
    copy_installed(folder, shares)
    unpack_furniture(folder, shares)
    make_openscad(folder, shares)
    make_others(folder, (arguments.data / "nave/generated/nave.glb").resolve())


if __name__ == "__main__":
    main()
