#!/usr/bin/env python3
"""Does `auto` follow any picture? Makes 40 seeded pictures (noise at three scales, textures like those of photographs,
text, step edges), runs `gaspard run` with the monitor `image` on the periodic plane, on the plane with walls and on
the sphere, and prints a table in Markdown: how many of the runs of each kind converged to 1e-6 without a tangled cell,
their iterations and times. Usage: images.py GASPARD [--cells 60,120] [--set KEY=VALUE ...] [--only KIND]
[--domains plane,walls,sphere] [--every N]. Needs numpy. Exits with 1 if a run has not converged."""
import argparse
import json
import subprocess
import sys
import tempfile
import zlib
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "assets" / "pictures"))
from make_pictures import write_png  # noqa: E402

SIZE = 512


def field(rng, exponent, low=0.0):
    """Periodic noise whose spectrum falls with a power of the wave number, scaled to 0 .. 1."""
    k = np.hypot(*np.meshgrid(np.fft.fftfreq(SIZE) * SIZE, np.fft.fftfreq(SIZE) * SIZE))
    k[0, 0] = 1
    spectrum = np.where(k >= low, k ** -exponent, 0) * np.exp(2j * np.pi * rng.random((SIZE, SIZE)))
    spectrum[0, 0] = 0
    f = np.fft.ifft2(spectrum).real
    low_end, high_end = np.quantile(f, (0.01, 0.99))
    return np.clip((f - low_end) / (high_end - low_end), 0, 1)


def band(rng, wave):
    k = np.hypot(*np.meshgrid(np.fft.fftfreq(SIZE) * SIZE, np.fft.fftfreq(SIZE) * SIZE))
    f = np.fft.ifft2(np.exp(-((k - wave) / (0.3 * wave)) ** 2) * np.exp(2j * np.pi * rng.random((SIZE, SIZE)))).real
    return np.clip(0.5 + f / (4 * f.std()), 0, 1)


def noise(rng, index):
    """Waves over the picture: 4, 16, 64; the last picture is white noise, pixel by pixel."""
    return rng.random((SIZE, SIZE)) if index == 9 else band(rng, (4, 16, 64)[index % 3])


def photograph(rng, index):
    """Natural textures have spectra near 1/k; on them regions with sharp borders and a gradient of light."""
    picture = 0.6 * field(rng, 1.0 + 0.1 * index)
    for _ in range(4):
        region = field(rng, 2.0) > rng.uniform(0.4, 0.7)
        picture[region] = 0.5 * picture[region] + rng.uniform(0, 0.6)
    y, x = np.mgrid[0:SIZE, 0:SIZE] / SIZE
    return np.clip(picture * (0.6 + 0.4 * (x * rng.uniform(-1, 1) + y * rng.uniform(-1, 1))), 0, 1)


# Letters of 5 x 7 dots.
LETTERS = {"A": "0E11111F111111", "D": "1E11111111111E", "E": "1F10101E10101F", "G": "0E11101713110F",
           "M": "111B1515111111", "P": "1E11111E101010", "R": "1E11111E141211", "S": "0F10100E01011E",
           "T": "1F040404040404", "X": "11110A040A1111"}


def text(rng, index):
    """Rows of black letters on white; the sizes go from three rows to twenty."""
    dots = max(2, SIZE // 8 // (3 + 2 * index))
    page = np.ones((SIZE, SIZE))
    for top in range(dots, SIZE - 8 * dots, 10 * dots):
        for left in range(dots, SIZE - 6 * dots, 6 * dots):
            code = LETTERS[rng.choice(list(LETTERS))]
            for row in range(7):
                bits = int(code[2 * row:2 * row + 2], 16)
                for column in range(5):
                    if bits >> (4 - column) & 1:
                        y, x = top + row * dots, left + column * dots
                        page[y:y + dots, x:x + dots] = 0
    return page


def edges(rng, index):
    """Black against white: half planes, disks, rings, checkerboards, polygons; nothing in between."""
    y, x = np.mgrid[0:SIZE, 0:SIZE] / SIZE - 0.5
    angle = rng.uniform(0, np.pi)
    u = x * np.cos(angle) + y * np.sin(angle)
    r = np.hypot(x - rng.uniform(-0.2, 0.2), y - rng.uniform(-0.2, 0.2))
    shapes = [u > rng.uniform(-0.2, 0.2), r < rng.uniform(0.1, 0.4), np.abs(r - 0.3) < 0.02, np.abs(u) < 0.01,
              (np.floor(8 * x) + np.floor(8 * y)) % 2 == 0, (np.floor(32 * x) + np.floor(32 * y)) % 2 == 0,
              r < 0.03, np.sin(40 * u) > 0, (np.abs(x) < 0.25) & (np.abs(y) < 0.25), r > 0.03]
    return np.where(shapes[index], 0.0, 1.0)


KINDS = {"noise": noise, "photograph": photograph, "text": text, "edges": edges}


def domain_settings(domain, cells):
    if domain == "sphere":  # as many cells: 6 (cells / sqrt 6)^2
        return "sphere-cross", ["domain.type=cubed-sphere", f"domain.cells={2 * round(cells / 6 ** 0.5 / 2)}"]
    return "plane-ring", [f"domain.cells={cells}", f"domain.boundary={'periodic' if domain == 'plane' else 'walls'}"]


def run(gaspard, picture, domain, cells, settings, folder):
    scenario, own = domain_settings(domain, cells)
    command = [gaspard, "run", scenario, "--out", str(folder), "--overwrite", "--no-render"]
    for setting in ["monitor.type=image", f"monitor.file={picture}", "method.type=auto", "method.tolerance=1e-6",
                    *own, *settings]:
        command += ["--set", setting]
    done = subprocess.run(command, capture_output=True, text=True)
    summary = folder / "summary.json"
    if done.returncode == 2 or not summary.exists():
        sys.exit(f"{' '.join(command)}\n{done.stdout}{done.stderr}")
    result = json.loads(summary.read_text())
    summary.unlink()
    return result


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("gaspard")
    parser.add_argument("--cells", default="60,120")
    parser.add_argument("--domains", default="plane,walls,sphere")
    parser.add_argument("--set", action="append", default=[])
    parser.add_argument("--only", choices=KINDS)
    parser.add_argument("--every", type=int, default=1, help="every so many of the ten pictures of a kind")
    options = parser.parse_args()
    failed = 0
    print("| pictures | domain | n | converged | iterations | seconds |")
    print("| --- | --- | --- | --- | --- | --- |")
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        for kind, make in KINDS.items():
            if options.only and kind != options.only:
                continue
            numbers = range(0, 10, options.every)
            pictures = []
            for index in numbers:
                rng = np.random.default_rng(zlib.crc32(f"{kind} {index}".encode()))
                pictures.append(folder / f"{kind}{index}.png")
                write_png(pictures[-1], make(rng, index))
            for domain in options.domains.split(","):
                for cells in map(int, options.cells.split(",")):
                    results = [run(options.gaspard, p, domain, cells, options.set, folder / "run") for p in pictures]
                    good = [r["status"] == "converged" and r["tangled_cells"] == 0 for r in results]
                    for p, r, ok in zip(pictures, results, good):
                        if not ok:
                            print(f"{p.stem} on the {domain}, n = {cells}: {r['status']}", file=sys.stderr)
                    failed += good.count(False)
                    iterations = [r["iterations"] for r in results]
                    seconds = [r["solve_seconds"] for r in results]
                    print(f"| {kind} | {domain} | {cells} | {sum(good)} of {len(good)} | {min(iterations)} to "
                          f"{max(iterations)} | {min(seconds):.1f} to {max(seconds):.1f} |", flush=True)
    sys.exit(1 if failed else 0)


if __name__ == "__main__":
    main()
