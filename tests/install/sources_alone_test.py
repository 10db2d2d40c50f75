#!/usr/bin/env python3
"""Every source of the program compiles by itself, as in everyday builds: the builds of scripts/ compile sources in
batches (GASPARD_UNITY), which hides an #include that is missing. Nothing is optimised or linked.

usage: sources_alone_test.py SOURCES
"""
import concurrent.futures, json, os, shlex, subprocess, sys, tempfile

sys.dont_write_bytecode = True # below: nothing is left in the sources
from library_test import check, run


def errors(step):
    """What the compiler says of one source; empty if nothing."""
    words = shlex.split(step["command"]) + ["-fsyntax-only"]
    done = subprocess.run(words, cwd=step["directory"], capture_output=True, text=True)
    return "" if done.returncode == 0 else done.stderr


def main():
    sources = os.path.abspath(sys.argv[1])
    with tempfile.TemporaryDirectory() as build:
        run(["cmake", "-S", sources, "-B", build, "-G", "Ninja", "-DGASPARD_UNITY=OFF", "-DGASPARD_WERROR=ON",
             "-DGASPARD_TESTS=OFF", "-DCMAKE_BUILD_TYPE=Debug", "-DCMAKE_CXX_FLAGS_DEBUG=-O0",
             "-DCMAKE_EXPORT_COMPILE_COMMANDS=ON"])
        with open(os.path.join(build, "compile_commands.json")) as file:
            steps = json.load(file)
        targets = [line.split(":")[0] for line in run(["ninja", "-C", build, "-t", "targets", "all"]).splitlines()]
        made = [name for name in targets if name.endswith(".gch") or name.startswith("generated/")]
        check(any(name.endswith(".gch") for name in made), "no precompiled headers")
        run(["ninja", "-C", build, *made])
        steps = [step for step in steps if step["file"].startswith(os.path.join(sources, "src"))]
        check(len(steps) > 300, "only %d sources" % len(steps))
        with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
            found = [text for text in pool.map(errors, steps) if text]
        check(not found, "\n".join(found))


main()
