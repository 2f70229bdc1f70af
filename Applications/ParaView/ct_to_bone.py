# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""From a CT to a small bone surface, a picture of it and a state to go on from in ParaView.

    pvpython ct_to_bone.py PLUGIN.so CT.mha FOLDER [ISO] [MAXIMUM_ERROR]

PLUGIN.so is the plugin BoneDecimate; ISO is the contour value, 226 HU by default; MAXIMUM_ERROR is in mm, 0.3 by default. Into
FOLDER go bone.vtp, bone.png (colored by the distance to the contour, mm) and bone.pvsm.
"""

import pathlib
import sys

from paraview import simple


def bone_of(ct, iso, error):
    """The pipeline: CT, contour, decimation."""
    volume = simple.OpenDataFile(str(ct))
    volume.UpdatePipeline()
    name = volume.PointData.keys()[0]
    contour = simple.Contour(Input=volume, ContourBy=["POINTS", name], Isosurfaces=[iso], ComputeNormals=0, ComputeScalars=0)
    return simple.BoneDecimate(registrationName="Bone", Input=contour, MaximumError=error)


def show(bone, picture):
    """Renders the bone, colored by its distance to the contour, and its edges."""
    view = simple.GetActiveViewOrCreate("RenderView")
    view.ViewSize = [1000, 800]
    view.OrientationAxesVisibility = 0
    shown = simple.Show(bone, view)
    shown.SetRepresentationType("Surface With Edges")
    simple.ColorBy(shown, ("POINTS", "Distance (mm)"))
    shown.SetScalarBarVisibility(view, True)
    view.ResetActiveCameraToNegativeY()
    simple.ResetCamera(view)
    simple.SaveScreenshot(str(picture), view, ImageResolution=[1000, 800])


def main(plugin, ct, folder, iso="226", error="0.3"):
    folder = pathlib.Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    simple.LoadPlugin(plugin, remote=False, ns=vars(simple))
    bone = bone_of(pathlib.Path(ct).resolve(), float(iso), float(error))
    bone.UpdatePipeline()
    report = bone.GetDataInformation().GetFieldDataInformation()
    before, after, proved = (report.GetArrayInformation("bonedecimate." + name).GetComponentRange(0)[0]
                             for name in ("input.triangles", "output.triangles", "proof.if_unchanged.upper"))
    print(f"{before:.0f} triangles -> {after:.0f}, no point farther than {proved:.3f} mm")
    simple.SaveData(str(folder / "bone.vtp"), proxy=bone)  # first: it needs no screen
    show(bone, folder / "bone.png")
    simple.SaveState(str(folder / "bone.pvsm"))


if __name__ == "__main__":
    main(*sys.argv[1:])
