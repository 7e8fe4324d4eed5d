# SPDX-License-Identifier: MIT
"""A world file of a small room with one red box in it, made in an instant: for tests that need no tank.

The room is 3 m along x and 2 m along y about the origin, its walls 0.6 m high. The robot starts at (-0.9, 0) and looks
along x. The map frame lies 0.1 m beside the world frame, so that a mix-up of the two shows."""

import json
import os
import struct

LENGTH_M, WIDTH_M, WALL_M = 3.0, 2.0, 0.6
BOX_CENTRE, BOX_SIZE = (0.8, 0.2, 0.04), (0.12, 0.10, 0.08)
MAP_SHIFT = (0.1, 0.0, 0.0)
START_MAP = (-0.8, 0.0, 0.0)
#: Points of the map file that write_map makes: the floor 5 cm apart.
MAP_POINTS = 60 * 40


def box_centre_map():
    return tuple(place + shift for place, shift in zip(BOX_CENTRE, MAP_SHIFT))


def _quad(corners):
    return corners, [(0, 1, 2), (0, 2, 3)]


def _room():
    x, y, z = LENGTH_M / 2, WIDTH_M / 2, WALL_M
    yield _quad([(-x, -y, 0), (x, -y, 0), (x, y, 0), (-x, y, 0)])
    yield _quad([(-x, -y, 0), (x, -y, 0), (x, -y, z), (-x, -y, z)])
    yield _quad([(-x, y, 0), (x, y, 0), (x, y, z), (-x, y, z)])
    yield _quad([(-x, -y, 0), (-x, y, 0), (-x, y, z), (-x, -y, z)])
    yield _quad([(x, -y, 0), (x, y, 0), (x, y, z), (x, -y, z)])


def _box():
    (cx, cy, cz), (sx, sy, sz) = BOX_CENTRE, (side / 2 for side in BOX_SIZE)
    x0, x1, y0, y1, z0, z1 = cx - sx, cx + sx, cy - sy, cy + sy, cz - sz, cz + sz
    yield _quad([(x0, y0, z1), (x1, y0, z1), (x1, y1, z1), (x0, y1, z1)])
    yield _quad([(x0, y0, z0), (x1, y0, z0), (x1, y0, z1), (x0, y0, z1)])
    yield _quad([(x0, y1, z0), (x1, y1, z0), (x1, y1, z1), (x0, y1, z1)])
    yield _quad([(x0, y0, z0), (x0, y1, z0), (x0, y1, z1), (x0, y0, z1)])
    yield _quad([(x1, y0, z0), (x1, y1, z0), (x1, y1, z1), (x1, y0, z1)])


def _write_mesh(file, quads, colour):
    vertices, faces = [], []
    for corners, triangles in quads:
        faces += [tuple(len(vertices) + corner for corner in triangle) for triangle in triangles]
        vertices += corners
    with open(file, "w", encoding="ascii") as out:
        out.write(f"ply\nformat ascii 1.0\nelement vertex {len(vertices)}\n"
                  "property float x\nproperty float y\nproperty float z\n"
                  "property uchar red\nproperty uchar green\nproperty uchar blue\n"
                  f"element face {len(faces)}\nproperty list uchar int vertex_indices\nend_header\n")
        for vertex in vertices:
            out.write("{:g} {:g} {:g} {} {} {}\n".format(*vertex, *colour))
        for face in faces:
            out.write("3 {} {} {}\n".format(*face))


def write_world(folder):
    """@return the world file"""
    _write_mesh(os.path.join(folder, "room.ply"), _room(), (200, 200, 195))
    _write_mesh(os.path.join(folder, "box.ply"), _box(), (220, 10, 10))
    world = {
        "schema": "fodscope.world/1", "name": "small room", "structure": "room.ply",
        "objects": [{"type": "box", "fod": True, "mesh": "box.ply", "centroid": BOX_CENTRE}],
        "T_map_from_world": [[1, 0, 0, MAP_SHIFT[0]], [0, 1, 0, MAP_SHIFT[1]], [0, 0, 1, MAP_SHIFT[2]], [0, 0, 0, 1]],
        "robot_start": {"x": START_MAP[0] - MAP_SHIFT[0], "y": START_MAP[1] - MAP_SHIFT[1], "yaw_deg": 0.0},
    }
    file = os.path.join(folder, "world.json")
    with open(file, "w", encoding="utf-8") as out:
        json.dump(world, out)
    return file


def write_map(folder):
    """A finished map: the bare floor. @return its file"""
    file = os.path.join(folder, "map.ply")
    with open(file, "wb") as out:
        out.write(f"ply\nformat binary_little_endian 1.0\nelement vertex {MAP_POINTS}\nproperty float x\n"
                  "property float y\nproperty float z\nend_header\n".encode())
        for row in range(40):
            for column in range(60):
                out.write(struct.pack("<3f", -1.475 + 0.05 * column + MAP_SHIFT[0], -0.975 + 0.05 * row, 0.0))
    return file
