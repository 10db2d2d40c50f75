#!/usr/bin/env python3
"""Makes half-disk.obj, the mesh of the upper half of the unit disk with which maps from the mesh of a file begin.

Usage: make_meshes.py [FOLDER]. The result is in the repository."""
import math
import sys
from pathlib import Path

RINGS = 12


def half_disk():
    """Ring i has 3 i + 1 nodes."""
    starts, nodes, faces = [0], [(0.0, 0.0)], []
    for i in range(1, RINGS + 1):
        starts.append(len(nodes))
        for j in range(3 * i + 1):
            angle = math.pi * j / (3 * i)
            nodes.append((i / RINGS * math.cos(angle), i / RINGS * math.sin(angle)))
        for third in range(3):
            for k in range(i):
                inner, outer = starts[i - 1] + third * (i - 1) + k, starts[i] + third * i + k
                faces.append((inner, outer, outer + 1))
                if k + 1 < i:
                    faces.append((inner, outer + 1, inner + 1))
    return nodes, faces


def main():
    folder = Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).parent
    nodes, faces = half_disk()
    lines = ["# The upper half of the unit disk: %d nodes, %d triangles" % (len(nodes), len(faces))]
    lines += ["v %.9g %.9g 0" % (x, 0 if abs(y) < 1e-12 else y) for x, y in nodes]
    lines += ["f %d %d %d" % tuple(k + 1 for k in face) for face in faces]
    (folder / "half-disk.obj").write_text("\n".join(lines) + "\n")


main()
