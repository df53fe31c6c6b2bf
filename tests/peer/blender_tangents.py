"""Writes what Blender finds for the tangents of made meshes, for tests/peer/tangents_test.cpp.

usage: blender --background --factory-startup --python-exit-code 1 --python blender_tangents.py -- OUT.txt

Each mesh is a line "mesh NAME TRIANGLES" and three lines a triangle, one a corner: position, normal, u, v (which grows
upwards), tangent, sign of the bitangent. Numbers have nine digits, which are a float's.
"""
import math
import random
import sys

import bpy


def grid(columns, rows, place, uv):
    """Two triangles a cell; place and uv are functions of (i, j), uv of the cell too: corners may disagree."""
    points = [place(i, j) for j in range(rows + 1) for i in range(columns + 1)]
    faces, coordinates = [], []
    for j in range(rows):
        for i in range(columns):
            corners = [(i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)]
            for pick in ((0, 1, 2), (0, 2, 3)):
                faces.append([corners[k][1] * (columns + 1) + corners[k][0] for k in pick])
                coordinates += [uv(*corners[k], i, j) for k in pick]
    return points, faces, coordinates


def wave(i, j):
    return (i, j, math.sin(0.7 * i) + math.cos(1.1 * j))


def plain(i, j, *cell):
    return (i / 8, j / 8)


def joined_sphere():
    """Around its axis it is one, as is its picture at the seam: u = 0 and 1."""
    def place(i, j):
        longitude, latitude = math.tau * (i % 12) / 12, math.pi * (j / 6 - 0.5)
        return (math.cos(latitude) * math.cos(longitude), math.cos(latitude) * math.sin(longitude), math.sin(latitude))
    points, faces, coordinates = grid(12, 6, place, lambda i, j, *cell: (i / 12, j / 6))
    first = {}
    names = [first.setdefault(tuple(round(x, 6) for x in p), n) for n, p in enumerate(points)]
    return points, [[names[n] for n in face] for face in faces], coordinates


def mirrored():
    return grid(8, 6, wave, lambda i, j, *cell: (abs(i - 4) / 8, j / 8))


def patches(seed):
    """Each cell of the picture is turned, mirrored or squeezed to a line or a point, as chance has it."""
    chance = random.Random(seed)
    ways = [chance.choice([(1, 1), (-1, 1), (1, -1), (-1, -1), (0, 1), (1, 0), (0, 0), (1, 1), (1, 1)])
            for _ in range(8 * 8)]
    def uv(i, j, column, row):
        along, up = ways[8 * row + column]
        return (along * i / 8, up * j / 8)
    return grid(8, 8, wave, uv)


def scattered(seed):
    """Every corner has one of a few places of the texture."""
    chance = random.Random(seed)
    return grid(8, 8, wave, lambda i, j, *cell: (chance.randrange(4) / 4, chance.randrange(4) / 4))


def fans():
    """Four fans that touch at one point alone, and three triangles at one edge."""
    points, faces, coordinates = [(0, 0, 0)], [], []
    for k in range(4):
        a, b = k * math.tau / 4, k * math.tau / 4 + 1
        points += [(math.cos(a), math.sin(a), 0.1 * k), (math.cos(b), math.sin(b), 0.2)]
        faces.append([0, 2 * k + 1, 2 * k + 2])
        coordinates += [(0.5, 0.5), (0.5 + 0.25 * k, 1), (0, 0.25 * k)]
    points += [(2, 0, 0), (2, 1, 0), (2, 0, 1), (2, 1, 1), (3, 0, 0)]
    for third, uv in ((11, (1, 0)), (12, (0, 1)), (13, (0.5, 0.75))):
        faces.append([9, 10, third])
        coordinates += [(0, 0), (0, 1), uv]
    return points, faces, coordinates


def thin():
    """Triangles with two corners at one place, and with three in a line."""
    points, faces, coordinates = grid(4, 4, wave, lambda i, j, *cell: (i / 4, j / 4))
    points[6] = points[7]
    points[17] = tuple(0.5 * (a + b) for a, b in zip(points[16], points[18]))
    return points, faces, coordinates


def written(file, name, points, faces, coordinates):
    mesh = bpy.data.meshes.new(name)
    mesh.from_pydata(points, [], faces)
    for polygon in mesh.polygons:
        polygon.use_smooth = True
    layer = mesh.uv_layers.new()
    for loop, uv in zip(layer.data, coordinates):
        loop.uv = uv
    write(file, name, mesh)


def write(file, name, mesh):
    mesh.calc_tangents()
    uvs = mesh.uv_layers.active.data
    print("mesh", name, len(mesh.polygons), file=file)
    for polygon in mesh.polygons:
        assert len(polygon.loop_indices) == 3
        for index in polygon.loop_indices:
            loop = mesh.loops[index]
            numbers = [*mesh.vertices[loop.vertex_index].co, *loop.normal, *uvs[index].uv, *loop.tangent,
                       loop.bitangent_sign]
            print(*("%.9g" % x for x in numbers), file=file)


def suzanne():
    """Blender's own monkey, with its own texture coordinates, which are mirrored in places."""
    bpy.ops.mesh.primitive_monkey_add(calc_uvs=True)
    thing = bpy.context.object
    bpy.ops.object.shade_smooth()
    bpy.ops.object.modifier_add(type="TRIANGULATE")
    bpy.ops.object.modifier_apply(modifier=thing.modifiers[0].name)
    return thing.data


with open(sys.argv[sys.argv.index("--") + 1], "w") as out:
    written(out, "plain", *grid(8, 6, wave, plain))
    written(out, "sphere", *joined_sphere())
    written(out, "mirrored", *mirrored())
    for number in range(6):
        written(out, "patches_%d" % number, *patches(number))
        written(out, "scattered_%d" % number, *scattered(number))
    written(out, "fans", *fans())
    written(out, "thin", *thin())
    write(out, "suzanne", suzanne())
