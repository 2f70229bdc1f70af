#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Compares the readers of volumes and label maps with those of others, on generated variants of each format.

    python3 Testing/Formats/compare_volumes.py --driver build/release/bin/bonedecimate-dump-volume
    python3 Testing/Formats/compare_volumes.py --format nrrd --variants 2000 --explained

The readers that are installed take part; Testing/Formats/Volumes/requirements.txt has all of them.
"""

import argparse
import os
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent / "Volumes"))
import comparison
import formats


def arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--format", choices=list(formats.FORMATS), action="append", help="default: all")
    parser.add_argument("--variants", type=int, default=2000, help="of each format; at least all pairs of choices if 0")
    parser.add_argument("--driver", default=os.environ.get("DUMP_VOLUME", "build/release/bin/bonedecimate-dump-volume"))
    parser.add_argument("--only", type=int, action="append", help="number of a variant")
    parser.add_argument("--keep", help="folder for the files of differences")
    parser.add_argument("--generator", action="store_true", help="compare with the generator alone")
    parser.add_argument("--explained", action="store_true", help="list the explained differences")
    return parser.parse_args()


def main():
    options = arguments()
    print("| format | variants | read by ours | readers of others | differences | explained |\n|---|---:|---:|---|---:|---:|")
    is_same = True
    for name in options.format or formats.FORMATS:
        module, readers = formats.FORMATS[name], {} if options.generator else formats.readers_of(name)
        result = comparison.compare(name, module, readers, options.variants, options.driver, options.only, options.keep)
        others = ", ".join(f"{reader} ({count})" for reader, count in result.readers.items())
        print(f"| {name} | {result.variants:,} | {result.read:,} | {others} | {len(result.found)} | {sum(result.explained.values()):,} |",
              flush=True)
        comparison.print_found(result, module, options.variants)
        if options.explained:
            for (reader, kind, reason), count in sorted(result.explained.items()):
                print(f"    {reader}: {kind}, {count} variants: {reason}")
        is_same = is_same and not result.found
    return 0 if is_same else 1


if __name__ == "__main__":
    sys.exit(main())
