# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Classes with the properties of VTK's Python style, and errors where VTK's wrapping alone reports none.

A rejected value is a ValueError, an unknown attribute an AttributeError.
"""

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
            result = method(self, *arguments)
        if errors.texts and self.GetRejectedValue(name):
            raise ValueError(self.GetRejectedValue(name))
        return result

    return call


def setting_from_text(method):
    """SetOptionFromText, which raises AttributeError for an unknown name, and ValueError for a rejected value."""

    @functools.wraps(method, assigned=("__name__", "__doc__"))
    def call(self, name, text):
        if not self.HasOption(name):
            raise AttributeError(f"{type(self).__name__} has no option '{name}'")
        with ErrorTexts(self):
            is_set = method(self, name, text)
        if not is_set:
            raise ValueError(self.GetRejectedValue(name))
        return is_set

    call.__doc__ += "\nAn option that was not set has its default (Documentation/reference/options.md)."
    return call


def set_attribute(self, name, value):
    """Properties only: an unknown attribute would change nothing."""
    if callable(getattr(type(self), name, None)):
        raise AttributeError(f"{type(self).__name__}.{name} is a method, which is called and not assigned")
    if not hasattr(type(self), name):
        raise AttributeError(f"{type(self).__name__} has no property '{name}'")
    object.__setattr__(self, name, value)


def set_properties(self, **properties):
    """In the constructor: vtkBoneDecimate(maximum_error=0.1)."""
    for name, value in properties.items():
        setattr(self, name, value)


def own_members(wrapped):
    """The members of a wrapped class and of its superclasses in the same module."""
    members = {}
    for kind in reversed(wrapped.__mro__):
        if kind.__module__ == wrapped.__module__:
            members.update({name: value for name, value in vars(kind).items() if not name.startswith("__")})
    return members


def is_getter(name, method):
    """Whether it is a GetNAME() that can be called without arguments: VTK's help begins with the signature."""
    return name.startswith("Get") and name != "GetMTime" and f"{name}(self) ->" in (method.__doc__ or "")


def add_properties(members):
    for name, method in list(members.items()):
        if name.startswith("Set") and "Get" + name[3:] in members:
            getter = members["Get" + name[3:]]
            members[snake_case(name[3:])] = property(getter, method, doc=method.__doc__)
        elif is_getter(name, method) and "Set" + name[3:] not in members:
            members[snake_case(name[3:])] = property(method, doc=method.__doc__)


def checked(module, name):
    """The wrapped class of that name with its properties; replaces the wrapped class in its module."""
    wrapped = getattr(module, name)
    members = own_members(wrapped)
    for method in [method for method in members if method.startswith(("Set", "Add"))]:
        members[method] = raising(members[method], method[3:])
    if "SetOptionFromText" in members:
        members["SetOptionFromText"] = setting_from_text(vars_of(wrapped, "SetOptionFromText"))
    add_properties(members)
    members.update(__doc__=wrapped.__doc__, __module__="bonedecimate", __setattr__=set_attribute, __init__=set_properties)
    made = type(name, (wrapped,), members)
    setattr(module, name, made)
    return made


def vars_of(wrapped, name):
    """The method as VTK wraps it."""
    return next(vars(kind)[name] for kind in wrapped.__mro__ if name in vars(kind))
