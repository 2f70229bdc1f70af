# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Every numeric flag of every command, as --help lists them, with values that it cannot take.

A flag that a command before has with the same range gets one value only; with `--whole` it gets all.
"""

import re
import sys

from application import REJECTED, USAGE, ApplicationTest, main

COMMANDS = {
    "": ("nothing.ply", "out.ply"),
    "thesis": ("nothing.obj", 700, 0.95, 0),
    "certify": ("nothing.ply", "other.ply"),
    "tolerance": ("nothing.ply", "--triangles", 5),
    "curve": ("nothing.ply", "--errors", 0.5),
    "levels": ("nothing.ply",),
    "diagnose": ("nothing.ply",),
}
# Placeholders of the values of flags that take no number.
OTHER_VALUES = {"SURFACE", "LABELMAP", "JSON", "HTML", "PNG", "SVG", "CSV", "TOML", "LOG", "NAME", "PROFILE", "EXT", "NAME.EXT",
                "PATTERN", "SHAPE=MM", "SIZE"}
NO_NUMBERS = ("nan", "-inf", "1e400", "", "5mm")
FEW_NO_NUMBERS = ("nan", "", "5mm")  # all flags have the same reader; what lies beyond a range is tried for each of them
MORE_NO_NUMBERS = ("inf", "NaN", " 5", "5 ", "0x10", "five", "1'000", "--5", "\N{ARABIC-INDIC DIGIT FIVE}")
ENTRY = re.compile(r"(?ms)^  (--[a-z-]+) (\S+)(.*?)(?=^  -|^\S|\Z)")
RANGE = re.compile(r"(numbers with commas in between, each )?(a whole number|a number) from (\S+) to ([^\s;]*[^\s;.]) ?(\S*?)[;.] ?")


class Flag:
    def __init__(self, name, found):
        self.name = name
        self.is_list = bool(found[1])
        self.is_whole = found[2] == "a whole number"
        self.least_text = found[3]
        self.least, self.most = float(found[3]), float(found[4])
        self.unit = found[5]

    def __eq__(self, other):
        return vars(self) == vars(other)

    def hostile(self, is_first, is_known):
        """Few values for each flag, many for the first one of a command: there is only one reader."""
        if is_known:
            yield "5mm"
            return
        yield from (*NO_NUMBERS, *MORE_NO_NUMBERS) if is_first else FEW_NO_NUMBERS
        step = max(1.0, 1e-6 * abs(self.least))
        yield repr(self.least - step)
        yield repr(self.most * 1.01 + 1)
        if self.is_whole:
            yield "1.5"
        for good in ("1",) if self.is_list else ():
            for bad in (",%s", "%s,", "%s,,%s", "%s,nan"):
                yield bad.replace("%s", good)
        if not self.is_list:
            yield "1,5"

    def good(self, is_first):
        """Ways to write a number in the range."""
        ways = (("+.25", "2.5e-1") if self.most < 1.0 else ("1e3", "+1000.0") if self.most >= 1000.0 else
                ("1e0", "+1.0") if self.least <= 1.0 else ("1e1", "+10.0"))
        return ways if is_first else ways[:1]


class HostileValues(ApplicationTest):
    whole = False

    def flags(self, command):
        """The numeric flags of a command; nothing else that takes a value may be left over."""
        help_text = self.succeed(*filter(None, (command, "--help"))).stdout
        numeric = []
        for name, value, text in ENTRY.findall(help_text):
            found = RANGE.search(re.sub(r"\s+", " ", value + text))
            if found:
                numeric.append(Flag(name, found))
            else:
                takes_choice = re.fullmatch(r"[\w]+(\|\w+)+", value)
                takes_nothing = not re.fullmatch(r"[A-Z.,=]+|[\w|]+\|[\w|]+", value)
                self.assertTrue(takes_choice or takes_nothing or value in OTHER_VALUES, (name, value))
        return numeric

    def words(self, command, flag, value):
        words = list(COMMANDS[command])
        if flag in words:
            at = words.index(flag)
            del words[at : at + 2]
        return [*filter(None, (command,)), *words, flag, value]

    def test_each_flag_rejects_what_is_no_number_in_its_range(self):
        count, known = 0, []
        for command in COMMANDS:
            for at, flag in enumerate(self.flags(command)):
                is_known = flag in known and not self.whole
                known.append(flag)
                for value in flag.hostile(at == 0, is_known):
                    with self.subTest(command=command, flag=flag.name, value=value):
                        completed = self.fail_with(USAGE, *self.words(command, flag.name, value), says=flag.name)
                        self.assertIn("takes", completed.stderr)
                        self.assertIn("from %s to " % flag.least_text, completed.stderr)
                        self.assertIn(flag.unit, completed.stderr)
                        if not flag.is_list:
                            self.assertIn("not '%s'" % value, completed.stderr)
                        count += 1
        self.assertGreater(count, 200)

    def test_each_flag_takes_every_way_to_write_a_number(self):
        for command in COMMANDS:
            for at, flag in enumerate(self.flags(command)):
                for value in flag.good(at == 0):
                    with self.subTest(command=command, flag=flag.name, value=value):
                        stderr = self.run_program(*self.words(command, flag.name, value)).stderr
                        self.assertNotIn(" takes ", stderr)

    def test_every_command_has_its_numbers(self):
        found = {command: {flag.name for flag in self.flags(command)} for command in COMMANDS}
        self.assertLessEqual({"--max-error", "--target-triangles", "--iso", "--jobs", "--threads"}, found[""])
        self.assertEqual(found["certify"], {"--tolerance", "--iso", "--gap", "--mean-precision", "--threads", "--label", "--spacing"})
        self.assertEqual(found["tolerance"], {"--triangles", "--precision", "--smooth", "--feature-angle", "--label", "--spacing", "--threads"})
        self.assertEqual(found["curve"], {"--errors", "--smooth", "--feature-angle", "--label", "--spacing", "--threads"})
        self.assertEqual(found["levels"], {"--coarsest", "--max-error", "--triangles", "--errors", "--smooth", "--feature-angle", "--label", "--spacing", "--threads"})
        self.assertEqual(found["diagnose"], {"--threads"})

    def test_numbers_of_the_thesis_are_read_in_the_same_way(self):
        for at, name in enumerate(("numbFaces", "tolerance", "errorThreshold"), 1):
            for value in (*NO_NUMBERS, -1, "1,5"):
                words = list(COMMANDS["thesis"])
                words[at] = value
                if str(value).startswith("-"):
                    words.insert(0, "--")
                with self.subTest(name=name, value=value):
                    self.fail_with(USAGE, "thesis", *words, says=name + " takes a")
        self.fail_with(REJECTED, "thesis", "nothing.obj", "7e2", "+.95", "0.0", says="no such file")

    def test_numbers_of_regions_are_read_in_the_same_way(self):
        for value in (*NO_NUMBERS, -1, 1e31):
            for text in ("rest=%s", "sphere:0,0,0,%s=1", "sphere:0,0,0,1=%s", "box:%s,1,0,1,0,1=%s"):
                text = text.replace("%s", str(value))
                with self.subTest(text):
                    self.fail_with(USAGE, *COMMANDS[""], "--region", text, says="--region takes ")

    def test_numbers_of_slicer_are_read_in_the_same_way(self):
        run = ("--returnparameterfile", "r.txt", *COMMANDS[""], "--max-error", 1)
        for value in (*NO_NUMBERS, 1e31):
            for words in (("--roi", "0,0,0,1,1,%s" % value), ("--keep", "0,0,%s" % value),
                          ("--keep", "0,0,0", "--keep-radius", value)):
                with self.subTest(words):
                    self.fail_with(USAGE, *run, *words, says=words[-2] + " takes ")
        self.fail_with(USAGE, *run, "--keep", "0,0,0", "--keep-radius", -1, says="--keep-radius takes ")
        self.fail_with(USAGE, *run, "--roi", "0,0,0,1,1,-1", says="--roi takes ")


if __name__ == "__main__":
    HostileValues.whole = "--whole" in sys.argv
    sys.argv = [word for word in sys.argv if word != "--whole"]
    main()
