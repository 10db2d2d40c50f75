#!/usr/bin/env python3
"""What `cmake --install` leaves is enough for others: the example, as a project of its own in a folder of its own, is
built against it and run, every public header compiles alone, and the program finds its assets from anywhere.

usage: library_test.py BUILD EXAMPLES
"""
import os, re, subprocess, sys, tempfile


def run(command, **more):
    done = subprocess.run(command, capture_output=True, text=True, **more)
    if done.returncode != 0:
        sys.exit("%s\nended with %d\n%s%s" % (" ".join(map(str, command)), done.returncode, done.stdout, done.stderr))
    return done.stdout


def check(truth, sentence):
    if not truth:
        sys.exit(sentence)


def headers_below(folder):
    return [os.path.join(path, name) for path, _, names in os.walk(folder) for name in names]


def main():
    build, examples = map(os.path.abspath, sys.argv[1:])
    with tempfile.TemporaryDirectory() as folder:
        prefix = os.path.join(folder, "prefix")
        run(["cmake", "--install", build, "--prefix", prefix])

        # The library, as a project of a user's finds it.
        user = os.path.join(folder, "user")
        run(["cmake", "-S", examples, "-B", user, "-DCMAKE_PREFIX_PATH=" + prefix, "-DCMAKE_BUILD_TYPE=Release",
             "-DCMAKE_CXX_FLAGS=-Wall -Wextra -Wpedantic -Werror"])
        with open(os.path.join(user, "CMakeCache.txt")) as cache:
            found = re.search(r"^Gaspard_DIR:\w+=(.*)$", cache.read(), re.M).group(1)
        check(found.startswith(prefix), "found Gaspard in %s, not in %s" % (found, prefix))
        run(["cmake", "--build", user])
        out = run([os.path.join(user, "follow_a_feature")], cwd=folder)
        steps = re.findall(r"^step (\d+): converged after (\d+) iterations, equidistribution ([0-9.]+)$", out, re.M)
        check(len(steps) == 161, "%d of 161 time steps have converged" % len(steps))
        first, others = int(steps[0][1]), [int(step[1]) for step in steps[1:]]
        check(first >= 2 * max(others), "the first step takes %d iterations, a warm one up to %d" % (first, max(others)))
        check(min(others) > 0, "the spot has not moved the mesh")
        worst = max(float(step[2]) for step in steps)
        check(worst < 0.02, "the mesh does not keep up: equidistribution %g" % worst)

        formula = [os.path.join(user, "typed_formula")]
        out = run(formula, cwd=folder)
        check(re.fullmatch(r"converged after \d+ iterations\n", out), "the typed formula: %s" % out)
        bad = subprocess.run(formula + ["1 + sine(x)"], capture_output=True, text=True)
        check(bad.returncode == 2 and "unknown function 'sine' at character 5" in bad.stderr, bad.stderr)

        # A program may have another Eigen than the one that the library was made with.
        consumer = os.path.join(folder, "consumer")
        run(["cmake", "-S", os.path.join(os.path.dirname(os.path.abspath(__file__)), "consumer"), "-B", consumer,
             "-DCMAKE_PREFIX_PATH=" + prefix, "-DCMAKE_BUILD_TYPE=Release"])
        run(["cmake", "--build", consumer])
        plain = run([os.path.join(consumer, "plain")])
        check(len(plain.split()) > 500, "no mesh was printed")
        check(plain == run([os.path.join(consumer, "foreign")]), "a program's own Eigen changes the library's results")

        # What docs/library.md says of monitors, patches, diagnostics and files.
        include = os.path.join(prefix, "include")
        libraries = [path for path, _, names in os.walk(prefix) if "libgaspard.so" in names]
        usage = os.path.join(folder, "usage")
        source = os.path.join(os.path.dirname(os.path.abspath(__file__)), "library_usage.cpp")
        run(["c++", "-std=c++20", "-O1", "-Wall", "-Wextra", "-Werror", "-I", include, source, "-o", usage,
             "-L", libraries[0], "-Wl,-rpath," + libraries[0], "-lgaspard"])
        files = os.path.join(folder, "results", "of", "the", "usage")
        check(run([usage, files]) == "as documented\n", "library_usage.cpp does not end as it should")
        check(os.path.getsize(os.path.join(files, "adapted.vtu")) > 1000, "the folder of the files was not made")

        # No public header wants another one before it, or one that is not installed.
        headers = headers_below(include)
        check(len(headers) > 15, "only %d headers were installed" % len(headers))
        for header in headers:
            run(["c++", "-std=c++20", "-fsyntax-only", "-Wall", "-Wextra", "-Werror", "-I", include, "-include", header,
                 "-x", "c++", os.devnull])
        inside = [name for name in headers if re.search(r'#include ["<](core/|toml|nlohmann|tiny_gltf|stb|Eigen)',
                                                        open(name).read())]
        check(not inside, "what should stay inside is included by %s" % inside)

        # The program, moved away from where it was built.
        program = os.path.join(prefix, "bin", "gaspard")
        here = os.path.join(folder, "here")
        run([program, "run", "plane-ring", "--set", "domain.cells=16", "--quiet", "--out", here], cwd="/")
        check(os.path.getsize(os.path.join(here, "view.png")) > 5000, "no picture was drawn")
        run([program, "show", "plane-bell"], cwd=folder)


if __name__ == "__main__":
    main()
