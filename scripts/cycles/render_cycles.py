"""Renders a scene of write_scene.py by Cycles. Runs within Blender 3.4:

    blender --background --factory-startup --threads N --python render_cycles.py -- SCENE OUTPUT.pfm WIDTH HEIGHT SAMPLES SEED

SCENE.npz and SCENE.json are read. Our y is up, Blender's z: a point (x y z) is (x -z y) there.
"""
import json
import math
import os
import sys

import bpy
import mathutils
import numpy


def turned(v):
    return mathutils.Vector((v[0], -v[2], v[1]))


def looking(position, direction, right=None):
    """Places what looks along its own -z, as cameras and lights do."""
    back = -turned(direction).normalized()
    side = turned(right) if right else turned((0, 1, 0)).cross(back)
    if side.length < 1e-6:
        side = back.orthogonal()
    side = (side - back * side.dot(back)).normalized()
    matrix = mathutils.Matrix((side, back.cross(side), back)).transposed().to_4x4()
    matrix.translation = turned(position)
    return matrix


class Nodes:
    """A node tree that begins empty."""

    def __init__(self, owner):
        owner.use_nodes = True
        self.tree = owner.node_tree
        self.tree.nodes.clear()

    def add(self, kind, inputs=None, **attributes):
        node = self.tree.nodes.new(kind)
        for key, value in attributes.items():
            setattr(node, key, value)
        for key, value in (inputs or {}).items():
            if hasattr(value, "is_output"):
                self.tree.links.new(value, node.inputs[key])
            else:
                node.inputs[key].default_value = value
        return node.outputs[0] if node.outputs else node

    def sum(self, kind, one, two, inputs=None):
        node = self.tree.nodes.new(kind)
        first = 1 if kind == "ShaderNodeMixShader" else 0
        for key, value in (inputs or {}).items():
            node.inputs[key].default_value = value
        self.tree.links.new(one, node.inputs[first])
        self.tree.links.new(two, node.inputs[first + 1])
        return node.outputs[0]


def linear_image(path):
    """The texture as linear floats: Cycles mixes the texels of images of bytes as sRGB, which is darker at edges."""
    stored = bpy.data.images.load(path)
    stored.colorspace_settings.name = "Non-Color"
    values = numpy.empty(len(stored.pixels), numpy.float32)
    stored.pixels.foreach_get(values)
    values = values.reshape(-1, 4)
    colour = values[:, :3]
    values[:, :3] = numpy.where(colour <= 0.04045, colour / 12.92, ((colour + 0.055) / 1.055) ** 2.4)
    image = bpy.data.images.new(path, *stored.size, float_buffer=True, is_data=True)
    image.pixels.foreach_set(values.ravel())
    image.pack()
    return image


def add_material(number, told, folder):
    material = bpy.data.materials.new("m%d" % number)
    nodes = Nodes(material)
    white = (1, 1, 1, 1)
    if told["glass"]:
        rough = told["roughness"]
        surface = nodes.add("ShaderNodeBsdfGlass", {"Color": white, "Roughness": rough, "IOR": told["glass"]},
                            distribution="GGX" if rough else "SHARP")
    elif told["pane"]:
        surface = nodes.add("ShaderNodeBsdfTransparent", {"Color": (*told["pane"], 1)})
    elif told["metal"]:
        surface = nodes.add("ShaderNodeBsdfGlossy", {"Color": (*told["metal"], 1), "Roughness": told["roughness"]},
                            distribution="MULTI_GGX")
    else:
        colour = (*told["diffuse"], 1)
        if told["texture"]:
            colour = nodes.add("ShaderNodeTexImage", image=linear_image(os.path.join(folder, told["texture"])))
            if tuple(told["diffuse"]) != (1, 1, 1):
                mixed = nodes.tree.nodes.new("ShaderNodeVectorMath")
                mixed.operation = "MULTIPLY"
                nodes.tree.links.new(colour, mixed.inputs[0])
                mixed.inputs[1].default_value = told["diffuse"]
                colour = mixed.outputs[0]
        surface = nodes.add("ShaderNodeBsdfDiffuse", {"Color": colour, "Roughness": 0.0})
        if told["mirror"]:
            mirror = nodes.add("ShaderNodeBsdfGlossy", {"Color": white, "Roughness": 0.0}, distribution="SHARP")
            surface = nodes.sum("ShaderNodeMixShader", surface, mirror, {"Fac": told["mirror"]})
    if any(told["emission"]):
        shone = nodes.add("ShaderNodeEmission", {"Color": (*told["emission"], 1), "Strength": 1.0})
        surface = nodes.sum("ShaderNodeAddShader", surface, shone)
    inputs = {"Surface": surface}
    if told["absorbs"]:
        density = max(told["absorbs"])
        inputs["Volume"] = nodes.add("ShaderNodeVolumeAbsorption", {
            "Color": (*(1 - e / density for e in told["absorbs"]), 1), "Density": density})
    nodes.add("ShaderNodeOutputMaterial", inputs)
    return material


def link(name, data):
    thing = bpy.data.objects.new(name, data)
    bpy.context.scene.collection.objects.link(thing)
    return thing


def add_triangles(arrays, materials):
    points, index = arrays["points"].astype(numpy.float32), arrays["index"]
    mesh = bpy.data.meshes.new("model")
    mesh.vertices.add(len(points))
    mesh.vertices.foreach_set("co", numpy.stack((points[:, 0], -points[:, 2], points[:, 1]), 1).ravel())
    mesh.loops.add(index.size)
    mesh.loops.foreach_set("vertex_index", index.ravel())
    mesh.polygons.add(len(index))
    mesh.polygons.foreach_set("loop_start", numpy.arange(0, index.size, 3, dtype=numpy.int32))
    mesh.polygons.foreach_set("loop_total", numpy.full(len(index), 3, numpy.int32))
    mesh.polygons.foreach_set("material_index", arrays["material"].astype(numpy.int32))
    mesh.polygons.foreach_set("use_smooth", numpy.zeros(len(index), bool))
    if arrays["coordinates"].any():
        mesh.uv_layers.new(name="uv").data.foreach_set("uv", arrays["coordinates"].astype(numpy.float32).ravel())
    for material in materials:
        mesh.materials.append(material)
    mesh.update(calc_edges=True)
    link("model", mesh)


def emission_nodes(light, colour, strength):
    nodes = Nodes(light)
    nodes.add("ShaderNodeOutputLight", {"Surface": nodes.add("ShaderNodeEmission", {"Color": (*colour, 1), "Strength": strength})})


def add_light(told, exact):
    kind = {"point": "POINT", "sphere": "POINT", "directional": "SUN", "rectangle": "AREA"}[told["kind"]]
    if told["kind"] == "sphere" and exact:
        return add_shining_ball(told)
    light = bpy.data.lights.new("light", kind)
    light.color, light.energy = (1, 1, 1), {"SUN": 1, "AREA": 4}.get(kind, 4 * math.pi)
    emission_nodes(light, told["intensity"], 1.0)
    light.cycles.use_multiple_importance_sampling = True
    if kind == "SUN":
        light.angle = 0.0
    elif kind == "AREA":
        light.shape, (light.size, light.size_y) = "RECTANGLE", told["size"]
    else:
        light.shadow_soft_size = told["radius"]
    thing = link("light", light)
    thing.matrix_world = looking(told["position"], told["direction"], told["right"])
    thing.visible_camera = False
    return thing


def add_shining_ball(told):
    """A sphere that shines as a mesh: Cycles 3.4 takes its sphere lights for discs that face the point. Light passes it."""
    bpy.ops.mesh.primitive_ico_sphere_add(subdivisions=6, radius=told["radius"], location=turned(told["position"]))
    thing = bpy.context.object
    area = sum(p.area for p in thing.data.polygons)
    size = math.sqrt(4 * math.pi * told["radius"] ** 2 / area)
    thing.scale = (size, size, size)
    material = bpy.data.materials.new("light")
    nodes = Nodes(material)
    # From its outside only: through it one sees its inside.
    side = nodes.tree.nodes.new("ShaderNodeNewGeometry").outputs["Backfacing"]
    strength = nodes.tree.nodes.new("ShaderNodeMath")
    strength.operation = "MULTIPLY_ADD"
    nodes.tree.links.new(side, strength.inputs[0])
    strength.inputs[2].default_value = 1 / (math.pi * told["radius"] ** 2)
    strength.inputs[1].default_value = -strength.inputs[2].default_value
    shone = nodes.add("ShaderNodeEmission", {"Color": (*told["intensity"], 1), "Strength": strength.outputs[0]})
    clear = nodes.add("ShaderNodeBsdfTransparent", {"Color": (1, 1, 1, 1)})
    nodes.add("ShaderNodeOutputMaterial", {"Surface": nodes.sum("ShaderNodeAddShader", shone, clear)})
    thing.data.materials.append(material)
    thing.visible_camera = False
    return thing


def add_world(told, folder):
    world = bpy.data.worlds.new("world")
    bpy.context.scene.world = world
    nodes = Nodes(world)
    colour = (*told["background"], 1)
    if told["sky"]:
        image = bpy.data.images.load(os.path.join(folder, told["sky"]))
        colour = nodes.add("ShaderNodeTexEnvironment", image=image)
    nodes.add("ShaderNodeOutputWorld", {"Surface": nodes.add("ShaderNodeBackground", {"Color": colour})})


def add_camera(told):
    camera = bpy.data.cameras.new("camera")
    camera.sensor_fit, camera.angle = "HORIZONTAL", math.radians(told["fov"])
    camera.clip_start, camera.clip_end = 1e-4, 1e6
    thing = link("camera", camera)
    thing.matrix_world = looking(told["eye"], [b - a for a, b in zip(told["eye"], told["lookAt"])])
    bpy.context.scene.camera = thing


def set_up(told, width, height, samples, seed):
    """No clamp, no filter but the pixel itself, no stop by noise, no threshold below which lights are left out."""
    scene, cycles = bpy.context.scene, bpy.context.scene.cycles
    scene.render.engine = "CYCLES"
    scene.render.resolution_x, scene.render.resolution_y, scene.render.resolution_percentage = width, height, 100
    scene.render.use_compositing = scene.render.use_sequencer = False
    for name, value in (("samples", samples), ("seed", seed), ("use_adaptive_sampling", False), ("use_denoising", False),
                        ("sample_clamp_direct", 0.0), ("sample_clamp_indirect", 0.0), ("blur_glossy", 0.0),
                        ("light_sampling_threshold", 0.0), ("pixel_filter_type", "BOX"), ("filter_width", 1.0),
                        ("caustics_reflective", told["caustics"]), ("caustics_refractive", told["caustics"]),
                        ("max_bounces", told["bounces"]), ("diffuse_bounces", told["bounces"]),
                        ("glossy_bounces", told["bounces"]), ("transmission_bounces", told["bounces"]),
                        ("transparent_max_bounces", 256), ("use_auto_tile", False)):
        setattr(cycles, name, value)
    settings = scene.render.image_settings
    settings.file_format, settings.color_depth, settings.exr_codec = "OPEN_EXR", "32", "ZIP"


def main():
    scene, output = sys.argv[sys.argv.index("--") + 1:][:2]
    width, height, samples, seed = map(int, sys.argv[sys.argv.index("--") + 3:][:4])
    exact = sys.argv[-1] != "--own-spheres"
    with open(scene + ".json", encoding="ascii") as file:
        told = json.load(file)
    for thing in list(bpy.data.objects):
        bpy.data.objects.remove(thing)
    folder = os.path.dirname(os.path.abspath(scene))
    materials = [add_material(number, m, folder) for number, m in enumerate(told["materials"])]
    with numpy.load(scene + ".npz") as arrays:
        add_triangles(arrays, materials)
    for light in told["lights"]:
        add_light(light, exact)
    add_world(told, folder)
    add_camera(told)
    set_up(told, width, height, samples, seed)
    bpy.context.scene.render.filepath = output + ".exr"
    bpy.ops.render.render(write_still=True)
    image = bpy.data.images.load(output + ".exr")
    image.colorspace_settings.name = "Non-Color"
    values = numpy.empty(4 * width * height, numpy.float32)
    image.pixels.foreach_get(values)
    with open(output, "wb") as file:
        file.write(b"PF\n%d %d\n-1.0\n" % (width, height) + values.reshape(-1, 4)[:, :3].astype("<f4").tobytes())
    os.remove(output + ".exr")


main()
