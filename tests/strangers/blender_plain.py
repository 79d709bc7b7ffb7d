"""Writes what Blender reads of models as plain binary PLY files: triangles where the scene shows them, metres and
Blender's axes apart.

  blender --background --factory-startup --python blender_plain.py -- MODELS OUTPUT [NAME]...

MODELS is the folder that the names begin at; without names all of its models are taken. OUTPUT/NAME.ply is written
for each model that Blender reads; one that it does not read, or in which it finds no surface, has none.
"""

import os
import struct
import sys

import bpy

READERS = {
    ".obj": lambda path: bpy.ops.wm.obj_import(filepath=path, validate_meshes=True),
    ".fbx": lambda path: bpy.ops.import_scene.fbx(filepath=path),
    ".gltf": lambda path: bpy.ops.import_scene.gltf(filepath=path),
    ".glb": lambda path: bpy.ops.import_scene.gltf(filepath=path),
    ".dae": lambda path: bpy.ops.wm.collada_import(filepath=path),
    ".stl": lambda path: bpy.ops.import_mesh.stl(filepath=path),
    ".ply": lambda path: bpy.ops.import_mesh.ply(filepath=path),
    ".wrl": lambda path: bpy.ops.import_scene.x3d(filepath=path),
    ".x3d": lambda path: bpy.ops.import_scene.x3d(filepath=path),
    ".blend": lambda path: bpy.ops.wm.open_mainfile(filepath=path, load_ui=False),
}


def triangles():
    """Corners of all triangles that are rendered, three after each other."""
    corners = []
    graph = bpy.context.evaluated_depsgraph_get()
    for instance in graph.object_instances:
        shown = instance.object
        if shown.type not in {"MESH", "CURVE", "SURFACE", "FONT", "META"} or shown.hide_render:
            continue
        mesh = shown.to_mesh()
        if mesh is None:
            continue
        mesh.calc_loop_triangles()
        points = [instance.matrix_world @ vertex.co for vertex in mesh.vertices]
        for triangle in mesh.loop_triangles:
            corners.extend(points[i] for i in triangle.vertices)
        shown.to_mesh_clear()
    return corners


def write_ply(path, corners):
    os.makedirs(os.path.dirname(path), exist_ok=True)
    count = len(corners) // 3
    with open(path, "wb") as file:
        file.write(
            (
                "ply\nformat binary_little_endian 1.0\n"
                f"element vertex {3 * count}\nproperty float x\nproperty float y\nproperty float z\n"
                f"element face {count}\nproperty list uchar int vertex_indices\nend_header\n"
            ).encode()
        )
        for corner in corners:
            file.write(struct.pack("<3f", *corner))
        for i in range(count):
            file.write(struct.pack("<B3i", 3, 3 * i, 3 * i + 1, 3 * i + 2))


def convert(models, output, name):
    ending = os.path.splitext(name)[1].lower()
    if ending not in READERS:
        return
    bpy.ops.wm.read_factory_settings(use_empty=True)
    try:
        READERS[ending](os.path.join(models, name))
        corners = triangles()
    except Exception as error:  # one that Blender does not read
        print(f"blender_plain: {name}: {error}", file=sys.stderr)
        return
    if corners:
        write_ply(os.path.join(output, name + ".ply"), corners)


def names_in(models):
    for folder, _, files in os.walk(models):
        for file in files:
            yield os.path.relpath(os.path.join(folder, file), models)


def main():
    models, output, *names = sys.argv[sys.argv.index("--") + 1 :]
    for name in names or sorted(names_in(models)):
        convert(models, output, name)


main()
