"""Renders a .glb in the light of an environment by Blender's Cycles, for bench/reference.sh and tests/peer.

usage: blender --background --factory-startup --python-exit-code 1 --python bench/reference_cycles.py --
       SCENE.glb ENVIRONMENT.exr OUT.exr --size WxH --samples N [--bounces N] [--node NODE]…

The scene has its camera (mirrorball export). The environment is as `mirrorball convert --to equirect --for blender`
writes it. The output is linear light. No denoising, no adaptive sampling, nothing clamped, no caustics blurred; bounces
are Blender's defaults.

--node KIND,ROUGHNESS[,R,G,B] puts one node in the place of every material: diffuse, glossy or glass (index 1.5), the last
two MULTI_GGX, or single_glass, which is GGX. The roughness is Blender's, which squares it as we do. Pixels are boxes
then, as ours are. It may be repeated: the pictures are OUT_0.exr, OUT_1.exr, …
"""
import argparse
import sys

import bpy
import numpy

# Debian 12's importer of glTF uses a name that its NumPy has no more.
numpy.bool = bool


def arguments():
    parser = argparse.ArgumentParser(prog="reference_cycles.py")
    parser.add_argument("scene")
    parser.add_argument("environment")
    parser.add_argument("output")
    parser.add_argument("--size", required=True)
    parser.add_argument("--samples", type=int, required=True)
    parser.add_argument("--bounces", type=int, default=0)
    parser.add_argument("--node", action="append", default=[])
    return parser.parse_args(sys.argv[sys.argv.index("--") + 1:])


def light_by(path):
    """The world's light is the panorama, as it is."""
    world = bpy.data.worlds.new("environment")
    world.use_nodes = True
    nodes, links = world.node_tree.nodes, world.node_tree.links
    texture = nodes.new("ShaderNodeTexEnvironment")
    texture.image = bpy.data.images.load(path)
    texture.image.colorspace_settings.name = "Linear"
    links.new(texture.outputs["Color"], nodes["Background"].inputs["Color"])
    bpy.context.scene.world = world


def shade_all_by(node):
    """One node in the place of every material."""
    kind, roughness, *color = node.split(",")
    types = {"diffuse": "ShaderNodeBsdfDiffuse", "glossy": "ShaderNodeBsdfGlossy", "glass": "ShaderNodeBsdfGlass",
             "single_glass": "ShaderNodeBsdfGlass"}
    material = bpy.data.materials.new(node)
    material.use_nodes = True
    nodes, links = material.node_tree.nodes, material.node_tree.links
    nodes.clear()
    shader = nodes.new(types[kind])
    if kind != "diffuse":
        # MULTI_GGX of roughness 0 is a very narrow lobe, and not a mirror.
        rough = "GGX" if kind == "single_glass" else "MULTI_GGX"
        shader.distribution = rough if float(roughness) > 0 else "SHARP"
    # Of the diffuse node it is that of Oren and Nayar, where 0 is Lambert.
    shader.inputs["Roughness"].default_value = float(roughness)
    shader.inputs["Color"].default_value = [float(channel) for channel in color or (1, 1, 1)] + [1.0]
    if "IOR" in shader.inputs:
        shader.inputs["IOR"].default_value = 1.5
    output = nodes.new("ShaderNodeOutputMaterial")
    links.new(shader.outputs["BSDF"], output.inputs["Surface"])
    for mesh in bpy.data.meshes:
        mesh.materials.clear()
        mesh.materials.append(material)


def main():
    options = arguments()
    bpy.ops.wm.read_factory_settings(use_empty=True)
    bpy.ops.import_scene.gltf(filepath=options.scene)
    light_by(options.environment)
    scene = bpy.context.scene
    scene.camera = next(thing for thing in bpy.data.objects if thing.type == "CAMERA")
    scene.render.engine = "CYCLES"
    cycles = scene.cycles
    cycles.device = "CPU"
    cycles.samples = options.samples
    cycles.use_adaptive_sampling = False
    cycles.use_denoising = False
    cycles.sample_clamp_direct = cycles.sample_clamp_indirect = 0.0
    cycles.blur_glossy = 0.0
    if options.bounces > 0:
        cycles.max_bounces = cycles.diffuse_bounces = cycles.glossy_bounces = options.bounces
        cycles.transmission_bounces = options.bounces
    render = scene.render
    render.resolution_x, render.resolution_y = (int(side) for side in options.size.split("x"))
    render.resolution_percentage = 100
    render.image_settings.file_format = "OPEN_EXR"
    render.image_settings.color_depth = "32"
    if not options.node:
        render.filepath = options.output
        bpy.ops.render.render(write_still=True)
    for index, node in enumerate(options.node):
        shade_all_by(node)
        cycles.pixel_filter_type = "BOX"
        render.filepath = options.output.replace(".exr", f"_{index}.exr")
        bpy.ops.render.render(write_still=True)


main()
