"""Runs in Blender: reads a model, fits its axes to ours, and renders its base colours and its mask.

    blender --background --factory-startup --python render_blender.py -- JOB.json

The job names `model`, `image` (an EXR of 32-bit floats that is written), `answer` (JSON that is written: turn, scale,
view, bounds and counts), `side` in pixels, of ours `low`, `high` and `zero`, and
the `usual` turn to our axes, or null for that of the format.
"""
import json
import os
import sys

import bpy
import mathutils
import numpy

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import frames  # noqa: E402
import plain_materials  # noqa: E402

for old, new in (("bool", bool), ("int", int), ("float", float), ("object", object)):
    if old not in vars(numpy):  # as the glTF reader of Blender 3.4 calls them
        setattr(numpy, old, new)

SURFACES = {"MESH", "CURVE", "SURFACE", "FONT", "META"}


def read_gltf(path):
    """In the pose of its nodes: without animations."""
    from io_scene_gltf2.io.imp import gltf2_io_gltf
    reader = gltf2_io_gltf.glTFImporter
    whole = reader.read

    def still(self):
        result = whole(self)
        self.data.animations = None
        return result

    reader.read = still
    bpy.ops.import_scene.gltf(filepath=path)


def read_x3d(path):
    """Its reader opens files in a mode that Python no longer knows."""
    from io_scene_x3d import import_x3d
    import_x3d.open = lambda name, mode="r", **options: open(name, mode.replace("U", ""), **options)
    bpy.ops.import_scene.x3d(filepath=path)


def read_dxf(path):
    import addon_utils
    addon_utils.enable("io_import_dxf")
    bpy.ops.import_scene.dxf(filepath=path)


def open_blend(path):
    bpy.ops.wm.open_mainfile(filepath=path, load_ui=False)


X3D = ((0, -1), (2, 1), (1, 1))  # as Blender turns these
# Reader, usual turn to our axes, usual scales.
READERS = {
    ".gltf": (read_gltf, frames.Z_TO_Y, (1.0,)),
    ".glb": (read_gltf, frames.Z_TO_Y, (1.0,)),
    ".vrm": (read_gltf, frames.Z_TO_Y, (1.0,)),
    ".fbx": (lambda path: bpy.ops.import_scene.fbx(filepath=path, use_anim=False), frames.Z_TO_Y, (100.0, 1.0)),
    ".dae": (lambda path: bpy.ops.wm.collada_import(filepath=path), frames.Z_TO_Y, (1.0,)),
    ".obj": (lambda path: bpy.ops.wm.obj_import(filepath=path, validate_meshes=True), frames.Z_TO_Y, (1.0,)),
    ".ply": (lambda path: bpy.ops.import_mesh.ply(filepath=path), frames.AS_IS, (1.0,)),
    ".stl": (lambda path: bpy.ops.import_mesh.stl(filepath=path), frames.AS_IS, (1.0,)),
    ".wrl": (read_x3d, X3D, (1.0,)),
    ".x3d": (read_x3d, X3D, (1.0,)),
    ".dxf": (read_dxf, frames.Z_TO_Y, (1.0,)),
    ".blend": (open_blend, frames.AS_IS, (1.0,)),
}


def surfaces():
    """Bounds of all triangles that are rendered, their number, and that of pairs of an object and a material."""
    points, count, parts = [], 0, 0
    graph = bpy.context.evaluated_depsgraph_get()
    for instance in graph.object_instances:
        shown = instance.object
        if shown.type not in SURFACES or shown.hide_render:
            continue
        mesh = shown.to_mesh()
        if mesh is None:
            continue
        mesh.calc_loop_triangles()
        used = {i for triangle in mesh.loop_triangles for i in triangle.vertices}
        points += [tuple(instance.matrix_world @ mesh.vertices[i].co) for i in used]
        count += len(mesh.loop_triangles)
        parts += len({triangle.material_index for triangle in mesh.loop_triangles})
        shown.to_mesh_clear()
    if not count:
        raise ValueError("it shows no surfaces")
    return (tuple(map(min, *points, points[0])), tuple(map(max, *points, points[0]))), count, parts


def look(scene, view, turn, scale, zero):
    """The camera of ours, in their axes."""
    eye = frames.turned_back(turn, [(v + z) / scale for v, z in zip(view["eye"], zero)])
    forward, up = (mathutils.Vector(frames.turned_back(turn, view[name])) for name in ("forward", "up"))
    right = forward.cross(up)
    camera = bpy.data.objects.new("view", bpy.data.cameras.new("view"))
    camera.data.type, camera.data.ortho_scale = "ORTHO", view["width"] / scale
    camera.data.clip_start, camera.data.clip_end = 1e-6 * view["depth"] / scale, view["depth"] / scale
    rows = zip(right, up, -forward, eye)
    camera.matrix_world = mathutils.Matrix([list(row) for row in rows] + [[0, 0, 0, 1]])
    scene.collection.objects.link(camera)
    scene.camera = camera


def render(scene, image, side):
    scene.render.engine = "CYCLES"
    cycles, output = scene.cycles, scene.render
    cycles.device, cycles.samples, cycles.use_denoising, cycles.use_adaptive_sampling = "CPU", 1, False, False
    cycles.pixel_filter_type, cycles.filter_width = "BLACKMAN_HARRIS", 0.01  # rays through the middles of pixels
    cycles.transparent_max_bounces, cycles.max_bounces = 256, 0
    output.resolution_x = output.resolution_y = side
    output.resolution_percentage, output.pixel_aspect_x, output.pixel_aspect_y = 100, 1, 1
    output.film_transparent, output.use_border, output.use_compositing, output.use_sequencer = True, False, False, False
    output.use_motion_blur, output.use_freestyle, output.use_simplify = False, False, False
    output.threads_mode, output.threads = "FIXED", 1
    scene.world, scene.use_nodes = None, False
    settings = output.image_settings
    settings.file_format, settings.color_mode, settings.color_depth = "OPEN_EXR", "RGBA", "32"
    settings.exr_codec, output.filepath, output.use_file_extension = "ZIP", image, False
    bpy.ops.render.render(write_still=True)


def main():
    with open(sys.argv[sys.argv.index("--") + 1], encoding="utf-8") as file:
        job = json.load(file)
    read, usual, scales = READERS[os.path.splitext(job["model"])[1].lower()]
    usual = tuple(map(tuple, job["usual"] or usual))
    bpy.ops.wm.read_factory_settings(use_empty=True)
    read(job["model"])
    scene = bpy.context.scene
    theirs, triangles, parts = surfaces()
    ours = tuple(job["low"]), tuple(job["high"])
    turn, scale, distance = frames.align(ours, theirs, usual, scales, job["zero"])
    view = frames.view(frames.union(ours, frames.turned_box(turn, scale, theirs, job["zero"])))
    opacities = plain_materials.opacities()
    plain_materials.convert()
    look(scene, view, turn, scale, job["zero"])
    render(scene, job["image"], job["side"])
    answer = {"turn": turn, "usual": turn == usual, "scale": scale, "apart": distance, "view": view, "box": theirs,
              "triangles": triangles, "parts": parts, "opacities": opacities}
    with open(job["answer"], "w", encoding="utf-8") as file:
        json.dump(answer, file)


if __name__ == "__main__":
    main()
