# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The example as people run it: CT, contour, decimation, picture, state. Needs a screen."""

import os
import pathlib
import subprocess
import sys
import unittest

from paraview import simple
from vtkmodules.vtkIOImage import vtkPNGReader

EXAMPLE = pathlib.Path(os.environ["SOURCE_DIR"]) / "Applications" / "ParaView"
FOLDER = pathlib.Path(os.environ["FOLDER"]) / "example"


def colors_of(picture):
    reader = vtkPNGReader()
    reader.SetFileName(str(picture))
    reader.Update()
    scalars = reader.GetOutput().GetPointData().GetScalars()
    return {scalars.GetTuple(i) for i in range(0, scalars.GetNumberOfTuples(), 7)}


class Example(unittest.TestCase):
    def test_ct_becomes_a_bone_a_picture_and_a_state_that_opens_again(self):
        FOLDER.mkdir(exist_ok=True)
        subprocess.run([os.environ["PHANTOM"], str(FOLDER / "ct.mha"), "--size", "small"], check=True)
        sys.path.insert(0, str(EXAMPLE))
        import ct_to_bone
        ct_to_bone.main(os.environ["PLUGIN"], str(FOLDER / "ct.mha"), str(FOLDER), error="0.3")
        bone = simple.FindSource("Bone")
        triangles = bone.GetDataInformation().GetNumberOfCells()
        self.assertLess(triangles, 0.3 * bone.Input.GetDataInformation().GetNumberOfCells())
        self.assertGreater(len(colors_of(FOLDER / "bone.png")), 300)
        self.assertTrue((FOLDER / "bone.vtp").is_file())
        for source in list(simple.GetSources().values()):
            simple.Delete(source)
        simple.LoadState(str(FOLDER / "bone.pvsm"))
        again = simple.FindSource("Bone")
        again.UpdatePipeline()
        self.assertEqual(again.GetDataInformation().GetNumberOfCells(), triangles)
        self.assertEqual(again.MaximumError, 0.3)
        # Without the plugin ParaView says what the documentation explains.
        page = " ".join((EXAMPLE.parents[1] / "Documentation" / "reference" / "paraview.md").read_text(encoding="utf-8").split())
        script = FOLDER / "without.py"
        script.write_text(f"from paraview.simple import LoadState\nLoadState({str(FOLDER / 'bone.pvsm')!r})\n", encoding="utf-8")
        opened = subprocess.run([os.environ["PVPYTHON"], str(script)], capture_output=True, text=True, check=False)
        for said in ("No proxy that matches: group=filters and proxy=BoneDecimate were found",
                     "Could not create a proxy of group: filters type: BoneDecimate"):
            self.assertIn(said, opened.stdout + opened.stderr)
            self.assertIn(said, page)


if __name__ == "__main__":
    if not os.environ.get("DISPLAY"):
        print("There is no screen: skipped.")
        sys.exit(77)
    unittest.main()
