# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""What the tests inside ParaView have in common: the plugin, and surfaces as sources."""

import os

from paraview import simple


def load():
    """The plugin; afterwards simple.BoneDecimate and the others are there."""
    simple.LoadPlugin(os.environ["PLUGIN"], remote=False, ns=vars(simple))


def source(surface):
    """A source that puts out that vtkPolyData."""
    producer = simple.TrivialProducer()
    producer.GetClientSideObject().SetOutput(surface)
    producer.UpdatePipeline()
    return producer


def output(proxy, port=0):
    """The data of a filter in this process."""
    proxy.UpdatePipeline()
    return proxy.GetClientSideObject().GetOutputDataObject(port)


def report(proxy):
    """The report's entries by name, as the Information panel has them."""
    data = output(proxy).GetFieldData()
    arrays = [data.GetAbstractArray(i) for i in range(data.GetNumberOfArrays())]
    return {array.GetName(): array.GetValue(0) for array in arrays if array.GetName().startswith("bonedecimate.")}
