# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Images of SimpleITK and nibabel as label maps: the same surfaces as of the array, in LPS."""

import unittest

import nibabel
import numpy as np
import SimpleITK

import bonedecimate
from bonedecimate import LabelMap, extract_surfaces
from labelmaps_test import ORIGIN, SPACING, halves

DIRECTION = np.array([[29, 28, 20], [-20, 35, -20], [-28, 4, 29]]) / 45  # a rotation
DIRECTION, _stretch = np.linalg.qr(DIRECTION)
RAS = np.diag([-1, -1, 1, 1])


def simpleitk():
    image = SimpleITK.GetImageFromArray(halves())
    image.SetSpacing(SPACING)
    image.SetOrigin(ORIGIN)
    image.SetDirection(DIRECTION.ravel().tolist())
    return image


def affine():
    matrix = np.eye(4)
    matrix[:3, :3], matrix[:3, 3] = DIRECTION * SPACING, ORIGIN
    return RAS @ matrix


class Scans(unittest.TestCase):
    def setUp(self):
        self.expected = extract_surfaces(halves(), spacing=SPACING, origin=ORIGIN, direction=DIRECTION)

    def test_have_the_surfaces_of_their_array_in_lps(self):
        for image in (simpleitk(), nibabel.Nifti1Image(halves().transpose(), affine()),
                      nibabel.Nifti1Image(halves().transpose().astype(np.float32), affine())):
            for found in (extract_surfaces(image), extract_surfaces(LabelMap.from_image(image))):
                np.testing.assert_allclose(found.points, self.expected.points, atol=1e-5)
                np.testing.assert_array_equal(found.triangles, self.expected.triangles)
                np.testing.assert_array_equal(found.boundary_labels, self.expected.boundary_labels)

    def test_are_label_maps_of_every_function(self):
        for image in (simpleitk(), nibabel.Nifti1Image(halves().transpose(), affine())):
            small = bonedecimate.decimate(*self.expected, label_map=image, keep_voxels="On", target_reduction=0.5,
                                          boundary_labels=self.expected.boundary_labels)
            self.assertEqual(small.report["voxels.changed"], 0)
            self.assertEqual(bonedecimate.check_voxels(small, image).changed, 0)
            certificate = bonedecimate.certify(self.expected, small, label_map=image)
            self.assertEqual(certificate.voxels.changed, 0)

    def test_are_rejected_if_they_are_no_label_map(self):
        colors = SimpleITK.Image([4, 4, 4], SimpleITK.sitkVectorUInt8, 3)
        slice_ = SimpleITK.Image([4, 4], SimpleITK.sitkUInt8)
        series = nibabel.Nifti1Image(np.zeros((4, 4, 4, 2), np.int16), np.eye(4))
        micrometers = nibabel.Nifti1Image(halves(), np.eye(4))
        micrometers.header.set_xyzt_units("micron")
        sheared = nibabel.Nifti1Image(halves(), np.array([[1, 0.3, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]))
        for image, says in ((colors, "3 values a voxel"), (slice_, "three dimensions, not 2"), (series, "not 4"),
                            (micrometers, "micron, not mm"), (sheared, "perpendicular")):
            with self.assertRaisesRegex(ValueError, says):
                extract_surfaces(image)
        with self.assertRaisesRegex(TypeError, "one of VTK, SimpleITK or nibabel, not int"):
            LabelMap.from_image(3)
        with self.assertRaisesRegex(ValueError, "their own"):
            extract_surfaces(simpleitk(), spacing=SPACING)


if __name__ == "__main__":
    unittest.main()
