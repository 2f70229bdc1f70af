# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Writes what editors know of the options, from the table that the module was built with:

    _keywords.pyi                                   the options as TypedDicts
    vtk_filter.pyi                                  the filter with a property for each
    arrays.pyi, label_maps.pyi, levels.pyi, pyvista_accessor.pyi
                                                    the modules of these names, with each option as a parameter

    write_stubs.py FOLDER        with the module and its options on the path
"""

import ast
import pathlib
import re
import sys
import textwrap

from bonedecimate import _core, options
from bonedecimate.options import ROWS, default_of, describe, options_but, type_of, unsupported, words

HERE = pathlib.Path(__file__).resolve().parent
SOURCES = HERE.parent / "bonedecimate"
HEAD = "# Written at build time from the table of options.\n"
MODULES = ("arrays", "label_maps", "levels", "pyvista_accessor")
# Of the modules that the others import: the functions whose keywords they pass on.
FUNCTIONS = {node.name: node for name in ("arrays", "label_pieces", "voxel_check")
             for node in ast.parse((SOURCES / f"{name}.py").read_text(encoding="utf-8")).body if isinstance(node, ast.FunctionDef)}


def document(row, indent):
    return textwrap.indent("\n".join(textwrap.wrap(f'"""{describe(row)}"""', 110 - len(indent))), indent) + "\n"


def keywords():
    text = HEAD + "from typing import Literal, TypedDict\n"
    for name, without in (("ArrayOptions", unsupported("Arrays")), ("SmoothOptions", unsupported("Arrays", "Smooth")), ("LevelOptions", unsupported("Arrays", "RecordedLevels")),
                          ("MeshOptions", ["labels"])):
        text += f"\nclass {name}(TypedDict, total=False):\n"
        for key, row in options_but(without).items():
            text += f"    {key}: {type_of(row)}\n" + document(row, "    ")
    return text


def filter_class():
    lines, arguments = [], []
    for row in ROWS.values():
        kind, name = "int" if row.choices else row.kind, words(row.name, "_")
        lines.append(f"    def Set{row.name}(self, value: {kind}) -> None:\n" + document(row, "        "))
        lines.append(f"    def Get{row.name}(self) -> {kind}: ...\n")
        lines.append(f"    @property\n    def {name}(self) -> {kind}:\n" + document(row, "        "))
        lines.append(f"    @{name}.setter\n    def {name}(self, value: {kind}) -> None: ...\n")
        arguments.append(f"        {name}: {kind} = {row.default!r},\n")
        if row.kind == "bool":
            lines.append(f"    def {row.name}On(self) -> None: ...\n    def {row.name}Off(self) -> None: ...\n")
    lines += [f"    def SetModeTo{mode.name}(self) -> None: ...\n" for mode in _core.Mode]
    members = [member for kind in (_core.Mode, _core.ErrorPreset, _core.KeepVoxels, _core.StopReason) for member in kind]
    constants = [f"    {words(member.name, '_').upper()}: int\n" for member in members]
    text = (HERE / "vtk_filter.pyi.in").read_text(encoding="utf-8")
    for marker, found in (("    # CONSTANTS\n", constants), ("        # ARGUMENTS\n", arguments), ("    # PROPERTIES\n", lines)):
        text = text.replace(marker, "".join(found))
    return HEAD + text


def module(name):
    """The source without the bodies of its functions, and with each option where it says **options."""
    text = (SOURCES / f"{name}.py").read_text(encoding="utf-8").replace("from __future__ import annotations\n", "")
    text = re.sub(r"^@pv\.register_dataset_accessor.*\n", "", text, flags=re.MULTILINE)  # to checkers it would return any type
    lines, tree = text.splitlines(), ast.parse(text)
    functions = [node for node in ast.walk(tree) if isinstance(node, ast.FunctionDef)]
    nested = {inner for node in functions for inner in ast.walk(node) if inner is not node}
    for node in sorted(set(functions) - nested, key=lambda node: node.lineno, reverse=True):
        start = min(each.lineno for each in (node, *node.decorator_list))
        lines[start - 1:node.end_lineno] = textwrap.indent(function(node), " " * node.col_offset).splitlines()
    return HEAD + "from typing import Literal\n" + "\n".join(lines) + "\n"


def function(node):
    """Signature and docstring; nothing of a function that is private."""
    if node.name.startswith("_") and not node.name.endswith("__"):
        return ""
    docstring = ast.get_docstring(node) or ""
    for decorator in list(node.decorator_list):
        called = decorator.func.id if isinstance(decorator, ast.Call) else ""
        if called:
            node.decorator_list.remove(decorator)
        if called == "takes_options":
            without = options.unsupported(*(kind.value for kind in decorator.args))
            rows = options_but([*without, *(each.arg for each in node.args.kwonlyargs)])
            docstring = options.with_options(docstring, rows)
            add(node.args, {key: (ast.parse(type_of(row), mode="eval").body, ast.Constant(default_of(row)))
                            for key, row in rows.items()})
        elif called:
            add(node.args, keyword_only(FUNCTIONS[decorator.args[0].id].args))
    node.body = [ast.Expr(ast.Constant(docstring))] if docstring else []
    node.body.append(ast.Expr(ast.Constant(...)))
    return ast.unparse(ast.fix_missing_locations(node))


def add(arguments, keyword_arguments):
    """Replaces the keywords."""
    arguments.kwarg = None
    for name, (annotation, default) in keyword_arguments.items():
        arguments.kwonlyargs.append(ast.arg(name, annotation))
        arguments.kw_defaults.append(default)


def keyword_only(arguments):
    return {each.arg: (each.annotation, default) for each, default in zip(arguments.kwonlyargs, arguments.kw_defaults)}


def main(folder):
    stubs = {"_keywords": keywords(), "vtk_filter": filter_class(), **{name: module(name) for name in MODULES}}
    for name, text in stubs.items():
        (pathlib.Path(folder) / f"{name}.pyi").write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main(sys.argv[1])
