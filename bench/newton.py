#!/usr/bin/env python3
"""Run every method on monitors from mild to extreme; prints markdown for docs/newton.md.

usage: newton.py GASPARD [--part plane|sphere|all] [--cells 30,60,120] [--methods ...] [--limit SECONDS] [--repeat R]
       newton.py GASPARD --random 50 [--seed S]     success rate of each method on random monitors
       newton.py GASPARD --restrict                 can the meshes represent the rings of amplitude 200 and 1000?

The table lists iterations, inner iterations of the linear solver, CPU seconds of the iteration on one thread (minimum
of R runs, methods alternating), status, and the number of tangled cells if any; the last column is the time of auto
relative to the fastest method. A run that exceeds the CPU limit is stopped and marked.

--random N: N monitors of each of two kinds (bells, waves) on each of two domains (plane, sphere), none of which was
used for tuning. Success means a residual below 1e-8 and no tangled cells.
"""
import argparse, json, math, os, random, resource, subprocess, sys, tempfile

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
SPHERE += [("cross, icosahedral %d" % r, "sphere-cross", ["domain.refinements=%d" % r]) for r in (3, 4, 5, 6)]


def run(program, scenario, settings, method, limit):
    """The summary of a run with its mesh (xi, x, faces), or None if it was stopped."""
    with tempfile.TemporaryDirectory() as folder:
        command = [program, "run", scenario, "--threads", "1", "--no-render", "--quiet", "--out", folder, "--formats",
                   "obj"]
        chosen = ["method.type=" + method, "method.diagnostics_every=1000", "method.max_iterations=5000"]
        if method == "relaxation":
            chosen.append("method.step_size=auto")
        for setting in chosen + settings:
            command += ["--set", setting]
        seconds = math.ceil(limit)
        cut_off = lambda: resource.setrlimit(resource.RLIMIT_CPU, (seconds, seconds + 1))
        done = subprocess.run(command, capture_output=True, text=True, preexec_fn=cut_off)
        if done.returncode < 0:
            return None
        if done.returncode in (1, 2):
            raise SystemExit(done.stderr)
        with open(os.path.join(folder, "summary.json")) as file:
            out = json.load(file)
        out["xi"], out["faces"] = mesh(os.path.join(folder, "computational.obj"))
        out["x"], _ = mesh(os.path.join(folder, "adapted.obj"))
        return out


def mesh(path):
    """Vertices and faces of an OBJ file."""
    with open(path) as file:
        lines = [line.split() for line in file]
    return ([tuple(map(float, line[1:4])) for line in lines if line and line[0] == "v"],
            [[int(corner.split("/")[0]) - 1 for corner in line[1:]] for line in lines if line and line[0] == "f"])


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


def table(options, cases):
    methods = options.methods.split(",")
    print("| | " + " | ".join(methods) + " | auto / best |")
    print("| --- |" + " --- |" * (len(methods) + 1))
    ratios = []
    for name, scenario, settings in cases:
        if options.only not in name:
            continue
        best = {}
        for turn in range(options.repeat):
            for method in methods:
                if turn and (best[method] is None or best[method]["cpu_seconds"] > options.limit / 10):
                    continue  # hopeless, or long enough for an accurate time
                out = run(options.gaspard, scenario, settings, method, options.limit)
                if turn == 0 or out and out["cpu_seconds"] < best[method]["cpu_seconds"]:
                    best[method] = out
        solved = [out["cpu_seconds"] for out in best.values() if out and out["residual"] < 1e-8]
        ratio = ""
        if best.get("auto") and best["auto"]["residual"] < 1e-8:
            ratios.append(best["auto"]["cpu_seconds"] / min(solved))
            ratio = "%.2f" % ratios[-1]
        print("| %s | %s | %s |" % (name, " | ".join(cell(best[m], options.limit) for m in methods), ratio), flush=True)
    if ratios:
        print("\nauto within 1.5 times the best: %d of %d" % (sum(ratio <= 1.5 for ratio in ratios), len(ratios)))


def random_cases(count, seed):
    """Random monitors from Python's generator, which also seeds the monitors that use random numbers themselves."""
    draw = random.Random(seed)
    cases = []
    for domain in ("plane", "sphere"):
        for kind in ("random-bells", "random-waves"):
            for _ in range(count):
                contrast = math.exp(draw.uniform(math.log(2), math.log(1000)))
                settings = ["monitor.type=" + kind, "monitor.seed=%d" % draw.randrange(10**9)]
                if kind == "random-bells":
                    settings += ["monitor.amplitude=%.6g" % (contrast - 1), "monitor.count=%d" % draw.randint(1, 12)]
                    sharpness = math.exp(draw.uniform(math.log(20), math.log(100)))
                    settings.append("monitor.sharpness=%.6g" % (sharpness if domain == "plane" else sharpness / 13))
                else:
                    settings += ["monitor.contrast=%.6g" % contrast, "monitor.count=%d" % draw.randint(2, 10)]
                    settings.append("monitor.wave_number=%.6g" % (draw.uniform(1, 3) * (1 if domain == "plane" else 2)))
                cases.append((domain, kind, contrast, settings))
    return cases


def successes(options):
    methods = options.methods.split(",")
    limits = {"quasi-newton": 40}  # iterations: failing ones are slow, and the ring takes 32
    rates, failures = {}, []
    for domain, kind, contrast, settings in random_cases(options.random, options.seed):
        scenario, size = ("plane-ring", "30") if domain == "plane" else ("sphere-x2", "8")
        outs = {}
        for method in methods:
            limit = ["method.max_iterations=%d" % limits[method]] if method in limits else []
            outs[method] = run(options.gaspard, scenario, settings + ["domain.cells=" + size] + limit, method,
                               options.limit)
            good = outs[method] is not None and outs[method]["status"] == "converged"
            rates.setdefault((domain, kind), {}).setdefault(method, []).append(good)
            if not good and method == "auto":
                failures.append((domain, settings, outs[method]))
        print(domain, " ".join(settings), "|", " | ".join(cell(outs[m], options.limit) for m in methods), file=sys.stderr,
              flush=True)
    print("| | " + " | ".join(methods) + " |\n| --- |" + " --- |" * len(methods))
    for (domain, kind), of_method in rates.items():
        print("| %s, %s | %s |" % (domain, kind, " | ".join("%d of %d" % (sum(of_method[m]), len(of_method[m]))
                                                           for m in methods)))
    print("\nauto fails for:")
    for domain, settings, out in failures:
        print("- %s %s: %s" % (domain, " ".join(settings), cell(out, options.limit)))
        if options.carried:
            print("  " + carried(options, domain, settings, 30 if domain == "plane" else 8))


def tangled(vertices, faces, outward):
    """Faces with a reversed corner; outward(vertex) is the viewing direction."""
    count = 0
    for face in faces:
        corners = [vertices[i] for i in face]
        for k, here in enumerate(corners):
            u = [a - b for a, b in zip(here, corners[k - 1])]
            v = [a - b for a, b in zip(corners[(k + 1) % len(corners)], here)]
            normal = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]]
            if sum(a * b for a, b in zip(normal, outward(here))) <= 0:
                count += 1
                break
    return count


def carried(options, domain, settings, n):
    """Whether a mesh of n cells per side can represent the map: the solution at 2 n must converge without tangled cells,
    and its restriction to the vertices of the coarser mesh must not be tangled either."""
    scenario, outward = ("plane-ring", lambda x: (0, 0, 1)) if domain == "plane" else ("sphere-x2", lambda x: x)
    finer = run(options.gaspard, scenario, settings + ["domain.cells=%d" % (2 * n)], "auto", options.limit)
    text = "at twice the cells: " + cell(finer, options.limit)
    if finer:
        coarse = run(options.gaspard, scenario, settings + ["domain.cells=%d" % n, "method.max_iterations=0"], "auto",
                     options.limit)
        key = lambda xi: tuple(round(c, 9) + 0.0 for c in xi)
        goes_to = {key(xi): x for xi, x in zip(finer["xi"], finer["x"])}
        restricted = [goes_to[key(xi)] for xi in coarse["xi"]]
        assert tangled(coarse["xi"], coarse["faces"], outward) == 0
        text += "; restricted: %d tangled" % tangled(restricted, coarse["faces"], outward)
    return text


def restrict(options):
    for amplitude, sizes in ((200, (15, 30, 60)), (1000, (30, 60, 120))):
        for n in sizes:
            settings = ["monitor.amplitude=%d" % amplitude]
            print("- ring, A = %d, n = %d; %s" % (amplitude, n, carried(options, "plane", settings, n)), flush=True)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("gaspard")
    parser.add_argument("--part", default="all", choices=["plane", "sphere", "all"])
    parser.add_argument("--cells", default="30,60,120")
    parser.add_argument("--methods", default=",".join(METHODS))
    parser.add_argument("--limit", type=float, default=60)
    parser.add_argument("--repeat", type=int, default=1)
    parser.add_argument("--only", default="", help="cases whose name contains this")
    parser.add_argument("--random", type=int, default=0, help="number of monitors of each kind on each domain")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--carried", action="store_true", help="if auto fails, test whether the mesh can represent the map")
    parser.add_argument("--restrict", action="store_true")
    options = parser.parse_args()
    if options.random:
        return successes(options)
    if options.restrict:
        return restrict(options)
    cases = []
    if options.part != "sphere":
        for n in options.cells.split(","):
            cases += [("%s, n = %s" % (name, n), scenario, settings + ["domain.cells=" + n])
                      for name, scenario, settings in PLANE]
    if options.part != "plane":
        cases += SPHERE
    table(options, cases)


if __name__ == "__main__":
    main()
