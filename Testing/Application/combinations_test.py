# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Every pair of features of the program either works, which the outputs must show, or is rejected with one sentence.

An option without a feature of its own has one that follows from the table of options. The test runs every pair that Documentation/results/combinations.md rejects or
warns of, and a third of those that work there; with `--whole` it runs all. It fails if the page has another matrix than it found.
`combinations_test.py --print` runs all and prints the matrix.
"""

import concurrent.futures
import itertools
import os
import pathlib
import re
import shutil
import sys
import tempfile
import unittest


import combinations_features as features
import combinations_inputs
from application import DONE, PROGRAM, REJECTED, USAGE, main

PAGE = pathlib.Path(__file__).resolve().parents[2] / "Documentation" / "results" / "combinations.md"
RULES = PAGE.parents[1] / "reference" / "combinations.md"
BEGIN, END = "<!-- matrix: begin -->", "<!-- matrix: end -->"
WORKS, WARNS, REJECTS = "+", "w", "-"
# Of the pairs that work by the page, the short form runs one in this many.
PERIOD = 3


class Outcome:
    """The result of a pair of features: a mark, the sentence of a rejection or a warning, and the problem if there is one."""

    def __init__(self, mark, sentence="", problem=""):
        self.mark, self.sentence, self.problem = mark, sentence, problem


def outcome_of(run, inputs):
    """Runs a pair in a folder of its own."""
    with tempfile.TemporaryDirectory(prefix="bonedecimate-test-") as name:
        folder = pathlib.Path(name)
        for path in inputs.iterdir():
            (shutil.copytree if path.is_dir() else os.link)(path, folder / path.name)
        before = sorted(folder.rglob("*"))
        completed = run.execute(folder)
        if completed.returncode in (USAGE, REJECTED):
            return rejection(run, completed, left=sorted(folder.rglob("*")) != before)
        if completed.returncode != DONE:
            return Outcome("?", problem=f"exit code {completed.returncode}: {completed.stderr}")
        return success(run, completed)


def rejection(run, completed, left):
    sentence = completed.stderr.strip()
    problem = ""
    if left:
        problem = "rejected, but something was written"
    elif not re.fullmatch(r"bonedecimate: [^\n]+", sentence):
        problem = f"the rejection is not one line: {completed.stderr!r}"
    elif not any(word.lower() in sentence.lower() for feature in run.pair for word in feature.rejected_by):
        problem = f"the rejection names neither feature: {sentence!r}"
    return Outcome(REJECTS, shortened(sentence), problem)


def shortened(sentence):
    """Without what differs between features that are rejected alike."""
    text = sentence[len("bonedecimate: "):]
    text = re.sub(r"unknown option --.*", "unknown option ...", text)
    return re.sub(r"; see bonedecimate[a-z ]* -h", "", text)


def success(run, completed):
    if completed.stderr:
        return Outcome(WORKS, problem=f"success, but it says {completed.stderr!r}")
    problems = [f"no sign of '{feature.name}': {problem}" for feature in run.pair if (problem := feature.problem_in(run))]
    warnings = run.warnings()
    return Outcome(WARNS if warnings else WORKS, "; ".join(warnings), "; ".join(problems))


def outcomes_of_pairs(rows, inputs, is_chosen):
    """Of each unordered pair of different features; pairs that are not chosen count as working."""
    def find(pair):
        return outcome_of(features.Run(PROGRAM, pair), inputs) if is_chosen(*pair) else Outcome(WORKS)
    pairs = list(itertools.combinations(rows, 2))
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        return {(a.name, b.name): outcome for (a, b), outcome in zip(pairs, pool.map(find, pairs))}


def pairs_that_work(rows):
    """By the page, whose rows begin with the number and the name of their feature."""
    page = PAGE.read_text(encoding="utf-8")
    works = set()
    for number, feature in enumerate(rows, 1):
        line = re.search(rf"^ ?{number}  {re.escape(feature.name)} +([{WORKS}{WARNS}{REJECTS}]+)$", page, re.MULTILINE)
        marks = line.group(1) if line else ""
        works |= {(other.name, feature.name) for other, mark in zip(rows, marks) if mark == WORKS}
    return works


def short_form(rows):
    """What decides which pairs it runs."""
    works = pairs_that_work(rows)
    numbers = {feature.name: number for number, feature in enumerate(rows)}
    return lambda a, b: (a.name, b.name) not in works or (numbers[a.name] + numbers[b.name]) % PERIOD == 0


def matrix(rows, outcomes):
    """One line a feature, one column for each feature before it."""
    width = max(len(feature.name) for feature in rows)
    lines = [" " * (width + 5) + "".join(f"{number // 10 or ' '}" for number in range(1, len(rows))),
             " " * (width + 5) + "".join(f"{number % 10}" for number in range(1, len(rows)))]
    for number, feature in enumerate(rows, 1):
        marks = "".join(outcomes[(other.name, feature.name)].mark for other in rows[: number - 1])
        lines.append(f"{number:2}  {feature.name:{width}} {marks}")
    return lines


def page_text(rows, outcomes):
    lines = ["| | feature | command line |", "|---:|---|---|"]
    lines += [f"| {number} | {feature.name} | `{feature.shown}` |" for number, feature in enumerate(rows, 1)]
    lines += ["", "```text", *matrix(rows, outcomes), "```", ""]
    for mark, title in ((REJECTS, "message of the rejection"), (WARNS, "warning")):
        sentences = {}
        for pair, outcome in outcomes.items():
            if outcome.mark == mark:
                sentences.setdefault(outcome.sentence, []).append(pair)
        lines += [f"| {title} | pairs |", "|---|---|"]
        for sentence, pairs in sorted(sentences.items()):
            lines.append(f"| {sentence} | {grouped(pairs)} |")
        lines.append("")
    return "\n".join(lines)


def grouped(pairs):
    """a with b, c, d; e with f."""
    partners = {}
    while pairs:
        counts = {}
        for pair in pairs:
            for name in pair:
                counts[name] = counts.get(name, 0) + 1
        most = max(counts, key=lambda name: counts[name])
        partners[most] = [b if a == most else a for a, b in pairs if most in (a, b)]
        pairs = [pair for pair in pairs if most not in pair]
    return "; ".join(f"{name} with {', '.join(others)}" for name, others in partners.items())


class Combinations(unittest.TestCase):
    whole = False

    @classmethod
    def setUpClass(cls):
        with tempfile.TemporaryDirectory(prefix="bonedecimate-test-") as name:
            inputs = pathlib.Path(name)
            combinations_inputs.write_inputs(inputs)
            is_chosen = (lambda a, b: True) if cls.whole else short_form(features.FEATURES)
            cls.outcomes = outcomes_of_pairs(features.FEATURES, inputs, is_chosen)

    def test_none_is_silent(self):
        problems = {pair: outcome.problem for pair, outcome in self.outcomes.items() if outcome.problem}
        self.assertEqual(problems, {}, "\n" + "\n".join(f"{pair}: {text}" for pair, text in problems.items()))

    def test_the_page_is_what_was_found(self):
        page = PAGE.read_text(encoding="utf-8")
        written = page[page.index(BEGIN) + len(BEGIN):page.index(END)].strip()
        self.assertEqual(written, page_text(features.FEATURES, self.outcomes).strip())


class Rules(unittest.TestCase):
    def test_quote_messages_that_were_found(self):
        page = PAGE.read_text(encoding="utf-8")
        rows = re.findall(r"(?m)^\| (\d+) \| .* \| ([^|]*) \|$", RULES.read_text(encoding="utf-8"))
        self.assertEqual([int(number) for number, _ in rows], list(range(1, len(rows) + 1)))
        messages = [message[1] for _, text in rows if (message := re.fullmatch(r"`([^`]*)`", text))]
        self.assertGreater(len(messages), 10)
        for message in messages:
            self.assertIn(message, page)


if __name__ == "__main__":
    Combinations.whole = "--whole" in sys.argv or "--print" in sys.argv
    sys.argv = [word for word in sys.argv if word != "--whole"]
    if "--print" in sys.argv:
        Combinations.setUpClass()
        for pair, found in Combinations.outcomes.items():
            if found.problem:
                print(pair, found.problem, file=sys.stderr)
        print(page_text(features.FEATURES, Combinations.outcomes))
    else:
        main()
