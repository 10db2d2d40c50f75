#!/usr/bin/env python3
"""The library without the program: configured where GLFW, Dear ImGui, GLM and CLI11 are missing; taken into another
project by add_subdirectory and by FetchContent; installed from there; found by pkg-config, also after the installed
folder has been moved. The library is compiled in batches without optimisation.

usage: library_alone_test.py SOURCES
"""
import os, shutil, subprocess, sys, tempfile

sys.dont_write_bytecode = True # below: nothing is left in the sources
from library_test import check, headers_below, run


def configure_without_graphics(sources, build, empty):
    """Fails if anything of the window is looked for."""
    real = shutil.which("pkg-config")
    tool = os.path.join(empty, "pkg-config")
    with open(tool, "w") as file:
        file.write('#!/bin/sh\ncase " $* " in *imgui*) exit 1 ;; esac\nexec %s "$@"\n' % real)
    os.chmod(tool, 0o755)
    hidden = ["-DCMAKE_DISABLE_FIND_PACKAGE_%s=ON" % name for name in ("glfw3", "glm", "CLI11")]
    options = ["cmake", "-S", sources, "-B", build, "-G", "Ninja", "-DGASPARD_TESTS=OFF", "-DPKG_CONFIG_EXECUTABLE=" + tool]
    whole = subprocess.run(options + hidden, capture_output=True, text=True)
    check(whole.returncode != 0, "nothing was hidden: the program was configured, too")
    run(options + hidden + ["-DGASPARD_PROGRAM=OFF"])
    steps = run(["ninja", "-C", build, "-t", "commands"])
    check("src/core/session/run.cpp" in steps, "the library is not built")
    check("src/gui" not in steps and "src/cli" not in steps, "the program is built without being asked for")


def main():
    sources = os.path.abspath(sys.argv[1])
    here = os.path.dirname(os.path.abspath(__file__))
    with tempfile.TemporaryDirectory() as folder:
        empty = os.path.join(folder, "tools")
        os.mkdir(empty)
        configure_without_graphics(sources, os.path.join(folder, "alone"), empty)

        user = os.path.join(folder, "user")
        results = []
        for how in ("add_subdirectory", "FetchContent"):
            run(["cmake", "-S", os.path.join(here, "taken_in"), "-B", user, "-G", "Ninja", "-DHOW=" + how,
                 "-DGASPARD_SOURCES=" + sources, "-DGASPARD_INSTALL=ON", "-DGASPARD_UNITY=ON", "-DCMAKE_BUILD_TYPE=Debug",
                 "-DCMAKE_CXX_FLAGS_DEBUG=-O0"])
            run(["cmake", "--build", user])
            results.append(run([os.path.join(user, "bits")]))
            check(len(results[-1].split()) > 500, "%s: no mesh was printed" % how)
        check(results[0] == results[1], "the mesh depends on how the library was taken in")

        prefix = os.path.join(folder, "prefix")
        run(["cmake", "--install", user, "--prefix", prefix])
        check(not os.path.exists(os.path.join(prefix, "bin")), "a program was installed")
        moved = os.path.join(folder, "moved")
        os.rename(prefix, moved)
        files = [path for path in headers_below(moved) if path.endswith("gaspard.pc")]
        check(len(files) == 1, "gaspard.pc was installed %d times" % len(files))
        environment = dict(os.environ, PKG_CONFIG_PATH=os.path.dirname(files[0]))
        check(run(["pkg-config", "--modversion", "gaspard"], env=environment).strip() != "", "no version")
        flags = run(["pkg-config", "--cflags", "--libs", "gaspard"], env=environment).split()
        check("-lgaspard" in flags and any(moved in flag for flag in flags), "pkg-config says %s" % flags)
        folder_of_library = run(["pkg-config", "--variable=libdir", "gaspard"], env=environment).strip()
        program = os.path.join(folder, "bits")
        run(["c++", "-std=c++20", os.path.join(here, "consumer", "bits.cpp"), "-o", program] + flags)
        out = run([program], env=dict(os.environ, LD_LIBRARY_PATH=folder_of_library))
        check(out == results[0], "the installed library has another result")


if __name__ == "__main__":
    main()
