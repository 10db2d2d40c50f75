#!/usr/bin/env python3
"""Does `nvfem` map any convex shape to any other? Makes seeded pairs of shapes (ellipses, superellipses, splines with
radii of curvature between about .3 and 3, polygons with round corners) with densities on both (constant, ring, bell,
random waves, random bells, contrast up to 20), runs `gaspard run` with degree 1 and 2, and prints a table in Markdown:
how many converged to a convex solution, how many of these without a folded cell of the mesh, their iterations and
times, then the other runs, with the reason. Usage: transport_pairs.py GASPARD [--pairs 40] [--seed 1] [--degrees 1,2] [--set KEY=VALUE ...]
[--verbose]. Needs numpy. Exits with 1 if a run has no convex solution."""
import argparse
import json
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy as np

SHAPES = ("ellipse", "rounded-rectangle", "curve", "polygon")
DENSITIES = ("constant", "ring", "bell", "random-waves", "random-bells")
RADII = 0.3, 3.0  # of curvature
TOLERANCE = 1e-8


def ellipse(rng):
    while True:
        a, b = rng.uniform(0.5, 2, 2)
        if RADII[0] <= min(a, b) ** 2 / max(a, b) and max(a, b) ** 2 / min(a, b) <= RADII[1]:
            return {"a": a, "b": b}


def rounded_rectangle(rng):
    return {"a": rng.uniform(0.6, 1.8), "b": rng.uniform(0.6, 1.8), "exponent": rng.uniform(2, 6)}


def curve(rng):
    """Points of the curve with the support function h: its radius of curvature is h + h''."""
    t = 2 * np.pi * np.arange(24) / 24
    k = np.arange(2, 5)[:, None]
    while True:
        amplitude, phase = rng.normal(0, 0.4, (3, 1)) / (k ** 2 - 1), rng.uniform(0, 2 * np.pi, (3, 1))
        size = rng.uniform(0.7, 1.4)
        h = size * (1 + np.sum(amplitude * np.cos(k * t + phase), axis=0))
        slope = -size * np.sum(amplitude * k * np.sin(k * t + phase), axis=0)
        radius = size * (1 - np.sum(amplitude * (k ** 2 - 1) * np.cos(k * t + phase), axis=0))
        if RADII[0] <= radius.min() and radius.max() <= RADII[1]:
            return {"points": h * np.exp(1j * t) + 1j * slope * np.exp(1j * t)}


def polygon(rng):
    """Corners on an ellipse, 3 to 7."""
    count = rng.integers(3, 8)
    while True:
        angles = np.sort(rng.uniform(0, 2 * np.pi, count))
        gaps = np.diff(angles, append=angles[0] + 2 * np.pi)
        if gaps.min() > 2 / count and gaps.max() < 2.6:
            points = rng.uniform(0.9, 1.8) * np.cos(angles) + 1j * rng.uniform(0.9, 1.8) * np.sin(angles)
            return {"points": points, "corner_radius": rng.uniform(0.15, 0.35)}


MAKERS = {"ellipse": ellipse, "rounded-rectangle": rounded_rectangle, "curve": curve, "polygon": polygon}


def shape_settings(rng, shape, prefix):
    values = {"shape": shape, **MAKERS[shape](rng)}
    centre = rng.uniform(-1, 1, 2)
    angle = rng.uniform(-180, 180)
    if "points" in values:
        points = values["points"] * np.exp(1j * np.radians(angle)) + centre[0] + 1j * centre[1]
        values["points"] = ", ".join(f"{p.real:.6f} {p.imag:.6f}" for p in points)
    else:
        values.update(angle=angle, x=centre[0], y=centre[1])
    return [f"{prefix}.{key}={value}" for key, value in values.items()]


def density_settings(rng, density, prefix):
    contrast = rng.uniform(2, 20)
    values = {"constant": {}, "ring": {"amplitude": contrast - 1}, "bell": {"amplitude": contrast - 1},
              "random-waves": {"contrast": contrast, "seed": rng.integers(1000)},
              "random-bells": {"amplitude": (contrast - 1) / 2, "count": rng.integers(2, 7),
                               "seed": rng.integers(1000)}}[density]
    return [f"{prefix}.{key}={value}" for key, value in {"type": density, **values}.items()]


def run(gaspard, settings, folder):
    command = [gaspard, "run", "transport-ring", "--out", str(folder), "--overwrite", "--no-render"]
    for setting in settings:
        command += ["--set", setting]
    done = subprocess.run(command, capture_output=True, text=True)
    summary = folder / "summary.json"
    if done.returncode == 2 or not summary.exists():
        return {"refused": done.stderr.strip(), "code": done.returncode}
    result = json.loads(summary.read_text())
    summary.unlink()
    return {**result, **result["measures"]}


def pair(rng, index):
    """Shapes and densities take turns, so that each combination of shapes is there."""
    source, target = SHAPES[index % 4], SHAPES[index // 4 % 4]
    on_source, on_target = rng.choice(DENSITIES, 2)
    settings = shape_settings(rng, source, "domain") + shape_settings(rng, target, "domain.target")
    settings += density_settings(rng, on_target, "monitor") + density_settings(rng, on_source, "monitor.source")
    return f"{source}, {on_source} to {target}, {on_target}", settings


def reason(result):
    if "refused" in result:
        return result["refused"]
    parts = [result["status"], f"{result['iterations']} iterations", f"residual {result['residual']:.1e}"]
    parts += [f"{key} {result[key]:.3g}" for key in ("tangled_cells", "convexity") if result.get(key) is not None]
    return ", ".join(parts)


def solved(result):
    """To a convex solution, whether or not the mesh resolves its map."""
    return "refused" not in result and result["residual"] <= TOLERANCE and result["convexity"] > 0


def unfolded(result):
    return solved(result) and result["tangled_cells"] == 0


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("gaspard")
    parser.add_argument("--pairs", type=int, default=40)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--degrees", default="1,2")
    parser.add_argument("--set", action="append", default=[])
    parser.add_argument("--verbose", action="store_true")
    options = parser.parse_args()
    pairs = [pair(np.random.default_rng([options.seed, index]), index) for index in range(options.pairs)]
    failures, failed = [], 0
    print("| degree | converged | without folded cells | iterations | seconds |")
    print("| --- | --- | --- | --- | --- |")
    with tempfile.TemporaryDirectory() as name:
        for degree in map(int, options.degrees.split(",")):
            results = []
            for index, (title, settings) in enumerate(pairs):
                settings = ["domain.cells=32", f"domain.degree={degree}", f"method.tolerance={TOLERANCE}", *settings,
                            *options.set]
                results.append(run(options.gaspard, settings, Path(name) / "run"))
                if not unfolded(results[-1]):
                    failures.append((degree, index, title, reason(results[-1])))
                if options.verbose:
                    print(degree, index, title, reason(results[-1]), *settings, sep=" | ", file=sys.stderr, flush=True)
            done = [r for r in results if solved(r)]
            failed += len(results) - len(done)
            iterations = sorted(r["iterations"] for r in done)
            seconds = sorted(r["solve_seconds"] for r in done)
            print(f"| {degree} | {len(done)} of {len(results)} | {sum(map(unfolded, done))} | {iterations[0]} to {iterations[-1]}, median "
                  f"{iterations[len(done) // 2]} | {seconds[0]:.1f} to {seconds[-1]:.1f} |", flush=True)
    if failures:
        print("\n| degree | pair | shapes and densities | result |\n| --- | --- | --- | --- |")
    for degree, index, title, why in failures:
        print(f"| {degree} | {index} | {title} | {why} |")
    sys.exit(1 if failed else 0)


if __name__ == "__main__":
    main()
