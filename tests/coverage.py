#!/usr/bin/env python3
"""Adds up gcov's counts over all programs of a build and prints lines reached per file of the decoder.

usage: coverage.py BUILD SOURCE [--missed]
"""
import collections
import gzip
import json
import pathlib
import subprocess
import sys
import tempfile

# Files that a decoder runs. The encoder's halves of shared rooms are left out by name.
ROOMS = ("decode", "walk", "predict", "entropy", "container", "base", "attribute")
ENCODER = ("entropy/flag_encoder.cpp", "entropy/flag_encoder.h")
GOAL = 95


def counts_of(build, source):
    """File of codec/ -> line -> how often it ran, in any program. Templates: the sum over instances."""
    counts = collections.defaultdict(lambda: collections.defaultdict(int))
    files = [str(p.resolve()) for p in pathlib.Path(build).rglob("*.gcda")]
    codec = pathlib.Path(source).resolve() / "codec"
    with tempfile.TemporaryDirectory() as work:
        for i in range(0, len(files), 40):
            subprocess.run(["gcov", "--json-format", "--preserve-paths", *files[i : i + 40]], cwd=work,
                           check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        for report in pathlib.Path(work).glob("*.gcov.json.gz"):
            with gzip.open(report) as packed:
                data = json.load(packed)
            for entry in data["files"]:
                path = (pathlib.Path(data["current_working_directory"]) / entry["file"]).resolve()
                if codec not in path.parents:
                    continue
                name = str(path.relative_to(codec))
                for line in entry["lines"]:
                    counts[name][line["line_number"]] += line["count"]
    return counts


def main(build, source, missed):
    counts = counts_of(build, source)
    total = reached = 0
    for name in sorted(counts):
        if name.split("/")[0] not in ROOMS or name in ENCODER:
            continue
        lines = counts[name]
        hit = sum(1 for n in lines.values() if n > 0)
        total += len(lines)
        reached += hit
        print(f"{name:40} {hit:5} of {len(lines):5}  {100 * hit / max(1, len(lines)):5.1f} %")
        if missed and hit < len(lines):
            text = (pathlib.Path(source) / "codec" / name).read_text().splitlines()
            for number in sorted(n for n, count in lines.items() if count == 0):
                print(f"    {number:5}: {text[number - 1].strip()}")
    percent = 100 * reached / max(1, total)
    print(f"{'decoder':40} {reached:5} of {total:5}  {percent:5.1f} %")
    return 0 if percent >= GOAL else 1


if __name__ == "__main__":
    sys.exit(main(sys.argv[1], sys.argv[2], "--missed" in sys.argv[3:]))
