"""Runs in Blender: materials that emit their base colour, with the holes of alpha, so that an image shows it as it is.

What has no material nor colours of vertices is of NONE, which no colour is: there is nothing to compare.
"""
import bpy

NONE = (64.0, 64.0, 64.0, 1.0)
COLOURS = ("Base Color", "Color")
KINDS = ("BSDF_PRINCIPLED", "BSDF_DIFFUSE", "EEVEE_SPECULAR", "EMISSION")
HOLE = 0.003  # alpha below is a hole where the file states no cutoff


def shader_of(tree):
    """The node whose colour is the base colour: of those that reach the output the first kind of KINDS."""
    outputs = [node for node in tree.nodes if node.type == "OUTPUT_MATERIAL"]
    waiting, found = [node for node in outputs if node.is_active_output] or outputs, []
    for node in waiting:
        if any(name in node.inputs for name in COLOURS) and node.type != "BSDF_TRANSPARENT":
            found.append(node)
        sources = [link.from_node for socket in node.inputs if socket.type == "SHADER" for link in socket.links]
        waiting += [source for source in sources if source not in waiting]
    return min(found, key=lambda node: KINDS.index(node.type) if node.type in KINDS else len(KINDS), default=None)


def colour_of(node):
    return next(node.inputs[name] for name in COLOURS if name in node.inputs)


def is_missing(link):
    """The image behind it could not be read: Blender shows magenta."""
    image = getattr(link.from_node, "image", None) if link.from_node.type == "TEX_IMAGE" else None
    return link.from_node.type == "TEX_IMAGE" and (image is None or not image.size[0])


def connect(tree, source, target):
    link = source.links[0] if source.is_linked else None
    if link is None:
        target.default_value = source.default_value
    elif is_missing(link):
        target.default_value = NONE
    else:
        tree.links.new(link.from_socket, target)


def opacities():
    """By the names of materials: how much of the light does not pass, where that is a number."""
    result = {}
    for material in bpy.data.materials:
        node = shader_of(material.node_tree) if material.use_nodes else None
        alpha, passes = (node.inputs.get(name) if node else None for name in ("Alpha", "Transmission"))
        if alpha is not None and not alpha.is_linked and not passes.is_linked:
            result[material.name] = alpha.default_value * (1 - passes.default_value)
    return result


def with_holes(tree, shader, alpha, cutoff):
    """The shader where alpha, which an image says, is above the cutoff, and nothing elsewhere."""
    above, mix = tree.nodes.new("ShaderNodeMath"), tree.nodes.new("ShaderNodeMixShader")
    above.operation = "GREATER_THAN"
    tree.links.new(alpha.links[0].from_socket, above.inputs[0])
    above.inputs[1].default_value = cutoff
    tree.links.new(above.outputs[0], mix.inputs[0])
    tree.links.new(tree.nodes.new("ShaderNodeBsdfTransparent").outputs[0], mix.inputs[1])
    tree.links.new(shader, mix.inputs[2])
    return mix.outputs[0]


def emit(material):
    if not material.use_nodes:
        colour = tuple(material.diffuse_color)
        material.use_nodes = True
        material.node_tree.nodes.clear()
        tree, node = material.node_tree, None
    else:
        tree = material.node_tree
        node, colour = shader_of(tree), NONE
    emission = tree.nodes.new("ShaderNodeEmission")
    if node is None:
        emission.inputs[0].default_value = colour
    else:
        connect(tree, colour_of(node), emission.inputs[0])
    surface = emission.outputs[0]
    alpha = node.inputs.get("Alpha") if node is not None else None
    if alpha is not None and alpha.is_linked:
        cutoff = material.alpha_threshold if material.blend_method == "CLIP" else HOLE
        surface = with_holes(tree, surface, alpha, cutoff)
    finish(tree, surface)


def finish(tree, surface):
    for node in [node for node in tree.nodes if node.type == "OUTPUT_MATERIAL"]:
        tree.nodes.remove(node)
    output = tree.nodes.new("ShaderNodeOutputMaterial")
    tree.links.new(surface, output.inputs["Surface"])


def of_vertices(name):
    """Of what has no material: its colours of vertices, else NONE."""
    material = bpy.data.materials.new("plain")
    material.use_nodes = True
    tree = material.node_tree
    tree.nodes.clear()
    emission = tree.nodes.new("ShaderNodeEmission")
    if name:
        colours = tree.nodes.new("ShaderNodeVertexColor")
        colours.layer_name = name
        tree.links.new(colours.outputs[0], emission.inputs[0])
    else:
        emission.inputs[0].default_value = NONE
    finish(tree, emission.outputs[0])
    return material


def convert():
    for material in list(bpy.data.materials):
        if not material.is_grease_pencil:
            emit(material)
    for data in [*bpy.data.meshes, *bpy.data.curves, *bpy.data.metaballs]:
        colours = getattr(data, "color_attributes", None)
        name = colours[0].name if colours else ""
        if not any(data.materials):
            data.materials.clear()
            data.materials.append(of_vertices(name))
            continue
        for i, material in enumerate(data.materials):
            if material is None:
                data.materials[i] = of_vertices(name)
