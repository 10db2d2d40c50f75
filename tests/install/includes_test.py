#!/usr/bin/env python3
"""Every source includes the headers whose names it uses, directly or through others. The builds of scripts/
compile sources in batches (GASPARD_UNITY), which hides an #include that is missing; compiling each alone takes ten times
as long as this.

Looks for the types, functions and constants that only one header declares, in columns without indentation.

usage: includes_test.py SOURCES
"""
import collections, os, re, sys

TYPE = re.compile(r"^(?:template <.*> )?(?:class|struct|enum class|enum)(?: GASPARD_API)? (\w+)[^;]*$|^using (\w+) =", re.M)
FUNCTION = re.compile(r"^(?=\w)(?!return|using|else)[\w:<>,&*\[\] ]*?[ &*](\w+)\(", re.M)
INCLUDE = re.compile(r'^#include "([^"]+)"', re.M)
NOT_CODE = re.compile(r'//[^\n]*|/\*.*?\*/|R"(\w*)\(.*?\)\1"|"(?:\\.|[^"\\\n])*"', re.S)


def code_of(text):
    return NOT_CODE.sub(lambda found: " " if found.group().startswith("/") else '""', text)


def read(folder):
    files = {}
    for path, _, names in os.walk(folder):
        for name in names:
            if name.endswith((".cpp", ".hpp")):
                with open(os.path.join(path, name)) as file:
                    files[os.path.relpath(os.path.join(path, name), folder)] = file.read()
    return files


def declared(files, pattern):
    """The names that one header alone declares: name -> header."""
    where = collections.defaultdict(set)
    for name, text in files.items():
        for found in pattern.findall(text):
            where["".join(found)].add(name)
    headers = {}
    for word, names in where.items():
        of = [name for name in names if name.endswith(".hpp")]
        # What another source defines, too, may be its own.
        if len(of) == 1 and all(name[:-4] == of[0][:-4] or os.path.dirname(name) == os.path.dirname(of[0])
                                for name in names):
            headers[word] = of[0]
    return headers


def reached(name, files, known):
    if name not in known:
        known[name] = {name}
        for other in INCLUDE.findall(files[name]):
            if other in files:
                known[name] |= reached(other, files, known)
    return known[name]


def missing(files):
    """Sentences about sources that use a name without a header that declares it, or a member or local of that name."""
    code = {name: code_of(text) for name, text in files.items()}
    known, found = {}, []
    for pattern, use in ((TYPE, r"(?<![.\w>])([A-Z]\w+)\b"), (FUNCTION, r"(?<![.\w>:])([a-z]\w+_\w+)\(")):
        headers = declared(code, pattern)
        for name in sorted(files):
            if name.endswith(".hpp"):
                continue
            seen = reached(name, files, known)
            for word in sorted(set(re.findall(use, code[name])) & headers.keys()):
                other = re.compile(r"(?:class|struct|enum|typename|using) %s\b|^ .*[\w>&*] [&*]?%s\(" % (word, word), re.M)
                if headers[word] not in seen and not any(other.search(code[one]) for one in seen):
                    found.append("%s uses %s without %s" % (name, word, headers[word]))
    return found


def main():
    files = read(os.path.join(os.path.abspath(sys.argv[1]), "src"))
    found = missing(files)
    for sentence in found:
        print(sentence)
    # Without its includes, nearly every source must be found.
    bare = {name: INCLUDE.sub("", text) if name.endswith(".cpp") else text for name, text in files.items()}
    noticed = {sentence.split()[0] for sentence in missing(bare)}
    sources = [name for name in files if name.endswith(".cpp")]
    print("%d of %d sources would be noticed without their includes" % (len(noticed & set(sources)), len(sources)))
    sys.exit(bool(found) or len(noticed) < 0.9 * len(sources))


main()
