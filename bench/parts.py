#!/usr/bin/env python3
"""Time the parts of an iteration and of its display relative to this machine's limits; prints the tables of
docs/performance.md.

usage: parts.py FOLDER_OF_PROGRAMS

bench_plane and bench_upload report the time of each part and the minimum number of bytes and operations that it needs
(see plane.cpp); machine.cpp measures the machine's bandwidth and arithmetic rate. The limit of a part is the larger of
the two resulting times. One thread; CPU time, minimum over all repetitions.
"""
import json, os, subprocess, sys

SIZES = [60, 120, 240, 480]


def measure(program):
    command = [program, "--benchmark_format=json", "--benchmark_min_time=0.03", "--benchmark_repetitions=3"]
    out = json.loads(subprocess.run(command, capture_output=True, text=True, check=True).stdout)
    best = {}
    for row in out["benchmarks"]:
        if row["run_type"] == "iteration":
            seconds = row["cpu_time"] * {"ns": 1e-9, "us": 1e-6, "ms": 1e-3}[row["time_unit"]]
            one = {"seconds": seconds}
            for name in ("bytes", "flops", "bytes_per_second"):
                one[name] = row.get(name, 0) * seconds  # per call
            if row["name"] not in best or seconds < best[row["name"]]["seconds"]:
                best[row["name"]] = one
    return best


def time_text(seconds):
    return "%.1f us" % (1e6 * seconds) if seconds < 1e-4 else "%.3g ms" % (1e3 * seconds)


def main():
    rows = {}
    for program in ("bench_plane", "bench_upload"):
        rows.update(measure(os.path.join(sys.argv[1], program)))
    streams = sorted((int(name.split(":")[1]) * 1024, one["bytes_per_second"] / one["seconds"])
                     for name, one in rows.items() if name.startswith("triad"))
    peak = rows["multiply_add"]["flops"] / rows["multiply_add"]["seconds"]
    print("| the machine | measured |\n| --- | --- |")
    for size, rate in streams:
        print("| stream (triad) in %d KiB | %.0f GB/s |" % (size // 1024, rate / 1e9))
    print("| multiply-adds | %.0f Gflop/s |" % (peak / 1e9))

    def limit(one):
        rate = next((rate for size, rate in streams if one["bytes"] <= size), streams[-1][1])
        by_bytes, by_flops = one["bytes"] / rate, one["flops"] / peak
        return "%s (%s)" % (time_text(max(by_bytes, by_flops)), "bytes" if by_bytes > by_flops else "flops")

    names = dict.fromkeys(name.split("/")[0] for name in rows if "/n:" in name)
    print("\n| part | " + " | ".join("n = %d" % n for n in SIZES)
          + " | ns a cell at 60, 480 | limit at 60 | limit at 480 |")
    print("| --- " * (4 + len(SIZES)) + "|")
    for name in names:
        of = [rows["%s/n:%d" % (name, n)] for n in SIZES]
        a_cell = ["%.1f" % (1e9 * one["seconds"] / n ** 2) for one, n in ((of[0], SIZES[0]), (of[-1], SIZES[-1]))]
        print("| " + " | ".join([name] + [time_text(one["seconds"]) for one in of] + [", ".join(a_cell)]
                                + [limit(of[0]), limit(of[-1])]) + " |")


if __name__ == "__main__":
    main()
