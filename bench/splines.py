#!/usr/bin/env python3
"""CPU time per spline Picard iteration, Gaspard and numpy, on one thread, and its growth with n.

usage: bench/splines.py PATH_TO_bench_splines"""
import os
import subprocess
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
NAMES = {"std": "standard", "mix": "mixed", "std3": "standard, cube", "mix3": "mixed, cube"}
ONE_THREAD = dict(os.environ, OMP_NUM_THREADS="1", OPENBLAS_NUM_THREADS="1")


def milliseconds(command):
    lines = subprocess.run(command, check=True, capture_output=True, text=True, env=ONE_THREAD).stdout.splitlines()
    rows = (line.split() for line in lines)
    return {(form, int(p), int(n)): float(ms) for form, p, n, ms in rows}


def main():
    ours = milliseconds([sys.argv[1]])
    peer = {}
    for script in ("timing.py", "timing_solid.py"):
        peer |= milliseconds([sys.executable, os.path.join(HERE, "peers", "bahari_numpy", script)])
    again = milliseconds([sys.argv[1]])
    print("CPU milliseconds per Picard iteration, one thread: circle of example 5.3 in the square, known solution in the cube")
    print(f"{'form':<14} {'p':>2} {'n':>4} {'Gaspard':>9} {'numpy':>9} {'speed-up':>11} {'growth from n/2':>16}")
    for key in ours:
        form, p, n = key
        best = min(ours[key], again[key])
        below = min(ours.get((form, p, n // 2), 0), again.get((form, p, n // 2), 0))
        print(f"{NAMES[form]:<14} {p:>2} {n:>4} {best:>9.3f} "
              + (f"{peer[key]:>9.3f} {peer[key] / best:>11.1f}" if key in peer else f"{'':>9} {'':>11}")
              + (f" {best / below:>16.1f}" if below else ""))
    print("Expected growth: 8 for fast diagonalisation, 4 for quadrature; in the cube 16 and 8.")
    print(subprocess.run([sys.argv[1], "threads"], check=True, capture_output=True, text=True).stdout, end="")


if __name__ == "__main__":
    main()
