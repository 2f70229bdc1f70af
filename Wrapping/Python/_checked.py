# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Classes that raise where VTK's wrapping alone says nothing: a rejected value is a ValueError, an unknown attribute an AttributeError."""

import functools
import re

from vtkmodules.vtkCommonCore import VTK_STRING


class ErrorTexts:
    """While it is entered, error events of some objects are collected, and VTK does not print them."""

    def __init__(self, *objects):
        self.objects = objects
        self.tags = []
        self.texts = []

    def __enter__(self):
        def note(_caller, _event, text):
            self.texts.append(text.split("): ", 1)[-1].strip())

        note.CallDataType = VTK_STRING
        self.tags = [one.AddObserver("ErrorEvent", note) for one in self.objects]
        return self

    def __exit__(self, *_exception):
        for one, tag in zip(self.objects, self.tags):
            one.RemoveObserver(tag)


def snake_case(name):
    """MaximumError becomes maximum_error, as in later versions of VTK."""
    return re.sub(r"(?<=[a-z0-9])(?=[A-Z])", "_", name).lower()


def raising(method, name):
    """The method, SetNAME or AddNAME, which raises ValueError if the filter rejects the value."""

    @functools.wraps(method, assigned=("__name__", "__doc__"))
    def call(self, *arguments):
        with ErrorTexts(self) as errors:
            answer = method(self, *arguments)
        if errors.texts and self.GetRejectedValue(name):
            raise ValueError(self.GetRejectedValue(name))
        return answer

    return call


def set_attribute(self, name, value):
    """Properties only: an attribute that the filter does not know would change nothing."""
    if callable(getattr(type(self), name, None)):
        raise AttributeError(f"{type(self).__name__}.{name} is a method, which is called and not assigned")
    if not hasattr(type(self), name):
        raise AttributeError(f"{type(self).__name__} has no property '{name}'")
    object.__setattr__(self, name, value)


def set_properties(self, **properties):
    """In the constructor: vtkBoneDecimate(maximum_error=0.1)."""
    for name, value in properties.items():
        setattr(self, name, value)


def checked(wrapped):
    """The wrapped class with a property for each pair of SetNAME and GetNAME."""
    members = {name: value for name, value in vars(wrapped).items() if not name.startswith("__")}
    for name in [name for name in members if name.startswith(("Set", "Add"))]:
        members[name] = raising(members[name], name[3:])
        if name.startswith("Set") and "Get" + name[3:] in members:
            members[snake_case(name[3:])] = property(members["Get" + name[3:]], members[name], doc=members[name].__doc__)
    members.update(__doc__=wrapped.__doc__, __module__="vtkbonedecimate", __setattr__=set_attribute,
                   __init__=set_properties)
    return type(wrapped.__name__, (wrapped,), members)
