# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Rows of choices that contain every pair of choices, and random ones behind them."""

import itertools
import random


def all_pairs(choices, seed):
    """Few rows (dict of name -> value) in which every two values of two different names occur together.

    choices: dict of name -> list of values. The same seed gives the same rows. Greedy: each row takes a pair that is
    still missing and then, name by name, the value that covers the most missing pairs.
    """
    generator = random.Random(seed)
    names = list(choices)
    missing = {
        ((a, i), (b, j))
        for a, b in itertools.combinations(names, 2)
        for i in range(len(choices[a]))
        for j in range(len(choices[b]))
    }
    order = {name: number for number, name in enumerate(names)}

    def pair(first, second):
        return (first, second) if order[first[0]] < order[second[0]] else (second, first)

    rows = []
    waiting = sorted(missing, key=lambda p: (order[p[0][0]], p[0][1], order[p[1][0]], p[1][1]))
    generator.shuffle(waiting)
    while missing or not rows:
        while waiting and waiting[-1] not in missing:
            waiting.pop()
        row = dict(waiting.pop()) if waiting else {}
        for name in generator.sample(names, len(names)):
            if name not in row:
                row[name] = max(
                    generator.sample(range(len(choices[name])), len(choices[name])),
                    key=lambda i: sum(pair((name, i), other) in missing for other in row.items()),
                )
        for two in itertools.combinations(row.items(), 2):
            missing.discard(pair(*two))
        rows.append({name: choices[name][row[name]] for name in names})
    return rows


def one_at_a_time(choices, seed, uniform=()):
    """Rows with one unusual value; those of names in uniform are any."""
    generator = random.Random(seed + 2)
    return [
        {n: value if n == name else generator.choice(v) if n in uniform else v[0] for n, v in choices.items()}
        for name, values in choices.items()
        for value in values
        for _ in range(3)
    ]


def variants(choices, count, seed, uniform=()):
    """At least count rows: all pairs first, then one unusual value each, then random ones.

    The first value of a choice is the usual one. Most random rows have few others, so that readers which lack one thing are
    compared in the rest; choices named in uniform take any value.
    """
    rows = all_pairs(choices, seed) + one_at_a_time(choices, seed, uniform)
    generator = random.Random(seed + 1)
    while len(rows) < count:
        fraction = generator.choice([0.03, 0.06, 0.1, 0.2, 0.5])
        rows.append(
            {
                name: generator.choice(values) if name in uniform or generator.random() < fraction else values[0]
                for name, values in choices.items()
            }
        )
    return rows


def uniform_variants(choices, count, seed):
    """At least count rows: all pairs first, then random ones in which every value is as likely as the others."""
    rows = all_pairs(choices, seed)
    generator = random.Random(seed + 1)
    while len(rows) < count:
        rows.append({name: generator.choice(values) for name, values in choices.items()})
    return rows
