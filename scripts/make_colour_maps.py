#!/usr/bin/env python3
"""Makes our own colour maps: smooth curves through a few colours in OKLab (Ottosson 2020), sampled at equal
distances. Run it by hand to change a map: scripts/make_colour_maps.py writes assets/colour_maps/*.csv."""
import math
import pathlib

COUNT = 256

# OKLab colours: lightness, green-red, blue-yellow.
PATHS = {
    # Dark enough to be visible on white: pale yellow, orange, crimson, dark violet.
    "ember": [(0.965, -0.018, 0.060), (0.85, 0.022, 0.120), (0.70, 0.120, 0.110), (0.54, 0.165, 0.045),
              (0.38, 0.115, -0.035), (0.25, 0.045, -0.065)],
    # Hardly any difference of green and red, which colour-blind people most often cannot see.
    "blue-yellow": [(0.26, -0.010, -0.115), (0.40, -0.015, -0.085), (0.60, -0.010, 0.000), (0.78, -0.012, 0.085),
                    (0.94, -0.030, 0.140)],
    "grey": [(0.20, 0, 0), (0.60, 0, 0), (0.97, 0, 0)],
}
# From the middle of a diverging map to both ends; points at the same distance from the middle are equally light.
DIVERGING = {
    "blue-red": ([(0.965, 0, 0), (0.80, -0.045, -0.075), (0.60, -0.045, -0.135), (0.36, -0.015, -0.140)],
                 [(0.965, 0, 0), (0.80, 0.070, 0.045), (0.60, 0.150, 0.075), (0.36, 0.125, 0.035)]),
}


def to_srgb(lab):
    lightness, a, b = lab
    l = (lightness + 0.3963377774 * a + 0.2158037573 * b) ** 3
    m = (lightness - 0.1055613458 * a - 0.0638541728 * b) ** 3
    s = (lightness - 0.0894841775 * a - 1.2914855480 * b) ** 3
    linear = (4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s,
              -1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s,
              -0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s)
    gamma = [12.92 * c if c <= 0.0031308 else 1.055 * c ** (1 / 2.4) - 0.055 for c in linear]
    if min(gamma) < -0.005 or max(gamma) > 1.005:
        raise SystemExit(f"{lab} is no sRGB colour: {gamma}")
    return [round(255 * min(1, max(0, c))) for c in gamma]


def spline(points, t):
    """Catmull-Rom through the points, t from 0 to 1."""
    place = min(t * (len(points) - 1), len(points) - 1 - 1e-12)
    k, s = int(place), place - int(place)
    before = points[k - 1] if k > 0 else [2 * p - q for p, q in zip(points[0], points[1])]
    after = points[k + 2] if k + 2 < len(points) else [2 * p - q for p, q in zip(points[-1], points[-2])]
    return [0.5 * (2 * b + s * (c - a) + s * s * (2 * a - 5 * b + 4 * c - d) + s ** 3 * (3 * b - a - 3 * c + d))
            for a, b, c, d in zip(before, points[k], points[k + 1], after)]


def walk(points, count):
    """`count` points of the path, of equal distance from one to the next."""
    fine = [spline(points, i / 20000) for i in range(20001)]
    length = [0.0]
    for a, b in zip(fine, fine[1:]):
        length.append(length[-1] + math.dist(a, b))
    found, at = [], 0
    for i in range(count):
        while at < 20000 and length[at] < length[-1] * i / (count - 1):
            at += 1
        found.append(fine[at])
    return found


def write(name, colours):
    folder = pathlib.Path(__file__).resolve().parent.parent / "assets" / "colour_maps"
    lines = ["red,green,blue"] + [",".join(str(c) for c in to_srgb(colour)) for colour in colours]
    (folder / f"{name}.csv").write_text("\n".join(lines) + "\n")


for name, path in PATHS.items():
    write(name, walk(path, COUNT))
for name, (low, high) in DIVERGING.items():
    write(name, walk(low, COUNT // 2)[::-1] + walk(high, COUNT // 2))
