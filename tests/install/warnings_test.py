#!/usr/bin/env python3
"""Warnings are errors only where they are asked for: not for users, whose compilers may warn of other things.

usage: warnings_test.py SOURCES
"""
import os, sys, tempfile

sys.dont_write_bytecode = True # below: nothing is left in the sources
from library_test import check, run


def commands(sources, *options):
    with tempfile.TemporaryDirectory() as build:
        run(["cmake", "-S", sources, "-B", build, "-G", "Ninja", "-DGASPARD_PROGRAM=OFF", "-DGASPARD_TESTS=OFF", *options])
        return run(["ninja", "-C", build, "-t", "commands"])


def main():
    sources = os.path.abspath(sys.argv[1])
    by_default = commands(sources)
    check("-Wall" in by_default, "no warnings are asked for")
    check("-Werror" not in by_default, "warnings are errors without being asked for")
    check("-Werror" in commands(sources, "-DGASPARD_WERROR=ON"), "GASPARD_WERROR does nothing")
    for script, wanted in (("run.sh", False), ("package.sh", False), ("bench.sh", False), ("test.sh", True)):
        with open(os.path.join(sources, "scripts", script)) as file:
            check(("-DGASPARD_WERROR=ON" in file.read()) == wanted, "warnings in scripts/" + script)


main()
