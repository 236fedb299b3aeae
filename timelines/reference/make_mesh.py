#!/usr/bin/env python3
"""Writes mesh.gltf beside it: a square tube that is open at the top, a button on it, and an animated node."""
import base64
import json
import pathlib
import struct

SIDE, RINGS, HEIGHT = 4, 17, 4.0  # edges along a side; rings of vertices; mesh units


def tube():
    rim = [(-1 + 2 * i / SIDE, -1) for i in range(SIDE)]
    rim += [(1, -1 + 2 * i / SIDE) for i in range(SIDE)]
    rim += [(1 - 2 * i / SIDE, 1) for i in range(SIDE)]
    rim += [(-1, 1 - 2 * i / SIDE) for i in range(SIDE)]
    around = len(rim)
    points = [(x / 2, y / 2, HEIGHT * k / (RINGS - 1)) for k in range(RINGS) for x, y in rim] + [(0, 0, 0)]
    bottom = [(around * RINGS, (i + 1) % around, i) for i in range(around)]
    walls = []
    for k in range(RINGS - 1):
        for i in range(around):
            a, b = k * around + i, k * around + (i + 1) % around
            walls += [(a, b, b + around), (a, b + around, a + around)]
    return points, bottom + walls, len(bottom)


def button():
    points = [(-0.1, -0.55, 2.9), (0.1, -0.55, 2.9), (0, -0.55, 3.1), (0, -0.65, 3)]
    return points, [(0, 2, 1), (0, 1, 3), (1, 2, 3), (2, 0, 3)]


class File:
    def __init__(self):
        self.bytes, self.views, self.accessors = b"", [], []

    def add(self, rows, code, kind, component):
        flat = [number for row in rows for number in row]
        data = struct.pack(f"<{len(flat)}{code}", *flat)
        self.bytes += b"\0" * (-len(self.bytes) % 4)
        self.views.append({"buffer": 0, "byteOffset": len(self.bytes), "byteLength": len(data)})
        self.bytes += data
        accessor = {"bufferView": len(self.views) - 1, "componentType": component, "type": kind,
                    "count": len(flat) if kind == "SCALAR" else len(rows)}
        if code == "f":
            columns = list(zip(*rows))
            floats = [struct.unpack(f"<{len(c)}f", struct.pack(f"<{len(c)}f", *c)) for c in columns]
            accessor.update(min=[min(c) for c in floats], max=[max(c) for c in floats])
        self.accessors.append(accessor)
        return len(self.accessors) - 1

    def primitive(self, points, faces):
        return {"attributes": {"POSITION": self.add(points, "f", "VEC3", 5126)},
                "indices": self.add(faces, "H", "SCALAR", 5123), "material": 0}


def main():
    file = File()
    points, faces, bottom = tube()
    body = file.primitive(points, faces)
    body["attributes"]["_SOFT"] = file.add([(p[2] / HEIGHT,) for p in points], "f", "SCALAR", 5126)
    body["extras"] = {"groups": [{"name": "bottom", "triangles": [0, bottom]}]}
    times = file.add([(0,), (0.5,), (1,)], "f", "SCALAR", 5126)
    moves = file.add([(0, 0, 0), (0, 0.2, 0), (0, 0, 0)], "f", "VEC3", 5126)
    document = {
        "asset": {"version": "2.0"},
        "scene": 0,
        "scenes": [{"nodes": [0, 1, 2]}],
        "nodes": [{"name": "Tube", "mesh": 0}, {"name": "Button", "mesh": 1}, {"name": "Lead"}],
        "meshes": [{"name": "Tube", "primitives": [body]},
                   {"name": "Button", "primitives": [file.primitive(*button())]}],
        "materials": [{"name": "skin", "pbrMetallicRoughness": {"baseColorFactor": [0.8, 0.7, 0.6, 1]}}],
        "animations": [{"name": "Walk", "samplers": [{"input": times, "output": moves}],
                        "channels": [{"sampler": 0, "target": {"node": 2, "path": "translation"}}]}],
        "accessors": file.accessors,
        "bufferViews": file.views,
        "buffers": [{"byteLength": len(file.bytes),
                     "uri": "data:application/octet-stream;base64," + base64.b64encode(file.bytes).decode()}],
    }
    path = pathlib.Path(__file__).with_name("mesh.gltf")
    path.write_text(json.dumps(document, separators=(",", ":")) + "\n")


main()
