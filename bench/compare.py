#!/usr/bin/env python3
"""Compare Gaspard with FEniCS on the same work; prints the table of the README.

usage: compare.py GASPARD [--repeat R] [--quick]

The work is McRae's relaxation on the doubly periodic unit square, starting from the uniform mesh. The FEniCS program is
peers/mcrae_plane_fenics.py in its fastest variant: operators assembled once, one Cholesky factorisation of the
Laplacian, P2 on triangles. Both run on one thread. Times are CPU seconds of the iteration, the minimum of R alternating
runs; set-up times are listed separately. Gaspard measures its mesh as often as it does by default.
"""
import argparse, datetime, json, os, platform, subprocess, tempfile

PYTHON = "/usr/bin/python3"  # Debian's, which its FEniCS requires
HERE = os.path.dirname(os.path.abspath(__file__))
ENVIRONMENT = dict(os.environ, OMP_NUM_THREADS="1", OPENBLAS_NUM_THREADS="1")


def peer(monitor, n, tolerance):
    command = [PYTHON, os.path.join(HERE, "peers", "mcrae_plane_fenics.py"), str(n), "--monitor", monitor,
               "--tol", str(tolerance), "--poisson", "petsc", "--mrtol", "1e-1"]
    done = subprocess.run(command, env=ENVIRONMENT, capture_output=True, text=True, check=True)
    out = json.loads(done.stdout.strip().splitlines()[-1])
    return {"cpu": out["cpu_s"], "iterations": out["iterations"], "setup": out["setup_cpu_s"]}


def gaspard(program, monitor, n, tolerance, settings):
    with tempfile.TemporaryDirectory() as folder:
        command = [program, "run", "plane-" + monitor, "--threads", "1", "--no-render", "--quiet", "--out", folder,
                   "--formats", "obj", "--tolerance", str(tolerance), "--set", "domain.cells=%d" % n]
        for setting in settings:
            command += ["--set", setting]
        subprocess.run(command, check=True, env=ENVIRONMENT)
        with open(os.path.join(folder, "summary.json")) as file:
            out = json.load(file)
    return {"cpu": out["cpu_seconds"], "iterations": out["iterations"], "setup": out["setup_seconds"]}


def least(runs):
    return min(runs, key=lambda run: run["cpu"])


def first_line(command):
    try:
        return subprocess.run(command, capture_output=True, text=True).stdout.strip().splitlines()[0]
    except (OSError, IndexError):
        return "?"


def describe(program):
    cpu = next((line.split(":")[1].strip() for line in open("/proc/cpuinfo") if line.startswith("model name")), "?")
    dolfin = first_line(["dpkg-query", "-W", "-f", "${Version}", "python3-dolfin"])
    petsc = first_line([PYTHON, "-c", "import petsc4py.PETSc as p; print('.'.join(map(str, p.Sys.getVersion())))"])
    print("Measured on %s: %s, %d cores, Linux %s; %s (%s); FEniCS %s, PETSc %s." % (
        datetime.date.today().isoformat(), cpu, os.cpu_count(), platform.release(),
        first_line([program, "--version"]), first_line(["c++", "--version"]), dolfin, petsc))


# Variants of Gaspard: the peer's iteration, the same with its own step size, and its other methods.
WAYS = {"same step": [], "`step_size=auto`": ["method.step_size=auto"]}
WAYS.update({"`%s`" % method: ["method.type=" + method] for method in ("accelerated", "newton", "auto")})


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("gaspard")
    parser.add_argument("--repeat", type=int, default=3)
    parser.add_argument("--quick", action="store_true", help="n = 60 and the ring only")
    options = parser.parse_args()
    cases = [("ring", 60, 1e-8), ("ring", 60, 1e-2)]
    if not options.quick:
        cases += [("ring", 120, 1e-8), ("ring", 120, 1e-2), ("bell", 60, 1e-8), ("bell", 60, 1e-2)]
    peer("ring", 8, 1e-2)  # compiles the forms
    each, solves = [], []
    for monitor, n, tolerance in cases:
        runs = {name: [] for name in ["peer", *WAYS]}
        for _ in range(options.repeat):
            runs["peer"].append(peer(monitor, n, tolerance))
            for name, settings in WAYS.items():
                runs[name].append(gaspard(options.gaspard, monitor, n, tolerance, settings))
        best = {name: least(list_of) for name, list_of in runs.items()}
        if tolerance == 1e-8 and monitor == "ring":
            theirs, ours = (1e3 * best[k]["cpu"] / best[k]["iterations"] for k in ("peer", "same step"))
            each.append("| %s, n = %d | %.2f | %.3f | %.1f | %.2f | %.3f |" % (
                monitor, n, theirs, ours, theirs / ours, best["peer"]["setup"], best["same step"]["setup"]))
        cells = ["%s, n = %d, to %g" % (monitor, n, tolerance)]
        for name in ["peer", *WAYS]:
            one = best[name]
            ratio = "" if name == "peer" else " **%.0fx**" % (best["peer"]["cpu"] / one["cpu"])
            cells.append("%.1f ms (%d)%s" % (1e3 * one["cpu"], one["iterations"], ratio))
        solves.append("| " + " | ".join(cells) + " |")
    describe(options.gaspard)
    print("\nOne iteration of the relaxation, milliseconds of CPU, and set-up, seconds:\n")
    print("| | FEniCS | Gaspard | ratio | set-up FEniCS | set-up Gaspard |")
    print("| --- | --- | --- | --- | --- | --- |")
    print("\n".join(each))
    print("\nWhole solves from the uniform mesh (iterations), and speed-up:\n")
    print("| | FEniCS | " + " | ".join(WAYS) + " |")
    print("| --- | --- |" + " --- |" * len(WAYS))
    print("\n".join(solves))


if __name__ == "__main__":
    main()
