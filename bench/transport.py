#!/usr/bin/env python3
"""CPU time of the nonvariational finite element method from the unit disk to an ellipse, Gaspard and FEniCS, on one
thread, in one run: degree 1 with gradient recovery, Newton's method from u = |x|^2/2 to a residual of 1e-10.

usage: bench/transport.py PATH_TO_bench_transport [--repeat R] [--quick]

Both sides run alternately, R times (default 3); the table prints medians. Times are those of everything from the mesh
to the solution, but FEniCS compiles its forms before; MUMPS factorises its systems. --quick leaves out the peer on
n = 64. The last row is Gaspard alone.
"""
import argparse
import json
import os
import statistics
import subprocess

PEER = os.path.join(os.path.dirname(os.path.abspath(__file__)), "peers", "kawecki_nvfem_fenics.py")
ONE_THREAD = dict(os.environ, OMP_NUM_THREADS="1", OPENBLAS_NUM_THREADS="1")


def peak_and_output(command):
    """The peak memory of a process in bytes, and its output."""
    with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True, env=ONE_THREAD) as child:
        output = child.stdout.read()
        _, status, usage = os.wait4(child.pid, 0)
        child.returncode = os.waitstatus_to_exitcode(status)
    if child.returncode:
        raise SystemExit(f"{' '.join(command)} failed")
    return 1024 * usage.ru_maxrss, output


def ours(program, rings):
    peak, output = peak_and_output([program, str(rings), "1"])
    seconds, steps, inner, error = output.split()
    return dict(cpu_s=float(seconds), peak=peak, steps=int(steps), inner=int(inner), error=float(error))


def peer(rings):
    python = "/usr/bin/python3"  # the one that has Debian's dolfin
    peak, output = peak_and_output([python, PEER, str(rings)])
    found = json.loads(output.splitlines()[-1])
    return dict(cpu_s=found["cpu_s"], peak=peak, steps=found["steps"], error=found["l2_error"])


def row(program, rings, repeat, with_peer=True):
    mine, theirs = [], []
    for _ in range(repeat):
        if with_peer:
            theirs.append(peer(rings))
        mine.append(ours(program, rings))
    seconds = statistics.median(one["cpu_s"] for one in mine)
    unknowns = 6 * (1 + 3 * rings * (rings + 1)) + 1
    text = f"{rings:>4} {unknowns:>9} {mine[0]['error']:>10.3e} {seconds:>10.3f} {mine[0]['steps']:>6}" \
           f" {mine[0]['inner']:>6} {mine[0]['peak'] / 2 ** 20:>8.0f}"
    if with_peer:
        fenics = statistics.median(one["cpu_s"] for one in theirs)
        text += f" {fenics:>10.3f} {theirs[0]['steps']:>6} {theirs[0]['peak'] / 2 ** 20:>8.0f}" \
                f" {theirs[0]['error']:>10.3e} {fenics / seconds:>7.1f}"
    print(text, flush=True)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("program")
    parser.add_argument("--repeat", type=int, default=3)
    parser.add_argument("--quick", action="store_true")
    choice = parser.parse_args()
    peer(2)  # compiles the forms
    print("Transport from the disk to an ellipse, CPU s; inner: most iterations in a step")
    print(f"{'':>4} {'':>9} {'Gaspard':>10} {'':>10} {'':>6} {'':>6} {'':>8} {'FEniCS':>10}")
    print(f"{'n':>4} {'unknowns':>9} {'L2 error':>10} {'CPU s':>10} {'steps':>6} {'inner':>6} {'MiB':>8} {'CPU s':>10}"
          f" {'steps':>6} {'MiB':>8} {'L2 error':>10} {'ratio':>7}")
    row(choice.program, 32, choice.repeat)
    row(choice.program, 64, choice.repeat, not choice.quick)
    row(choice.program, 128, choice.repeat, False)


if __name__ == "__main__":
    main()
