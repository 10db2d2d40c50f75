#!/usr/bin/env python3
"""Draws the pictures of the shipped scenarios: portrait.png, a face made of curves and shading, and relief.png, an
equirectangular map of an invented planet. Usage: make_pictures.py [FOLDER]. Needs numpy; the results are in the
repository, so that building the program needs neither."""
import struct
import sys
import zlib
from pathlib import Path

import numpy as np


def write_png(path, grey):
    """Grey values from 0 to 1, rows from the top, as 8 bits; every row with the filter that compresses best."""
    pixels = np.round(np.clip(grey, 0, 1) * 255).astype(np.int16)
    height, width = pixels.shape
    rows, above = [], np.zeros(width, np.int16)
    for row in pixels:
        left = np.concatenate(([0], row[:-1]))
        choices = [(k, (row - other) % 256) for k, other in enumerate((0 * row, left, above, (left + above) // 2))]
        kind, best = min(choices, key=lambda c: np.minimum(c[1], 256 - c[1]).sum())
        rows.append(bytes([kind]) + best.astype(np.uint8).tobytes())
        above = row
    def chunk(name, data):
        return struct.pack(">I", len(data)) + name + data + struct.pack(">I", zlib.crc32(name + data))
    header = struct.pack(">IIBBBBB", width, height, 8, 0, 0, 0, 0)
    data = zlib.compress(b"".join(rows), 9)
    path.write_bytes(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", data) + chunk(b"IEND", b""))


def smooth(t):
    """From 0 to 1 as t goes from -1 to 1."""
    t = np.clip((t + 1) / 2, 0, 1)
    return t * t * (3 - 2 * t)


class Sheet:
    """White paper, x to the right and y up, from -view to view (y moved up by lift); every mark darkens it."""

    def __init__(self, size, view=1.0, lift=0.0):
        line = (np.arange(size) + 0.5) / size * 2 - 1
        self.x, self.y = np.meshgrid(view * line, view * -line + lift)
        self.ink = np.zeros((size, size))

    def ellipse(self, cx, cy, a, b, angle=0, soft=0.1):
        """1 inside, 0 outside, over a band of width `soft` relative to the half axes."""
        c, s = np.cos(np.radians(angle)), np.sin(np.radians(angle))
        u, v = (self.x - cx) * c + (self.y - cy) * s, (self.y - cy) * c - (self.x - cx) * s
        return smooth((1 - np.hypot(u / a, v / b)) / soft)

    def stroke(self, points, width, ends=0.3):
        """A smooth curve through points, with a profile of this width, thinner towards its ends."""
        p = np.array(points, float)
        for _ in range(4):  # Chaikin's corner cutting
            q = np.empty((2 * len(p) - 2, 2))
            q[0::2], q[1::2] = 0.75 * p[:-1] + 0.25 * p[1:], 0.25 * p[:-1] + 0.75 * p[1:]
            p = np.vstack((p[:1], q, p[-1:]))
        best = np.zeros_like(self.x)
        for k, ((x0, y0), (x1, y1)) in enumerate(zip(p[:-1], p[1:])):
            dx, dy = x1 - x0, y1 - y0
            t = np.clip(((self.x - x0) * dx + (self.y - y0) * dy) / max(dx * dx + dy * dy, 1e-12), 0, 1)
            along = (k + t) / (len(p) - 1)
            local = width * (ends + (1 - ends) * np.sqrt(np.clip(4 * along * (1 - along), 0, 1)))
            d = np.hypot(self.x - x0 - t * dx, self.y - y0 - t * dy)
            best = np.maximum(best, np.exp(-0.5 * (d / local) ** 2))
        return best

    def mark(self, mask, strength):
        self.ink += strength * mask * (1 - self.ink)

    def erase(self, mask, strength):
        self.ink *= 1 - strength * mask


def portrait(size=384):
    """A woman with dark hair and a high collar, lit from the upper left."""
    s = Sheet(size, 0.86, 0.0)
    x, y = s.x, s.y
    face = s.ellipse(0.0, 0.02, 0.40, 0.54, soft=0.06)
    jaw = s.ellipse(0.0, -0.20, 0.335, 0.37, soft=0.06)
    face = np.maximum(face * smooth((y + 0.12) / 0.2), np.maximum(jaw * smooth((0.3 - y) / 0.2), 0))
    # Behind: hair, neck and dress.
    hair = np.maximum(s.ellipse(0, 0.17, 0.62, 0.66, soft=0.10),
                      s.ellipse(0, -0.14, 0.64, 0.62, soft=0.12) * smooth((y + 0.72) / 0.15))
    s.mark(hair, 0.72)
    for k, bend in enumerate(np.linspace(-1, 1, 9)):  # strands of light
        s.erase(s.stroke([(0.05 + 0.1 * bend, 0.80), (0.42 * bend, 0.66), (0.62 * bend, 0.20),
                          (0.56 * bend, -0.50)], 0.010), 0.28 if k % 2 else 0.14)
    neck = smooth((0.20 - np.abs(x)) / 0.03) * smooth((-0.40 - y) / 0.1) * smooth((y + 0.98) / 0.05)
    s.erase(neck, 1.0)
    s.mark(neck * smooth((x + 0.05) / 0.2), 0.30)
    s.mark(neck * s.ellipse(0.02, -0.50, 0.30, 0.17, soft=0.5), 0.45)
    dress = smooth((-0.80 + 0.10 * np.cos(3 * x) - 0.30 * np.abs(x) ** 2.5 - y) / 0.03)
    s.erase(dress, 1.0)
    s.mark(dress, 0.5)
    s.erase(s.stroke([(-0.22, -0.72), (-0.10, -0.86), (0, -0.90), (0.10, -0.86), (0.22, -0.72)], 0.028, 1), 0.9)
    # The face, with its shaded side.
    s.erase(face, 1.0)
    s.mark(face * smooth((x - 0.20) / 0.28), 0.34)
    s.mark(face * s.ellipse(0.0, -0.66, 0.42, 0.26, soft=0.6), 0.22)
    s.mark(face * s.ellipse(0.27, -0.22, 0.14, 0.22, 20, soft=0.9), 0.14)
    s.mark(face * s.ellipse(-0.29, -0.24, 0.07, 0.20, -15, soft=0.9), 0.16)
    # The parting: hair over the forehead.
    fringe = np.maximum(s.ellipse(-0.33, 0.50, 0.35, 0.22, 38, soft=0.16),
                        s.ellipse(0.30, 0.52, 0.38, 0.22, -40, soft=0.16))
    s.mark(fringe, 0.74)
    s.erase(s.stroke([(0.0, 0.66), (-0.16, 0.60), (-0.36, 0.38)], 0.012), 0.3)
    s.erase(s.stroke([(0.0, 0.66), (0.20, 0.60), (0.38, 0.36)], 0.012), 0.2)
    for side in (-1, 1):
        ex, ey = 0.175 * side, 0.085
        s.mark(s.ellipse(ex, ey + 0.035, 0.125, 0.075, 4 * side, soft=0.8), 0.12)  # socket
        lid = s.ellipse(ex, ey, 0.100, 0.050, 3 * side, soft=0.15)
        s.erase(lid, 0.85)
        s.mark(lid * s.ellipse(ex + 0.005, ey + 0.004, 0.046, 0.050, soft=0.2), 0.70)
        s.mark(lid * s.ellipse(ex + 0.005, ey + 0.004, 0.022, 0.024, soft=0.3), 0.9)
        s.erase(s.ellipse(ex - 0.014, ey + 0.018, 0.013, 0.013, soft=0.5), 0.9)
        s.mark(s.stroke([(ex - 0.112, ey - 0.012 * (1 + side)), (ex - 0.05, ey + 0.058), (ex + 0.05, ey + 0.058),
                         (ex + 0.112, ey - 0.012 * (1 - side))], 0.0125, 0.6), 0.95)
        s.mark(s.stroke([(ex - 0.08, ey - 0.040), (ex, ey - 0.058), (ex + 0.08, ey - 0.040)], 0.006), 0.40)
        s.mark(s.stroke([(0.065 * side, 0.195), (0.15 * side, 0.250), (0.25 * side, 0.240), (0.315 * side, 0.185)],
                        0.0185, 0.35), 0.88)
    # Nose, lips, chin.
    s.mark(s.stroke([(0.055, 0.20), (0.035, 0.08), (0.055, -0.06), (0.085, -0.135)], 0.022, 0.4), 0.26)
    s.mark(s.ellipse(0.075, -0.13, 0.06, 0.05, soft=0.9), 0.28)
    s.mark(s.stroke([(-0.085, -0.145), (-0.055, -0.175), (0.0, -0.165), (0.05, -0.178), (0.085, -0.145)], 0.011), 0.72)
    for side in (-1, 1):
        s.mark(s.ellipse(0.042 * side, -0.163, 0.022, 0.011, 15 * side, soft=0.6), 0.75)
    s.mark(s.stroke([(0, -0.19), (0, -0.245)], 0.014), 0.16)
    upper = s.ellipse(0, -0.300, 0.138, 0.042, soft=0.25) * smooth((y + 0.312) / 0.008)
    lower = s.ellipse(0, -0.318, 0.118, 0.058, soft=0.25) * smooth((-0.308 - y) / 0.008)
    s.mark(upper, 0.62)
    s.mark(lower, 0.42)
    s.erase(s.ellipse(-0.02, -0.345, 0.045, 0.014, soft=0.9), 0.45)
    s.mark(s.stroke([(-0.150, -0.300), (-0.06, -0.318), (0, -0.308), (0.06, -0.318), (0.150, -0.300)], 0.0085, 0.5), 0.92)
    s.mark(s.ellipse(0.01, -0.415, 0.085, 0.024, soft=0.9), 0.26)
    s.mark(face * s.ellipse(0, -0.60, 0.2, 0.05, soft=0.9), 0.12)
    s.mark(s.stroke([(-0.37, -0.18), (-0.30, -0.40), (-0.15, -0.56), (0, -0.590), (0.15, -0.56), (0.30, -0.40),
                     (0.37, -0.18)], 0.011, 0.2), 0.40)
    return 1 - s.ink


def sphere_noise(p, frequency, rng):
    """Gradient noise at points of the unit sphere, about -1 to 1: waves in random directions, which have no seams and
    no poles."""
    total = np.zeros(p.shape[:-1])
    for _ in range(24):
        d = rng.normal(size=3)
        d *= frequency * rng.uniform(0.7, 1.4) / np.linalg.norm(d)
        total += np.sin(p @ d + rng.uniform(0, 2 * np.pi))
    return total / np.sqrt(12)


def relief(width=720):
    """Dark seas, grey plains, bright coasts, mountains and ridges."""
    rng = np.random.default_rng(21)
    lon = (np.arange(width) + 0.5) / width * 2 * np.pi - np.pi
    lat = np.pi / 2 - (np.arange(width // 2) + 0.5) / (width // 2) * np.pi
    lon, lat = np.meshgrid(lon, lat)
    p = np.stack((np.cos(lat) * np.cos(lon), np.cos(lat) * np.sin(lon), np.sin(lat)), -1)
    warp = np.stack([sphere_noise(p, 4, rng) for _ in range(3)], -1)
    q = p + 0.06 * warp
    height = sum(sphere_noise(q, f, rng) / f ** 0.9 for f in (3.2, 6.5, 13, 26)) * 2.6 - 0.25
    ridges = sum((1 - np.abs(sphere_noise(q, f, rng)).clip(0, 1)) ** 3 / f ** 0.5 for f in (5, 10, 20))
    belts = smooth(sphere_noise(q, 4, rng) / 0.7)
    land = smooth(height / 0.05)
    coast = np.exp(-0.5 * (height / 0.035) ** 2)
    grey = 0.03 + land * (0.16 + 0.16 * height.clip(0, 1) + 0.85 * belts * ridges * smooth((height - 0.15) / 0.2))
    return np.maximum(grey, 0.62 * coast).clip(0, 1)


def main():
    folder = Path(sys.argv[1] if len(sys.argv) > 1 else Path(__file__).parent)
    write_png(folder / "portrait.png", portrait())
    write_png(folder / "relief.png", relief())


if __name__ == "__main__":
    main()
