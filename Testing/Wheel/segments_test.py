# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Structures by name: of a folder of masks, a file, an image, a tensor as MONAI has it, and an array."""

import pathlib
import tempfile
import unittest
import warnings

import nibabel
import numpy as np
import SimpleITK

import bonedecimate
from bonedecimate import LabelMap, segments

AFFINE = np.diag([-0.8, -0.8, 1.5, 1.0])
AFFINE[:3, 3] = 10, 20, -30
NAMES = {1: "femur_left", 2: "hip_left", 3: "spleen"}
ERROR = {"max_error": 0.4}
UNCHANGED = {"target_reduction": 0}  # edits depend on the last bits of positions, which files round


def labels():
    """Two balls that touch, by x, y, z; label 3 is out of view."""
    i, j, k = np.indices((30, 24, 20))
    volume = np.zeros(i.shape, np.uint8)
    volume[(i - 9) ** 2 + (j - 12) ** 2 + (1.8 * (k - 10)) ** 2 < 60] = 1
    volume[((i - 20) ** 2 + (j - 12) ** 2 + (1.8 * (k - 10)) ** 2 < 60) & (volume == 0)] = 2
    return volume


class MetaTensorStandIn:
    """What a MetaTensor of MONAI has, without torch."""

    def __init__(self, values, affine, meta):
        self.values, self.affine, self.meta = values, affine, meta

    def detach(self):
        return self

    def cpu(self):
        return self.values


def tensor(space):
    affine = MetaTensorStandIn(np.diag([-1, -1, 1, 1]) @ AFFINE if space == "LPS" else AFFINE, None, None)
    return MetaTensorStandIn(labels()[np.newaxis], affine, {"space": space} if space else {})


class SegmentNames(unittest.TestCase):
    MAP = LabelMap(np.where(labels() == 2, 3, labels()) + 2 * (np.indices(labels().shape)[0] == 29).astype(np.uint8), axes="xyz")

    def test_none_replaces_another(self):
        with self.assertWarnsRegex(UserWarning, "labels 1 and 3 have the same name, 'a'; that of 3 is 'a_3_3' here"):
            found = segments(self.MAP, names={1: "a", 2: "a_3", 3: "a"})
        self.assertEqual({name: one.label for name, one in found.items()}, {"a": 1, "a_3": 2, "a_3_3": 3})

    def test_the_error_is_half_a_voxel_unless_there_is_a_goal(self):
        one, two = segments(self.MAP), segments(self.MAP, threads=1)
        self.assertEqual(one.result.proved_error, two.result.proved_error)
        self.assertTrue(np.isnan(segments(self.MAP, target_reduction=0.5).result.proved_error))

    def test_what_is_chosen_is_a_whole_number_and_there(self):
        with self.assertRaises(TypeError):
            segments(self.MAP, choose=[2.7])
        with self.assertRaisesRegex(ValueError, "no voxel belongs to femur"), self.assertWarns(UserWarning):
            segments(self.MAP, names={5: "femur"}, choose="femur")


class SegmentsTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        (self.folder / "masks").mkdir()
        for label, name in NAMES.items():
            nibabel.save(nibabel.Nifti1Image((labels() == label).astype(np.uint8), AFFINE), self.folder / f"masks/{name}.nii.gz")
        self.image = nibabel.Nifti1Image(labels(), AFFINE)
        nibabel.save(self.image, self.folder / "all.nii.gz")
        image = SimpleITK.ReadImage(str(self.folder / "all.nii.gz"))
        for key in image.GetMetaDataKeys():
            image.EraseMetaData(key)  # SimpleITK 2.5.7 ends Python where it writes those of NIfTI in Wine
        SimpleITK.WriteImage(image, str(self.folder / "all.mha"))

    def check_same(self, found, expected):
        self.assertEqual([segment.label for segment in found.values()], [segment.label for segment in expected.values()])
        for one, other in zip(found.values(), expected.values()):
            np.testing.assert_allclose(one.points, other.points, atol=1e-5)
            np.testing.assert_array_equal(one.triangles, other.triangles)

    def test_every_source_gives_the_same_structures(self):
        self.assertLessEqual(segments(self.folder / "masks", **ERROR).result.proved_error, 0.4)
        expected = segments(self.folder / "masks", **UNCHANGED)
        self.assertEqual(list(expected), ["femur_left", "hip_left"])
        self.assertEqual(expected.empty, ["spleen"])
        for source in (str(self.folder / "all.nii.gz"), self.folder / "all.mha", self.image, SimpleITK.ReadImage(str(self.folder / "all.mha")),
                       tensor("RAS"), tensor("LPS"), tensor(None), LabelMap.from_image(self.image)):
            found = segments(source, names=NAMES, **UNCHANGED)
            self.check_same(found, expected)
            self.assertEqual(list(found), list(expected))
        self.assertEqual(list(segments(labels().transpose(), **ERROR)), ["label_1", "label_2"])

    def test_the_default_keeps_every_voxel_and_smooths_within_half_of_one(self):
        found = segments(self.image)
        self.assertEqual(found.result.report["voxels.changed"], 0)
        self.assertLessEqual(found.result.proved_error, 0.4)

    def test_an_array_alone_is_told_to_have_an_order(self):
        array = labels()
        for make in (segments, bonedecimate.extract_surfaces):
            with self.assertWarnsRegex(UserWarning, "labels.z, y, x. with voxels of 1 mm; arrays of nibabel are labels.x, y, z."):
                make(array)
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            bonedecimate.extract_surfaces(array, axes="zyx", spacing=(1, 1, 2))
        with self.assertWarnsRegex(UserWarning, "labels.z, y, x.; arrays of nibabel are labels.x, y, z."):
            bonedecimate.extract_surfaces(array, spacing=(1, 1, 2))
        with self.assertRaisesRegex(TypeError, "takes an image or array; segments.path. reads files"):
            bonedecimate.extract_surfaces("map.nii.gz")

    def test_names_of_labels_that_no_voxel_has_are_told(self):
        with self.assertWarnsRegex(UserWarning, "names has labels that no voxel has: 9"):
            segments(self.image, names={9: "femur"})

    def test_names_may_be_keys_or_values(self):
        for names in ({"background": 0, "femur": 1, "hip": np.int64(2)}, {0: "background", 1: "femur", 2: "hip"}):
            found = segments(self.image, names=names, **ERROR)
            self.assertEqual(([(each.name, each.label) for each in found.values()], found.empty), ([("femur", 1), ("hip", 2)], []))
        for wrong in (["femur", "hip"], "femur", {"femur": "hip"}, {"1": "femur"}, {"femur": [1, 2]}, {1: 2}):
            with self.assertRaisesRegex(TypeError, "names is a dict from labels to names, .2: 'femur'., or from names to labels, not "):
                segments(self.image, names=wrong)
        with self.assertRaisesRegex(ValueError, "two names for one label"):
            segments(self.image, names={"femur": 1, "hip": 1})

    def test_unknown_names_and_positions_of_voxels_are_told(self):
        found = segments(self.image, names=NAMES, choose=[1, 2], **ERROR)
        for name in ("femurs", 2):
            with self.assertRaisesRegex(KeyError, f"is called '?{name}'?; there are femur_left, hip_left"):
                found[name]
        self.assertEqual((found.get("femurs"), "femurs" in found), (None, False))
        for where in ({"spacing": (1, 1, 2)}, {"affine": AFFINE}, {"axes": "zyx", "spacing": (1, 1, 2)}):
            with self.assertRaisesRegex(TypeError, f"segments takes no {', '.join(where)}: LabelMap.array, {list(where)[0]}=...."):
                segments(labels(), **where)

    def test_maps_without_a_label_are_named(self):
        for make in (segments, bonedecimate.extract_surfaces):
            with self.assertRaisesRegex(ValueError, "no label: every voxel is background"):
                make(LabelMap(np.zeros((4, 4, 4), np.uint8), axes="zyx"))
        with self.assertRaisesRegex(ValueError, "no voxel has label 9; there are 1, 2"):
            bonedecimate.extract_surfaces(LabelMap(labels(), axes="xyz"), labels=[9])
        for wrong in (1, "Labels"):
            with self.assertRaisesRegex(TypeError, "labels are a list of whole numbers"):
                bonedecimate.extract_surfaces(LabelMap(labels(), axes="xyz"), labels=wrong)

    def test_structures_are_chosen_by_name_and_label(self):
        for choice in (["hip_left"], [2], ["HIP_LEFT", "spleen"], "hip_left", 2):
            self.assertEqual(list(segments(self.folder / "masks", choose=choice, **ERROR)), ["hip_left"])
        for choice in (None, "bone"):
            with self.assertWarnsRegex(UserWarning, "labels 1 and 2 have the same name, 'bone'; that of 2 is 'bone_2' here"):
                found = segments(self.image, names={1: "bone", 2: "bone"}, choose=choice, **ERROR)
            self.assertEqual(list(found), ["bone", "bone_2"])
        with self.assertRaisesRegex(ValueError, "there is no structure 'rib'; there are femur_left, hip_left, spleen"):
            segments(self.folder / "masks", choose=["rib"])

    def test_meshes_of_other_packages_have_the_same_triangles(self):
        found = segments(self.image, names=NAMES, **ERROR)
        hip = found["hip_left"]
        self.assertEqual(found.to_pyvista().keys(), ["femur_left", "hip_left"])
        self.assertEqual(hip.to_pyvista().n_cells, len(hip.triangles))
        np.testing.assert_array_equal(hip.to_meshio().cells_dict["triangle"], hip.triangles)

    def test_masks_that_overlap_are_counted_and_others_rejected(self):
        both = ((labels() == 1) | (labels() == 2)).astype(np.uint8)
        nibabel.save(nibabel.Nifti1Image(both, AFFINE), self.folder / "masks/hip_left.nii.gz")
        with warnings.catch_warnings(record=True) as told:
            warnings.simplefilter("always")
            self.assertEqual(list(segments(self.folder / "masks", **ERROR)), ["hip_left"])
        self.assertIn(f"{int((labels() == 1).sum())} voxels are in more than one mask", str(told[0].message))
        nibabel.save(nibabel.Nifti1Image(labels(), AFFINE), self.folder / "masks/hip_left.nii.gz")
        with self.assertRaisesRegex(ValueError, "more than one value besides 0"):
            segments(self.folder / "masks")
        nibabel.save(nibabel.Nifti1Image(both, np.diag([2.0, 1.0, 1.0, 1.0])), self.folder / "masks/hip_left.nii.gz")
        with self.assertRaisesRegex(ValueError, "has another grid"):
            segments(self.folder / "masks")

    def test_tensors_without_one_channel_or_a_known_space_are_rejected(self):
        several = tensor("RAS")
        several.values = np.concatenate([several.values] * 2)
        with self.assertRaisesRegex(ValueError, "labels have one channel"):
            segments(several)
        with self.assertRaisesRegex(ValueError, "neither RAS nor LPS"):
            segments(tensor("scanner"))


if __name__ == "__main__":
    unittest.main()
