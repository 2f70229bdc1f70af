# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""What a mesh says is proved of it."""

import os
import pathlib
import sys
import tempfile
import unittest

import numpy as np
import pyvista as pv

sys.path.insert(0, str(pathlib.Path(os.environ["SOURCE_DIR"]) / "Applications" / "Slicer" / "BoneDecimator"))
from BoneDecimatorLib import surfaces as slicer  # noqa: E402


def bone():
    return pv.Sphere(radius=40, theta_resolution=80, phi_resolution=80)


class AProof(unittest.TestCase):
    def test_belongs_to_one_surface(self):
        small = bone().bone.decimate(max_error=0.2)
        self.assertRegex(small.bone.report["proof.sentence"], r"^at most 0\.\d+ mm in both directions$")
        with tempfile.TemporaryDirectory() as folder:
            small.save(f"{folder}/small.vtp")
            self.assertEqual(pv.read(f"{folder}/small.vtp").bone.report, small.bone.report)
            scaled = small.scale(2.0)
            scaled.field_data.update(small.field_data)
            scaled.save(f"{folder}/scaled.vtp")
            changed = {"smooth": small.smooth(n_iter=20), "smooth_taubin": small.smooth_taubin(), "decimate": small.decimate(0.5),
                       "scale": scaled, "read again": pv.read(f"{folder}/scaled.vtp"), "clip": small.clip("x"),
                       "append": small + small.translate((90, 0, 0)), "flip": small.flip_normal([1, 0, 0]),
                       "subdivide": small.subdivide(1), "cap": small.clip("x").bone.cap("all")}
        for name, mesh in changed.items():
            report = mesh.bone.report
            with self.subTest(name):
                self.assertNotIn("proof.status", report)
                self.assertNotIn("proof.upper", report)
                if report:
                    self.assertRegex(report["proof.sentence"], "^nothing is proved of this surface")
        self.assertIn("proof.upper", small.copy().bone.report)

    def test_is_that_of_the_same_surface_for_3d_slicer(self):
        mesh = bone()
        mesh.points -= mesh.points[7]  # so that there are coordinates of -0 and 0
        small = mesh.bone.decimate(max_error=0.2)
        self.assertEqual(slicer.checksum_of(small), small.bone.report["output.checksum"])
        self.assertEqual(slicer.report_of(small)["proof"]["upper"], small.bone.report["proof.upper"])
        small.points[5] *= 1.5
        self.assertEqual(slicer.report_of(small)["proof"], {"sentence": small.bone.report["proof.sentence"]})

    def test_names_what_is_left_out(self):
        mesh = bone()
        far = mesh.n_points
        points = np.vstack([mesh.points, [[0, 0, 90]]]).astype(np.float32)
        faces = np.concatenate([mesh.faces, [2, 0, far]])
        broken = pv.PolyData(points, faces=faces, lines=[2, 1, far], verts=[1, 2])
        with self.assertWarnsRegex(UserWarning, "1 polygon of fewer than three different corners was left out"):
            report = broken.bone.decimate(max_error=0.2).bone.report
        self.assertEqual([report[f"left_out.{i}.kind"] for i in range(3)], ["polygons", "lines", "vertices"])
        self.assertGreater(report["left_out.1.distance"], 49)
        self.assertLessEqual(report["left_out.2.distance"], 0.2)
        self.assertRegex(report["proof.sentence"], r", but for 1 polygon of .*, up to .* mm away; and for 1 line \(cell 1\), up to .* mm away$")
        with self.assertWarns(UserWarning):
            recorded = broken.bone.levels(max_error=0.2).levels.result.report
        self.assertRegex(recorded["proof.sentence"], r", but for 1 polygon of .*, up to .* mm away; and for 1 line ")
        with self.assertWarns(UserWarning):
            certificate = broken.bone.certify(mesh)
        self.assertRegex(certificate.report["left_out.0.sentence"], "^1 polygon of fewer than three different corners of the reference")


if __name__ == "__main__":
    unittest.main()
