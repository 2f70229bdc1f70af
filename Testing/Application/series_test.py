# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Which series of a folder is taken, files of it that are damaged, and what lies outside of the circle that a scanner measures."""

import json

import numpy

from application import REJECTED, USAGE, ApplicationTest, main, read
from volume_headers_test import images, nifti, slice_file

ISO = ("--iso", "bone", "--max-error", "halfvoxel", "--mode", "Fast", "--measure", "off")


class Series(ApplicationTest):
    def write_series(self, folder, count=24, series="1", description="", offset=0, **keywords):
        self.path(folder).mkdir(parents=True, exist_ok=True)
        more = {(8, 0x103e): ("LO", description)} if description else {}
        for k, image in enumerate(images(24)[:count]):
            data = slice_file(image, k + offset, k, series=series, more={**more, **keywords.get("more", {})})
            self.path(f"{folder}/IM{k + 1:04d}.dcm").write_bytes(data)

    def setUp(self):
        super().setUp()
        self.write_series("cd/S1/S20", description="Bone 1.0 H70")
        self.write_series("cd/S1/S10", 20, "5", "Soft tissue 1.0 B30", 500)
        self.write_series("cd/S2", 12, "7", "Bone 3.0", 900)

    def low(self, *words, name="cd", output="out.vtp"):
        """The lowest z of the surface, and what the program says."""
        text = self.succeed(name, output, *ISO, *words).stdout
        return read(self.path(output)).GetBounds()[4], text

    def test_the_series_that_is_named_is_taken(self):
        for choice, z, number in (("1", 3.5, 1), ("2", 503.5, 2), ("3", 903.5, 3), ("1.9.7", 903.5, 3), ("soft TISSUE 1.0 b30", 503.5, 2),
                                  ("h70", 3.5, 1), ("Bone 3", 903.5, 3)):
            with self.subTest(choice=choice):
                low, text = self.low("--series", choice, "--report", "report.json")
                self.assertAlmostEqual(low, z, delta=0.6)
                self.assertIn(f"note: series {number} of 3 is taken, as --series says: ", text)
                self.assertNotIn("warning", text)
                self.assertNotRegex(json.dumps(self.report()["warnings"]), "Bone|tissue|1\\.9\\.")
                self.assertIn(choice, json.dumps(self.report()["command_line"], ensure_ascii=False))
        low, text = self.low()
        self.assertAlmostEqual(low, 3.5, delta=0.6)
        self.assertIn("Of 3 series the one with 24 slices was taken in S1/S20; others, for --series: "
                      "2: 20 slices in S1/S10 from IM0001.dcm on, 3: 12 slices in S2 from IM0001.dcm on.", text)

    def test_an_impossible_choice_shows_the_list(self):
        listed = ("1: 24 slices in S1/S20 from IM0001.dcm on, 24 x 24, CT, 'Bone 1.0 H70'; 2: 20 slices in S1/S10 from IM0001.dcm on, 24 x 24, CT, "
                  "'Soft tissue 1.0 B30'; 3: 12 slices in S2 from IM0001.dcm on, 24 x 24, CT, 'Bone 3.0'")
        for choice, says in (("0", "it has no series '0'; its series are "), ("4", "it has no series '4'; its series are "),
                             ("head", "it has no series 'head'; its series are "), ("bone", "'bone' is in the description of 2 of its series: ")):
            self.fail_with(REJECTED, "cd", "out.vtp", *ISO, "--series", choice, says=says + listed)
        self.fail_with(REJECTED, "cd/S2", "out.vtp", *ISO, "--series", "2", says="it has no series '2'; its series are 1: 12 slices from")
        self.fail_with(USAGE, "cd", "out.vtp", *ISO, "--series", "", says="--series takes a number, a UID or a text")
        self.path("map.nii").write_bytes(nifti(numpy.stack(images()).astype(int) // 100))
        self.fail_with(USAGE, "map.nii", "out.vtp", *ISO, "--series", "1", says="--series has no effect; it is for folders of DICOM files")

    def test_descriptions_in_other_character_sets_can_be_named(self):
        more = {(8, 5): ("CS", "ISO_IR 100"), (8, 0x103e): ("LO", "Sch\u00e4del".encode("latin-1"))}
        self.write_series("cd/S3", 14, "8", offset=700, more=more)
        self.assertAlmostEqual(self.low("--series", "Sch\u00e4del")[0], 703.5, delta=0.6)

    def test_slabs_and_explanations_take_the_same_series(self):
        low, text = self.low("--series", "Bone 3", "--memory", "256M")
        self.assertAlmostEqual(low, 903.5, delta=0.6)
        self.assertIn("note: series 3 of 3 is taken", text)
        self.assertIn("12", self.succeed("cd/S2", "out.vtp", *ISO, "--series", "1", "--explain").stdout)

    def test_a_batch_takes_it_where_it_is_and_names_the_other_folders(self):
        text = self.succeed("cd", "out/", *ISO, "--series", "bone").stdout
        self.assertRegex(text, r"S10 +skipped .*it has no series 'bone'")
        self.assertIn("3 files: 2 done, 1 skipped", text)

    def test_a_damaged_file_is_named(self):
        whole = self.path("cd/S2/IM0003.dcm").read_bytes()
        says = "its file IM0003.dcm is damaged or truncated: copy it again, or move it to another folder to go on without it"
        for size in (132, 140, 200, 300):
            self.path("cd/S2/IM0003.dcm").write_bytes(whole[:size])
            self.fail_with(REJECTED, "cd/S2", "out.vtp", *ISO, says=says)
        for size in (500, len(whole) - 1200, len(whole) - 100):
            self.path("cd/S2/IM0003.dcm").write_bytes(whole[:size])
            self.assertRegex(self.fail_with(REJECTED, "cd/S2", "out.vtp", *ISO).stderr, "IM0003.dcm.* damaged or truncated.* copy it again")
        self.assertAlmostEqual(self.low()[0], 3.5, delta=0.6)  # the damaged file is one of another series
        self.path("cd/S2/IM0003.dcm").unlink()
        self.fail_with(REJECTED, "cd/S2", "out.vtp", *ISO, says="between IM0002.dcm and IM0004.dcm")


def view(constant, size=64, layers=12, radius=31.0, touching=False, empty=()):
    """HU of a scan in a circle, indices x, y, z: noise, a bone of 1200 that may end at the circle, the constant outside."""
    x, y, z = numpy.indices((size, size, layers))
    values = -1000 + (x * 7 + y * 13 + z * 5) % 40
    center = 8 if touching else size // 2
    values[(x - center) ** 2 + (y - size // 2) ** 2 < 64] = 1200
    values[(x - size // 2) ** 2 + (y - size // 2) ** 2 < 4] = 3071  # a metal of the constant's value
    values[numpy.hypot(x - (size - 1) / 2, y - (size - 1) / 2) > radius] = constant
    for layer in empty:
        values[:, :, layer] = constant
    return values


class FieldOfView(ApplicationTest):
    def surface(self, values, *words):
        matrix = numpy.diag([1.0, 1.0, 1.0, 1.0])
        self.path("ct.nii").write_bytes(nifti(values.astype(float), kind="<f4", matrix=matrix))
        text = self.succeed("ct.nii", "out.ply", *ISO, *words).stdout
        return self.path("out.ply").read_bytes(), text

    def test_a_constant_outside_of_the_circle_is_no_bone(self):
        plain = {touching: self.surface(view(-1000, touching=touching))[0] for touching in (False, True)}
        for constant in (3071, 32767, 226):
            for touching in (False, True):
                found, text = self.surface(view(constant, touching=touching))
                self.assertEqual(found, plain[touching])
                count = numpy.count_nonzero(view(-5000) == -5000)
                distances = numpy.hypot(*(numpy.indices((64, 64)) - 31.5))
                radius = distances[view(-5000)[:, :, 0] != -5000].max()
                self.assertIn(f"warning: {count} of its voxels, all outside of a circle with a radius of {radius:.4g} mm, have the constant value {constant}: "
                              "they were not measured and count as -1000, the least measured value", text)
                self.assertEqual(self.surface(view(constant, touching=touching), "--memory", "256M")[0], found)

    def test_the_circle_ends_anywhere_between_pixels(self):
        for radius in (24.3, 28.5, 29.7, 31.5):
            for touching in (False, True):
                found, text = self.surface(view(3071, radius=radius, touching=touching))
                self.assertEqual(found, self.surface(view(-1000, radius=radius, touching=touching))[0])
                self.assertIn(f"warning: {numpy.count_nonzero(view(-5000, radius=radius) == -5000)} of its voxels, all outside", text)

    def test_low_constants_are_as_before(self):
        for constant in (-2000, -3024, 0):
            self.assertNotIn("circle", self.surface(view(constant))[1])

    def test_layers_without_another_value_are_padding(self):
        found, text = self.surface(view(3071, empty=(0, 11)))
        self.assertIn("as do 2 layers that have no other value", text)
        self.assertEqual(found, self.surface(view(-1000, empty=(0, 11)))[0])

    def test_voxels_that_may_be_bone_stay(self):
        """Blocks around a hole that is no circle, has one value, is not centered, or ends in the volume; three corners; another constant in a layer."""
        whole = view(3071)
        x, y, _ = numpy.indices(whole.shape)
        square = numpy.where((abs(x - 31.5) < 22) & (abs(y - 31.5) < 22), whole, 3071)
        drilled = numpy.where(whole == 3071, 3071, 0)
        aside = numpy.roll(view(3071, radius=20), 10, axis=0)
        corner, layer, cone = whole.copy(), whole.copy(), whole.copy()
        corner[0, 0] = 3070
        layer[:, :, 5][layer[:, :, 5] == 3071] = 3000
        for k in range(12):
            cone[:, :, k][numpy.hypot(x[:, :, k] - 31.5, y[:, :, k] - 31.5) > 31 - 2 * k] = 3071
        for name, values in {"square": square, "drilled": drilled, "aside": aside, "corner": corner, "layer": layer, "cone": cone}.items():
            with self.subTest(name=name):
                self.assertNotIn("circle", self.surface(values, "--intensities", "on")[1])

    def test_padding_of_a_series_without_the_attribute(self):
        values = view(3000)
        self.path("ct").mkdir()
        for k in range(12):
            self.path(f"ct/{k:02d}.dcm").write_bytes(slice_file(values[:, :, k].T + 1024, k, k))
        self.assertIn("have the constant value 3000", self.succeed("ct", "out.ply", *ISO).stdout)
        self.assertRegex(self.succeed("certify", "ct", "out.ply", "--iso", "bone").stdout, r"(?m)^left out .*voxels")

    def test_a_scan_without_bone_inside_is_rejected(self):
        values = view(3071)
        values[(values > 0) & (values != 3071)] = 0
        values[30:34, 30:34] = 0
        self.path("ct.nii").write_bytes(nifti(values.astype(float), kind="<f4", matrix=numpy.eye(4)))
        says = "none of its voxels is above 226 HU but those outside of the circle that was measured: inside the values go from -1000 to 0"
        for words in ((), ("--memory", "256M")):
            self.fail_with(REJECTED, "ct.nii", "out.ply", *ISO, *words, says=says)


if __name__ == "__main__":
    main()
