# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""A check of JSON by a schema, for the keywords that the schemas of the reports use. Any other keyword is an error."""

import re

TYPES = {"object": dict, "array": list, "string": str, "integer": int, "number": (int, float), "null": type(None)}
NOT_CHECKED = {"$schema", "$defs", "title", "description"}


def problems(value, schema, whole=None, path="report"):
    """What is wrong with a value, a sentence each."""
    whole = whole or schema
    found = []
    for keyword, rule in schema.items():
        if keyword not in NOT_CHECKED:
            found += CHECKS[keyword](value, rule, schema, whole, path)
    return found


def _reference(value, rule, _schema, whole, path):
    return problems(value, whole["$defs"][rule.removeprefix("#/$defs/")], whole, path)


def _type(value, rule, _schema, _whole, path):
    kinds = [rule] if isinstance(rule, str) else rule
    is_one = any(isinstance(value, TYPES[kind]) and not isinstance(value, bool) for kind in kinds)
    return [] if is_one else [f"{path} is {value!r}, not of type {rule}"]


def _properties(value, rule, _schema, whole, path):
    return [problem for name, below in rule.items() if isinstance(value, dict) and name in value
            for problem in problems(value[name], below, whole, f"{path}.{name}")]


def _pattern(value, rule, _schema, whole, path):
    return [problem for pattern, below in rule.items() for name in value if re.search(pattern, name)
            for problem in problems(value[name], below, whole, f"{path}.{name}")]


def _additional(value, rule, schema, whole, path):
    patterns = schema.get("patternProperties", {})
    others = [name for name in value if name not in schema.get("properties", {})
              and not any(re.search(pattern, name) for pattern in patterns)]
    if rule is False:
        return [f"{path}.{name} is not in the schema" for name in others]
    return [problem for name in others for problem in problems(value[name], rule, whole, f"{path}.{name}")]


def _items(value, rule, _schema, whole, path):
    return [problem for i, item in enumerate(value) for problem in problems(item, rule, whole, f"{path}.{i}")]


CHECKS = {
    "$ref": _reference,
    "type": _type,
    "enum": lambda value, rule, _s, _w, path: [] if value in rule else [f"{path} is {value!r}, not one of {rule}"],
    "minimum": lambda value, rule, _s, _w, path: [] if value >= rule else [f"{path} is {value!r}, below {rule}"],
    "required": lambda value, rule, _s, _w, path: [f"{path} has no {name}" for name in rule if name not in value],
    "properties": _properties,
    "patternProperties": _pattern,
    "additionalProperties": _additional,
    "items": _items,
}
