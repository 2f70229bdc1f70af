#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Chooses the tests that Utilities/check.sh runs with sanitizers: together they reach 98 % of the basic blocks that all reach.

Usage: Utilities/select_sanitized_tests.py       builds the preset "coverage", runs every test of the core (about 10 minutes)
                                                 and writes Testing/Coverage/sanitized_tests.txt

Greedy weighted set cover (Chvatal, A greedy heuristic for the set-covering problem, 1979): the test that reaches the most new
blocks per second comes next. The last blocks cost most: 98 % take 1.5 times as long as 97 %, and 99 % take 1.6 times as long as 98 %.
They are reached by whole runs of large surfaces alone, and `Utilities/check.sh sanitize_whole` runs those.
"""

import heapq
import os
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
LIST = ROOT / "Testing" / "Coverage" / "sanitized_tests.txt"
FRACTION = 0.98  # of the blocks
START_UP = 0.005  # seconds that even an empty test costs
HEADER = """\
# Chosen by Utilities/select_sanitized_tests.py: these {chosen} of {all} tests of the core reach {percent:.0f} % of the {blocks} basic
# blocks that all of them reach, in {seconds:.0f} of {total:.0f} seconds without sanitizers.
"""


def record(folder):
    """Builds the tests and runs them, a part of them on each processor; returns the files of their records."""
    tests = subprocess.run(["Utilities/build_core_tests.sh"], cwd=ROOT, check=True, stdout=subprocess.PIPE, encoding="utf-8").stdout
    subprocess.run(["cmake", "--preset", "coverage", "-DBONEDECIMATE_TEST_TARGETS=" + tests.strip()], cwd=ROOT, check=True)
    subprocess.run(["cmake", "--build", "--preset", "coverage", "--target", "BoneDecimateCoreTests"], cwd=ROOT, check=True)
    program = ROOT / "build" / "coverage" / "bin" / "BoneDecimateCoreTests"
    parts = os.cpu_count() or 1
    records = [folder / f"{part}.txt" for part in range(parts)]
    running = []
    for part, file in enumerate(records):
        environment = dict(
            os.environ, BONEDECIMATE_BLOCKS=str(file), GTEST_TOTAL_SHARDS=str(parts), GTEST_SHARD_INDEX=str(part))
        running.append(subprocess.Popen([program, "--gtest_brief=1"], env=environment))
    if any([process.wait() != 0 for process in running]):  # a list: wait for all of them
        sys.exit("a test failed: nothing was chosen")
    return records


def read(records):
    """Names, seconds, and integers with a bit for each block."""
    names, seconds, blocks = [], [], []
    for file in records:
        with open(file, encoding="ascii") as lines:
            for name in lines:
                names.append(name.strip())
                seconds.append(float(next(lines)))
                bits = bytearray()
                for block in map(int, next(lines).split()):
                    if block // 8 >= len(bits):
                        bits.extend(bytes(block // 8 + 1 - len(bits)))
                    bits[block // 8] |= 1 << block % 8
                blocks.append(int.from_bytes(bits, "little"))
    return names, seconds, blocks


def cover(seconds, blocks):
    """Indices of the chosen tests, and the number of blocks of all."""
    missing = 0
    for of_test in blocks:
        missing |= of_test
    number = missing.bit_count()
    # Upper bounds of new blocks per second: what a test adds only falls.
    gains = [(-of_test.bit_count() / (time + START_UP), i) for i, (of_test, time) in enumerate(zip(blocks, seconds))]
    heapq.heapify(gains)
    chosen = []
    while missing.bit_count() > (1.0 - FRACTION) * number:
        i = gains[0][1]
        gain = -(blocks[i] & missing).bit_count() / (seconds[i] + START_UP)
        if gain > gains[0][0]:
            heapq.heapreplace(gains, (gain, i))
        else:
            heapq.heappop(gains)
            chosen.append(i)
            missing &= ~blocks[i]
    return chosen, number


def main():
    """Records, chooses, writes."""
    with tempfile.TemporaryDirectory() as folder:
        names, seconds, blocks = read(record(Path(folder)))
    chosen, number = cover(seconds, blocks)
    header = HEADER.format(
        chosen=len(chosen), all=len(names), percent=100 * FRACTION, blocks=number, seconds=sum(seconds[i] for i in chosen), total=sum(seconds))
    LIST.write_text(header + "".join(names[i] + "\n" for i in sorted(chosen, key=lambda i: names[i])), encoding="ascii")
    print(header, end="")


if __name__ == "__main__":
    main()
