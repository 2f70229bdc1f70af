# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""What the comparison with other readers found, each by a variant of its own (Testing/Formats/Volumes)."""

import os
import pathlib
import sys
import tempfile
import unittest

import numpy

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "Testing" / "Formats" / "Volumes"))
import comparison  # noqa: E402
import formats  # noqa: E402
import planted  # noqa: E402


class Variants(unittest.TestCase):
    def found(self, name, **choices):
        """What ours reads of the plainest variant with some other choices; it has to be what the generator wrote."""
        module = formats.FORMATS[name]
        choice = {**{key: values[0] for key, values in module.CHOICES.items()}, **choices}
        with tempfile.TemporaryDirectory(prefix="bonedecimate-test-") as folder:
            path, expected = module.write(pathlib.Path(folder), choice, numpy.random.default_rng(7))
            ours = comparison.read_ours(os.environ["DUMP_VOLUME"], [(path, expected)])[0]
        self.assertEqual(comparison.against_truth(ours, expected), [], choice)
        return ours

    def test_the_plainest_file_of_each_format_is_read(self):
        for name in formats.FORMATS:
            with self.subTest(format=name):
                self.assertFalse(isinstance(self.found(name), str))

    def test_the_origin_of_a_qform_has_the_unit_of_the_file(self):
        for unit in (1, 3):
            self.found("nifti", length=unit, sform=0, qform=1)

    def test_a_sheared_sform_of_the_scanner_is_the_position(self):
        for qform in (0, 1):
            self.found("nifti", axes="sheared", sform=1, qform=qform)

    def test_an_intercept_without_a_slope_does_not_count(self):
        self.found("nifti", scale=(0, 7))

    def test_voxels_that_begin_inside_the_header_are_rejected(self):
        self.assertIn("inside its header", self.found("nifti", offset="zero"))

    def test_units_of_axes_with_a_spacing_are_those_of_lengths(self):
        for unit in ("um", "cm", "m"):
            self.found("nrrd", geometry="spacings", units=unit)
        self.assertIn("unit", self.found("nrrd", geometry="spacings", units="furlong"))

    def test_bytes_are_skipped_in_packed_voxels(self):
        for encoding in ("raw", "gzip"):
            for skip in ("bytes", "lines", "both"):
                self.found("nrrd", encoding=encoding, skip=skip)
        self.found("nrrd", encoding="raw", skip="from the end")

    def test_voxels_of_nrrd_as_text_are_read(self):
        for type_ in ("uchar", "longlong", "ulonglong", "float", "double"):
            self.found("nrrd", encoding="ascii", type=type_)

    def test_voxels_packed_by_bzip2_are_rejected_as_such(self):
        self.assertIn("bzip2", self.found("nrrd", encoding="bzip2"))

    def test_a_fourth_dimension_is_named(self):
        self.assertIn("it has 4 dimensions", self.found("nrrd", axis="one behind"))
        self.assertIn("its NDims is 4", self.found("metaimage", dimensions="4 with one"))

    def test_units_that_metaio_does_not_know_are_read(self):
        self.found("metaimage", units="m")
        self.assertIn("its unit of length is 'inch'", self.found("metaimage", units="inch"))

    def test_whole_numbers_of_32_bits_in_strips_are_read(self):
        for type_ in ("u4", "i4"):
            for layout in ("one strip", "rows of two", "a row a strip", "tiles"):
                for input_ in ("pages", "folder"):
                    self.found("tiff", type=type_, layout=layout, input=input_)

    def test_pages_of_64_bits_are_rejected_as_such(self):
        self.assertIn("8, 16 or 32 bits", self.found("tiff", type="f8"))

    def test_padding_is_found_with_every_slope_and_order_of_its_range(self):
        for padding in ("value", "range", "range backward", "signed as US"):
            for rescale in (("1", "-1024"), ("0.5", "-10"), ("-1", "5"), None):
                for modality in ("CT", "MR"):
                    self.found("dicom", padding=padding, rescale=rescale, modality=modality, pixels="16 signed")

    def test_planted_bugs_have_their_code(self):
        for bug in planted.BUGS:
            text = (ROOT / "Applications" / "Volume" / bug.file).read_text(encoding="utf-8")
            self.assertEqual(len(planted.pattern_of(bug.old).findall(text)), 1, bug.name)


if __name__ == "__main__":
    unittest.main(verbosity=2)
