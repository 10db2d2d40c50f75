#!/usr/bin/env python3
"""Meshes that follow a monitor in time: cost of a time step beside a cold solve, and equidistribution beside that of
meshes solved to 1e-8 in every step.

usage: bench/following.py PATH_TO_gaspard [--repeat R] [--rules]

Each case is run R times (default 3); times are the smallest, on as many threads as the program uses. --rules compares the
rules of docs/time.md instead.
"""
import argparse
import csv
import os
import subprocess
import tempfile

RING = ["plane-ring", "time.monitor.center_x=center_x + 0.1*t", "time.end=1"]
CASES = [
    ("ring, n = 60, newton", RING + ["method.type=newton", "domain.cells=60", "time.step=0.01"]),
    ("ring, n = 60, auto", RING + ["method.type=auto", "domain.cells=60", "time.step=0.01"]),
    ("ring, n = 120, newton", RING + ["method.type=newton", "domain.cells=120", "time.step=0.01"]),
    ("ring, n = 120, auto", RING + ["method.type=auto", "domain.cells=120", "time.step=0.01"]),
    ("ring, n = 120, newton, step 0.02", RING + ["method.type=newton", "domain.cells=120", "time.step=0.02"]),
    ("ring, n = 120, auto, step 0.02", RING + ["method.type=auto", "domain.cells=120", "time.step=0.02"]),
    ("cross, icosahedral 4, newton", ["sphere-rotating-cross", "method.type=newton", "time.end=0.5", "time.step=0.01"]),
    ("flow, n = 60, newton", ["flow-live", "method.type=newton", "time.end=2", "time.step=0.02"]),
]
FOLLOWED = RING[:2] + ["method.type=newton", "domain.cells=60", "time.step=0.02", "time.end=2"]
RULES = [
    ("tolerance 1e-8", ["time.rule=tolerance"]),
    ("equidistribution, factor 1.05", []),
    ("equidistribution, factor 1.5", ["time.factor=1.5"]),
    ("equidistribution, no extrapolation", ["time.extrapolation=none"]),
    ("one iteration", ["time.rule=iterations", "time.iterations=1"]),
    ("relaxation, tau = 0.02", ["time.rule=relaxation", "time.tau=0.02"]),
    ("relaxation, tau = 0.05", ["time.rule=relaxation", "time.tau=0.05"]),
    ("relaxation, tau = 0.1", ["time.rule=relaxation", "time.tau=0.1"]),
]


def history(program, case, further, every):
    """The rows of the history: those before the time passes, and the time steps."""
    scenario, *settings = case
    settings = [*settings, *further, f"method.diagnostics_every={every}"]
    with tempfile.TemporaryDirectory() as folder:
        out = os.path.join(folder, "out")
        command = [program, "run", scenario, "--out", out, "--quiet"]
        for setting in settings:
            command += ["--set", setting]
        done = subprocess.run(command, capture_output=True, text=True)
        if done.returncode not in (0, 3):
            raise SystemExit(done.stderr)
        with open(os.path.join(out, "history.csv"), newline="") as file:
            rows = list(csv.DictReader(file))
    steps = [row for row in rows if row["step_iterations"]]
    return rows[: len(rows) - len(steps)], steps


def seconds(program, case, further, repeat):
    """Of the cold solve, of the mesh in a time step, and to make the monitor of that time."""
    cold, step, monitor = [], [], []
    for _ in range(repeat):
        before, steps = history(program, case, further, 1000)
        begin = float(before[-1]["seconds"])
        cold.append(begin)
        monitor.append(sum(column(steps, "monitor_seconds")) / len(steps))
        step.append((float(steps[-1]["seconds"]) - begin) / len(steps) - monitor[-1])
    return min(cold), min(step), min(monitor)


def trajectories(program, case, further):
    """For each time of the film: the coordinates of 400 nodes."""
    scenario, *settings = case
    with tempfile.TemporaryDirectory() as folder:
        command = [program, "record", scenario, "--formats", "csv", "--out", os.path.join(folder, "out"), "--quiet"]
        for setting in settings + further:
            command += ["--set", setting]
        done = subprocess.run(command, capture_output=True, text=True)
        if done.returncode not in (0, 3):
            raise SystemExit(done.stderr)
        times = {}
        with open(os.path.join(folder, "out", "trajectories.csv"), newline="") as file:
            for row in csv.DictReader(file):
                times.setdefault(float(row["time"]), []).extend((float(row["x"]), float(row["y"])))
    return times


def lag(followed, solved):
    """The delay d for which x(t) is nearest to the solved x(t - d), in the second half of the time."""
    times = sorted(solved)
    step = times[1] - times[0]

    def distance(delay):
        total = 0
        for t in times[len(times) // 2:]:
            at = (t - delay - times[0]) / step
            i = min(max(int(at), 0), len(times) - 2)
            total += sum((c - a - (at - i) * (b - a)) ** 2
                         for a, b, c in zip(solved[times[i]], solved[times[i + 1]], followed[t]))
        return total

    delays = [k * step / 10 for k in range(-10, 101)]
    return min(delays, key=distance)


def column(rows, name):
    return [float(row[name]) for row in rows]


def ratios(steps, solved):
    return [a / b for a, b in zip(column(steps, "equidistribution"), column(solved, "equidistribution"))]


def print_cases(program, repeat):
    print("| case | cold solve, ms | mesh of a time step, ms | ratio | its monitor, ms | iterations a step | largest e / e solved | tangled |")
    print("| --- | --- | --- | --- | --- | --- | --- | --- |")
    for name, case in CASES:
        cold, step, monitor = seconds(program, case, [], repeat)
        _, solved = history(program, case, ["time.rule=tolerance"], 1)
        _, steps = history(program, case, [], 1)
        iterations = sum(column(steps, "step_iterations")) / len(steps)
        tangled = sum(column(steps, "tangled_cells"))
        print(f"| {name} | {1e3 * cold:.1f} | {1e3 * step:.2f} | {cold / step:.1f} | {1e3 * monitor:.2f} | {iterations:.2f} | "
              f"{max(ratios(steps, solved)):.3f} | {tangled:.0f} |", flush=True)


def print_rules(program, repeat):
    _, solved = history(program, FOLLOWED, ["time.rule=tolerance"], 1)
    solved_nodes = trajectories(program, FOLLOWED, ["time.rule=tolerance"])
    print("| rule | time step, ms | lag | e / e solved, mean | largest | speed of the mesh | its largest jump |")
    print("| --- | --- | --- | --- | --- | --- | --- |")
    for name, further in RULES:
        _, step, _ = seconds(program, FOLLOWED, further, repeat)
        _, steps = history(program, FOLLOWED, further, 1)
        e = ratios(steps, solved)
        speed = column(steps, "mesh_speed")[len(steps) // 2:]
        jump = max(abs(b - a) for a, b in zip(speed, speed[1:]))
        behind = lag(trajectories(program, FOLLOWED, further), solved_nodes)
        print(f"| {name} | {1e3 * step:.2f} | {behind:.3f} | {sum(e) / len(e):.3f} | {max(e):.3f} | {sum(speed) / len(speed):.4f} | "
              f"{jump:.4f} |", flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("program")
    parser.add_argument("--repeat", type=int, default=3)
    parser.add_argument("--rules", action="store_true")
    arguments = parser.parse_args()
    if arguments.rules:
        print_rules(arguments.program, arguments.repeat)
    else:
        print_cases(arguments.program, arguments.repeat)


if __name__ == "__main__":
    main()
