#!/usr/bin/env python3
"""The Debian packages that scripts/package.sh makes: what they ask for, what they hold, and that the program runs from
them alone. They are compiled with little optimisation, which takes a third of the time.

usage: package_test.py SOURCES
"""
import glob, os, subprocess, sys, tempfile


def run(command, **more):
    done = subprocess.run(command, capture_output=True, text=True, **more)
    if done.returncode != 0:
        sys.exit("%s\nended with %d\n%s%s" % (" ".join(command), done.returncode, done.stdout, done.stderr))
    return done.stdout


def check(truth, sentence):
    if not truth:
        sys.exit(sentence)


def depends(package):
    return run(["dpkg-deb", "-f", package, "Depends"])


def main():
    sources = os.path.abspath(sys.argv[1])
    with tempfile.TemporaryDirectory() as folder:
        run([os.path.join(sources, "scripts", "package.sh"), "--folder", folder, "-DCMAKE_CXX_FLAGS_RELEASE=-O0"])
        check_packages(folder)


def check_packages(built):
    packages = {os.path.basename(path).split("_")[0]: path for path in glob.glob(os.path.join(built, "*.deb"))}
    check(sorted(packages) == ["gaspard", "libgaspard-dev", "libgaspard0.1"], "made: %s" % sorted(packages))
    for name in ("libc6", "libglfw3", "libfontconfig1", "libtomlplusplus3", "libgl1", "libosmesa6 | libegl1"):
        check(name in depends(packages["gaspard"]), "gaspard does not depend on " + name)
    check("pkgconfig/gaspard.pc" in run(["dpkg-deb", "-c", packages["libgaspard-dev"]]), "no file for pkg-config")
    check("libgaspard0.1 (= " in depends(packages["libgaspard-dev"]), "the headers do not depend on their library")

    with tempfile.TemporaryDirectory() as folder:
        root = os.path.join(folder, "root")
        run(["dpkg-deb", "-x", packages["gaspard"], root])
        usr = os.path.join(root, "usr")
        for path in ("bin/gaspard", "share/applications/gaspard.desktop", "share/man/man1/gaspard.1.gz",
                     "share/icons/hicolor/scalable/apps/gaspard.svg",
                     "share/doc/gaspard/copyright"):
            check(os.path.exists(os.path.join(usr, path)), "the package has no " + path)
        run(["desktop-file-validate", os.path.join(usr, "share/applications/gaspard.desktop")])
        program = os.path.join(usr, "bin", "gaspard")
        out = os.path.join(folder, "out")
        run([program, "run", "plane-ring", "--set", "domain.cells=16", "--quiet", "--out", out], cwd="/")
        check(os.path.getsize(os.path.join(out, "view.png")) > 5000, "no picture was drawn")


if __name__ == "__main__":
    main()
