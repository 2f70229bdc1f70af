# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Differences that remain: which reader, in which variants, and why the program's reading is right."""

import dataclasses


@dataclasses.dataclass(frozen=True)
class Explanation:
    """when: choice -> values, all of which a variant must have. kinds: of differences, empty for all."""

    formats: tuple
    readers: tuple
    when: dict
    kinds: tuple
    reason: str

    def covers(self, extension, reader, kind, choices):
        return (
            extension in self.formats
            and any(reader.startswith(name) for name in self.readers)
            and (not self.kinds or kind in self.kinds)
            and all(choices[name] in values for name, values in self.when.items())
        )


EXPLAINED = []
