# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Images of SimpleITK and nibabel as label maps: the same surfaces as of the array, in LPS."""

import unittest
import warnings

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

    def test_labels_outlive_their_image(self):
        kept = [LabelMap.from_image(simpleitk()) for _ in range(20)]  # their images are gone
        for label_map in kept:
            np.testing.assert_array_equal(label_map.labels, halves())

    def test_are_label_maps_of_every_function(self):
        for image in (simpleitk(), nibabel.Nifti1Image(halves().transpose(), affine())):
            small = bonedecimate.decimate(*self.expected, label_map=image, keep_voxels="On", target_reduction=0.5,
                                          boundary_labels=self.expected.boundary_labels)
            self.assertEqual(small.report["voxels.changed"], 0)
            self.assertEqual(bonedecimate.check_voxels(small, image).changed, 0)
            certificate = bonedecimate.certify(self.expected, small, label_map=image)
            self.assertEqual(certificate.voxels.changed, 0)

    def test_have_one_position_of_two_as_the_program_has(self):
        moved = affine()
        moved[0, 3] += 100
        image = nibabel.Nifti1Image(halves().transpose(), moved)
        for s_code, q_code, expected in ((2, 1, affine()), (2, 0, moved), (1, 1, moved), (0, 1, affine())):
            image.set_qform(affine(), q_code)
            image.set_sform(moved, s_code)
            image = nibabel.Nifti1Image(image.dataobj, None, image.header)
            image = nibabel.Nifti1Image.from_bytes(image.to_bytes())
            with warnings.catch_warnings(record=True) as told:
                warnings.simplefilter("always")
                grid = LabelMap.from_image(image).grid
            np.testing.assert_allclose(grid.origin, (RAS @ expected)[:3, 3], atol=1e-4)
            self.assertEqual(["sform and qform are up to 100" in str(one.message) for one in told], [True] if (s_code, q_code) == (2, 1) else [])

    def test_without_a_position_lie_as_in_the_program_and_say_so(self):
        image = nibabel.Nifti1Image(halves().transpose(), None)
        image.header.set_zooms(SPACING)
        image = nibabel.Nifti1Image.from_bytes(image.to_bytes())
        with self.assertWarnsRegex(UserWarning, "does not say how the patient lies"):
            grid = LabelMap.from_image(image).grid
        np.testing.assert_array_equal(grid.direction, np.eye(3))
        np.testing.assert_array_equal(grid.origin, np.zeros(3))

    def test_in_other_units_are_converted_to_millimeters(self):
        for unit, millimeters in (("micron", 0.001), ("meter", 1000)):
            image = nibabel.Nifti1Image(halves().transpose(), affine())
            image.header.set_xyzt_units(unit)
            with self.assertWarnsRegex(UserWarning, f"its unit is the {unit}"):
                grid = LabelMap.from_image(image).grid
            np.testing.assert_allclose(grid.spacing, millimeters * np.array(SPACING), rtol=1e-6)
            np.testing.assert_allclose(grid.origin, millimeters * np.array(ORIGIN), rtol=1e-6)

    def test_with_a_slope_are_rounded_and_with_one_volume_are_label_maps(self):
        scaled = nibabel.Nifti1Image(halves().transpose() * np.float64(1.000015), affine())
        with self.assertWarnsRegex(UserWarning, "whole numbers but for rounding"):
            np.testing.assert_array_equal(LabelMap.from_image(scaled).labels, halves())
        series = nibabel.Nifti1Image(halves().transpose()[..., None], affine())
        np.testing.assert_array_equal(LabelMap.from_image(series).labels, halves())

    def test_cosines_of_four_decimals_are_perpendicular_axes(self):
        matrix = affine()
        matrix[:3, :3] = np.round(RAS[:3, :3] @ DIRECTION, 4) * SPACING
        grid = LabelMap.from_image(nibabel.Nifti1Image(halves().transpose(), matrix)).grid
        np.testing.assert_allclose(grid.direction, DIRECTION, atol=1e-4)
        np.testing.assert_allclose(grid.direction.T @ grid.direction, np.eye(3), atol=1e-12)

    def test_arrays_with_an_affine_matrix_and_no_axes_are_not_transposed_silently(self):
        with self.assertWarnsRegex(UserWarning, "axes is not given"):
            found = LabelMap(halves().transpose(), affine=np.eye(4))
        np.testing.assert_array_equal(found.labels, halves())
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            np.testing.assert_array_equal(LabelMap(halves(), axes="zyx", affine=np.eye(4)).labels, halves())
            np.testing.assert_array_equal(LabelMap(halves(), axes="zyx").labels, halves())

    def test_are_rejected_if_they_are_no_label_map(self):
        colors = SimpleITK.Image([4, 4, 4], SimpleITK.sitkVectorUInt8, 3)
        slice_ = SimpleITK.Image([4, 4], SimpleITK.sitkUInt8)
        series = nibabel.Nifti1Image(np.zeros((4, 4, 4, 2), np.int16), np.eye(4))
        flat = np.array([[1, 0, 1, 0], [0, 1, 1, 0], [0, 0, 1e-5, 0], [0, 0, 0, 1]])
        for image, says in ((colors, "3 values a voxel"), (slice_, "three dimensions, not 2"), (series, "not 4"),
                            (None, "not in one plane")):
            with self.assertRaisesRegex(ValueError, says):
                extract_surfaces(image) if image else LabelMap(halves(), axes="xyz", affine=flat)
        with self.assertRaisesRegex(TypeError, "one of VTK, SimpleITK, nibabel or MONAI, not int"):
            LabelMap.from_image(3)
        with self.assertRaisesRegex(ValueError, "their own"):
            extract_surfaces(simpleitk(), spacing=SPACING)


if __name__ == "__main__":
    unittest.main()
