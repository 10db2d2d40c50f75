#!/usr/bin/env python3
"""What the shared library exports is what its public headers declare: nothing of the libraries it is made with, which a
program may have in another version or with other options, and nothing of its own that no header declares. It calls its
own functions, whatever the program defines under their names.

usage: symbols_test.py LIBRARY HEADERS
"""
import os, re, subprocess, sys


def run(*command):
    return subprocess.run(command, capture_output=True, text=True, check=True).stdout


def name_of(symbol):
    """The last name of a demangled symbol: solve of gaspard::Run::solve(std::stop_token), Run of vtable for gaspard::Run."""
    symbol = re.sub(r"^(typeinfo name|typeinfo|vtable|VTT) for ", "", symbol)
    symbol = re.sub(r"^(covariant return|virtual|non-virtual) thunk to ", "", symbol)
    symbol = re.sub(r"\[abi:\w+\]", "", symbol)
    symbol = re.sub(r"\(.*", "", symbol) if "operator()" not in symbol else "operator()"
    while re.search(r"<[^<>]*>", symbol) and "operator" not in symbol:
        symbol = re.sub(r"<[^<>]*>", "", symbol)
    return symbol.split("::")[-1].lstrip("~").strip()


def main():
    library, folder = sys.argv[1:]
    headers = {os.path.join(path, name): open(os.path.join(path, name)).read()
               for path, _, names in os.walk(folder) for name in names}
    if len(headers) < 15:
        sys.exit("only %d headers below %s" % (len(headers), folder))
    faults = ["%s opens its namespace without GASPARD_API" % file for file, text in headers.items()
              if re.search(r"^namespace gaspard \{", text, re.M)]
    text = "\n".join(headers.values())
    declared = set(re.findall(r"\w+", text))
    # A class that a public header names and another header defines has the visibility of its first declaration.
    named = set(re.findall(r"^(?:class|struct) (\w+);", text, re.M))

    exported = [line.split(None, 2)[2] for line in run("nm", "-DC", "--defined-only", library).splitlines()]
    if not any("gaspard::Run::solve(" in symbol for symbol in exported):
        faults.append("gaspard::Run::solve is not exported")
    for symbol in exported:
        place = re.sub(r"^(.* for|.* thunk to) ", "", symbol)
        if not re.match(r"(\w+ )?gaspard::", place):
            faults.append("exports what is not of Gaspard: " + symbol)
        elif not re.search(r"\boperator\b", symbol) and name_of(symbol) not in declared \
                and place.split("::")[1] not in named:
            faults.append("exports what no header declares: " + symbol)

    # A relocation that names one of its own functions would let a program's function take its place. Constants (u) of
    # the headers are the same in both.
    constants = {line.split()[2] for line in run("nm", "-D", "--defined-only", library).splitlines()
                 if line.split()[1] == "u"}
    for line in run("readelf", "--relocs", "--wide", library).splitlines():
        found = re.search(r"R_\S+\s+[0-9a-f]+ (_ZN?K?7?\w*7gaspard\w*)", line)
        if found and found.group(1) not in constants:
            faults.append("calls through a name that a program may define: " + found.group(1))
    if faults:
        sys.exit("%d faults\n%s" % (len(faults), "\n".join(faults[:40])))


if __name__ == "__main__":
    main()
