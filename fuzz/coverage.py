#!/usr/bin/env python3
"""Sums libFuzzer's -print_coverage (standard input) by source of the core: edges of the control flow that were reached,
and those of the functions that were reached. What only runs when memory is short counts, too."""
import collections, re, sys

reached, total = collections.Counter(), collections.Counter()
for line in sys.stdin:
    found = re.match(r"COVERED_FUNC: hits: \d+ edges: (\d+)/(\d+) .*?/src/(core/\S+?\.cpp)", line)
    if found:
        reached[found[3]] += int(found[1])
        total[found[3]] += int(found[2])
if not total:
    sys.exit("coverage.py: no coverage was printed")
for source in sorted(total, key=lambda name: -reached[name]):
    print("%6d of %5d edges  %s" % (reached[source], total[source], source))
