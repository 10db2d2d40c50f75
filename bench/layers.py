#!/usr/bin/env python3
"""CPU time to generate layer-adapted meshes, Gaspard and FEniCS, on one thread, in one run.

usage: bench/layers.py PATH_TO_bench_layers [--repeat R] [--quick]

Both sides run alternately, R times (default 3) with several repetitions each; the tables print medians. --quick leaves
out N = 512 and the peer on N = 128. The peer compiles its forms first, which is not counted. In two dimensions it is
measured in four variants: densities at the corners or of degree 4, and the linear systems solved by MUMPS or by
conjugate gradients with algebraic multigrid; the fastest one counts.
"""
import argparse
import json
import os
import statistics
import subprocess

PEERS = os.path.join(os.path.dirname(os.path.abspath(__file__)), "peers")
ONE_THREAD = dict(os.environ, OMP_NUM_THREADS="1", OPENBLAS_NUM_THREADS="1")
VARIANTS = {"corners": "vertex", "degree-4": "p4"}


def output(command):
    return subprocess.run(command, check=True, capture_output=True, text=True, env=ONE_THREAD).stdout


def ours(program, mesh, eps, cells, repeats=5):
    return [float(word) for word in output([program, mesh, str(eps), str(cells), str(repeats)]).split()]


def peer(script, eps, cells, *options):
    python = "/usr/bin/python3"  # the one that has Debian's dolfin
    line = output([python, os.path.join(PEERS, script), str(eps), str(cells), *options]).splitlines()[-1]
    return json.loads(line)["mesh_cpu_s"]


def row(name, gaspard, fenics=None, note=""):
    left = f"{name:<34} {1e3 * gaspard:>12.3f}"
    print(left + (f" {1e3 * fenics:>12.1f} {fenics / gaspard:>8.1f}" if fenics else "") + note, flush=True)


def interval(program, repeat):
    mine, theirs = [], []
    for _ in range(repeat):
        theirs.append(peer("hill_madden_1d_fenics.py", 1e-8, 1024))
        mine += ours(program, "interval", 1e-8, 1024, 51)
    row("interval, eps = 1e-8, N = 1024", statistics.median(mine), statistics.median(theirs))


def square(program, repeat, cells):
    mine = {mesh: [] for mesh in VARIANTS}
    theirs = {(mesh, solver): [] for mesh in VARIANTS for solver in ("mumps", "cg")}
    for _ in range(repeat):
        for (mesh, solver), seconds in theirs.items():
            seconds.append(peer("hill_madden_2d_fenics.py", 1e-3, cells, "--noerr", "--rho", VARIANTS[mesh],
                                "--solver", solver))
        for mesh, seconds in mine.items():
            seconds += ours(program, mesh, 1e-3, cells)
    for mesh, seconds in mine.items():
        solver, fastest = min(((solver, statistics.median(theirs[mesh, solver])) for solver in ("mumps", "cg")),
                              key=lambda pair: pair[1])
        row(f"square, N = {cells}, {mesh}", statistics.median(seconds), fastest, f"  ({solver})")


def growth(program, repeat, title, cases):
    """Time per node relative to the smallest; cases: (label, eps, cells)."""
    seconds = {case: [] for case in cases}
    for _ in range(repeat):
        for label, eps, cells in cases:
            seconds[label, eps, cells] += ours(program, "degree-4", eps, cells, 3)
    per_node = {case: 1e6 * statistics.median(found) / (case[2] + 1) ** 2 for case, found in seconds.items()}
    print(f"\n{title}: microseconds per node, relative to the least, seconds")
    for case, value in per_node.items():
        print(f"{case[0]:<34} {value:>12.3f} {value / min(per_node.values()):>8.2f}"
              f" {statistics.median(seconds[case]):>10.3f}")


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("program")
    parser.add_argument("--repeat", type=int, default=3)
    parser.add_argument("--quick", action="store_true")
    choice = parser.parse_args()
    peer("hill_madden_1d_fenics.py", 1e-8, 8, "--repeat", "1")
    print(f"{'Mesh generation, CPU ms':<34} {'Gaspard':>12} {'FEniCS':>12} {'ratio':>8}")
    interval(choice.program, choice.repeat)
    for cells in (64,) if choice.quick else (64, 128):
        square(choice.program, choice.repeat, cells)
    growth(choice.program, choice.repeat, "Square, N = 128, for smaller eps",
           [(f"eps = {eps:.0e}", eps, 128) for eps in (1e-2, 1e-4, 1e-6, 1e-8)])
    growth(choice.program, choice.repeat, "Square, eps = 1e-3, for larger N",
           [(f"N = {cells}", 1e-3, cells) for cells in ((64, 128, 256) if choice.quick else (64, 128, 256, 512))])


if __name__ == "__main__":
    main()
