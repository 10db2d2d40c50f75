#!/usr/bin/env python3
"""Every method on a table of monitors from easy to harsh; prints markdown for docs/newton.md.

usage: newton.py GASPARD [--part plane|sphere|all] [--cells 30,60,120] [--methods ...] [--limit SECONDS]

Iterations, inner iterations of the linear solver, CPU seconds of the iteration on one thread, status, and tangled
cells where there are any. A run that needs more than the limit is cut off and says so.
"""
import argparse, json, os, subprocess, tempfile

METHODS = ["relaxation", "accelerated", "quasi-newton", "newton", "auto"]
PLANE = [
    ("ring", "plane-ring", []),
    ("bell", "plane-bell", []),
    ("bell, A = 500", "plane-bell", ["monitor.amplitude=500"]),
    ("bell, A = 5000", "plane-bell", ["monitor.amplitude=5000"]),
    ("ring, A = 200", "plane-ring", ["monitor.amplitude=200"]),
    ("ring, A = 1000", "plane-ring", ["monitor.amplitude=1000"]),
    ("8 random bells", "plane-bell", ["monitor.type=random-bells", "monitor.seed=1"]),
    ("ring + bell", "plane-ring", ["monitor.type=ring-and-bell", "monitor.bell_center_x=0.2", "monitor.bell_center_y=0.3"]),
]
SPHERE = [("X%d, 6 x %d^2" % (x, k), "sphere-x16", ["monitor.ratio=%d" % x, "domain.cells=%d" % k])
          for k in (16, 32) for x in (2, 4, 8, 16, 32)]
SPHERE += [("cross, icosahedral %d" % r, "sphere-cross", ["domain.refinements=%d" % r]) for r in (3, 4, 5)]


def run(program, scenario, settings, method, limit):
    with tempfile.TemporaryDirectory() as folder:
        command = [program, "run", scenario, "--threads", "1", "--no-render", "--quiet", "--out", folder, "--formats",
                   "obj", "--max-iterations", "5000"]
        chosen = ["method.type=" + method, "method.diagnostics_every=1000"]
        if method == "relaxation":
            chosen.append("method.step_size=auto")
        for setting in settings + chosen:
            command += ["--set", setting]
        try:
            done = subprocess.run(command, capture_output=True, text=True, timeout=limit)
        except subprocess.TimeoutExpired:
            return None
        if done.returncode in (1, 2):
            raise SystemExit(done.stderr)
        with open(os.path.join(folder, "summary.json")) as file:
            return json.load(file)


def cell(out, limit):
    if out is None:
        return "over %d s" % limit
    text = str(out["iterations"])
    if out["inner_iterations"]:
        text += " (%d)" % out["inner_iterations"]
    text += ", %.3g s" % out["cpu_seconds"]
    if out["status"] != "converged":
        text += ", " + out["status"]
        if out["tangled_cells"]:
            text += " (%d)" % out["tangled_cells"]
        if out["residual"] > 1e-8:
            text += " at %.0e" % out["residual"]
    return text


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("gaspard")
    parser.add_argument("--part", default="all", choices=["plane", "sphere", "all"])
    parser.add_argument("--cells", default="30,60,120")
    parser.add_argument("--methods", default=",".join(METHODS))
    parser.add_argument("--limit", type=float, default=60)
    parser.add_argument("--only", default="", help="cases whose name contains this")
    options = parser.parse_args()
    methods = options.methods.split(",")
    cases = []
    if options.part != "sphere":
        for n in options.cells.split(","):
            cases += [("%s, n = %s" % (name, n), scenario, settings + ["domain.cells=" + n])
                      for name, scenario, settings in PLANE]
    if options.part != "plane":
        cases += SPHERE
    print("| | " + " | ".join(methods) + " |")
    print("| --- |" + " --- |" * len(methods))
    for name, scenario, settings in cases:
        if options.only in name:
            cells = [cell(run(options.gaspard, scenario, settings, m, options.limit), options.limit) for m in methods]
            print("| %s | %s |" % (name, " | ".join(cells)), flush=True)


if __name__ == "__main__":
    main()
