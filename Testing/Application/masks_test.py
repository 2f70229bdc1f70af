# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""A folder with a mask for each structure is one label map: the same bytes as the file with all labels."""

import csv
import re

import nibabel
import numpy as np

from application import REJECTED, ApplicationTest, main

SHAPE = (40, 36, 44)
AFFINE = np.diag([-0.8, -0.8, 1.5, 1.0])
NAMES = ("femur_left", "hip_left", "intervertebral_discs", "rib_left_1", "skull", "spleen", "vertebrae_L5")
BONES = [name for name in NAMES if name not in ("intervertebral_discs", "spleen", "rib_left_1")]
BOUND = ("--max-error", "halfvoxel", "--smooth", "auto", "--format", "stl")


def structures():
    """Balls that touch, by name; rib_left_1 is out of view."""
    i, j, k = np.indices(SHAPE)
    found = {name: np.zeros(SHAPE, bool) for name in NAMES}
    centers = {"femur_left": (10, 10, 12), "hip_left": (20, 10, 12), "intervertebral_discs": (28, 24, 30), "skull": (10, 24, 30),
               "spleen": (20, 24, 12), "vertebrae_L5": (19, 24, 30)}
    taken = np.zeros(SHAPE, bool)
    for name, (x, y, z) in centers.items():
        ball = ((i - x) ** 2 + (j - y) ** 2 + ((k - z) * 1.6) ** 2 < 49) & ~taken
        taken |= ball
        found[name] = ball
    return found


class Masks(ApplicationTest):
    def setUp(self):
        super().setUp()
        self.masks = structures()
        self.write_all("masks")

    def write(self, name, values, affine=AFFINE):
        path = self.path(name)
        path.parent.mkdir(parents=True, exist_ok=True)
        nibabel.save(nibabel.Nifti1Image(values, affine), path)

    def write_all(self, folder, values=np.uint8):
        for name, mask in self.masks.items():
            self.write(f"{folder}/{name}.nii.gz", mask.astype(values))

    def files(self, folder):
        return {path.stem: path.read_bytes() for path in sorted(self.path(folder).glob("*.stl"))}

    def test_all_structures_are_those_of_the_file_with_all_labels(self):
        labels = np.zeros(SHAPE, np.uint8)
        for number, name in enumerate(NAMES, 1):
            labels[self.masks[name]] = number
        self.write("all.nii.gz", labels)
        self.path("names.txt").write_text("".join(f'{i} 255 0 0 1 1 1 "{name}"\n' for i, name in enumerate(NAMES, 1)), encoding="utf-8")
        said = self.succeed("masks", "of-masks/", "--segments", "all", *BOUND).stdout
        self.succeed("all.nii.gz", "of-file/", "--segments", "all", "--label-names", "names.txt", *BOUND)
        self.assertEqual(self.files("of-masks"), self.files("of-file"))
        self.assertEqual(sorted(self.files("of-masks")), sorted(set(NAMES) - {"rib_left_1"}))
        self.assertIn("no surface of 4 (rib_left_1): no voxel has this label", said)
        self.assertRegex(said, r"voxels +0 of [\d,]+ have another label")

    def test_values_and_types_of_masks_do_not_matter(self):
        self.write_all("floats", np.float64)
        for name, mask in self.masks.items():
            self.write(f"two-fifty-five/{name}.nii.gz", (255 * mask).astype(np.int16))
        for folder in ("masks", "floats", "two-fifty-five"):
            self.succeed(folder, f"of-{folder}/", "--segments", "all", "--target-reduction", "0.5", "--format", "stl")
        self.assertEqual(self.files("of-masks"), self.files("of-floats"))
        self.assertEqual(self.files("of-masks"), self.files("of-two-fifty-five"))

    def test_presets_choose_by_names(self):
        for words, wanted in (("bones", BONES), ("vertebrae", ["vertebrae_L5"]), ("pelvis", ["hip_left"]), ("skull,pelvis", ["hip_left", "skull"]),
                              ("spleen", ["spleen"]), ("Vertebrae,femur_left", ["femur_left", "vertebrae_L5"])):
            with self.subTest(words):
                self.succeed("masks", "out/", "--segments", words, "--target-reduction", "0.5", "--format", "stl")
                self.assertEqual(sorted(self.files("out")), wanted)
                for file in self.path("out").iterdir():
                    file.unlink()
        self.fail_with(REJECTED, "masks", "no/", "--segments", "rib", says="it has no segment 'rib'; its segments are ")

    def test_overlaps_are_counted_and_masks_that_were_not_chosen_cover_nothing(self):
        self.masks["hip_left"] |= self.masks["femur_left"]
        overlap = int(self.masks["femur_left"].sum())
        self.write_all("masks")
        said = self.succeed("masks", "out/", "--segments", "bones", "--target-reduction", "0.5", "--format", "stl").stdout
        self.assertIn(f"{overlap} of its voxels are in more than one segment and count as those of the last one", said)
        self.assertNotIn("femur_left", self.files("out"))
        self.succeed("masks", "femur/", "--segments", "femur_left", "--target-reduction", "0.5", "--format", "stl")
        self.assertEqual(list(self.files("femur")), ["femur_left"])

    def test_what_is_no_mask_is_rejected_by_name(self):
        self.write("masks/spleen.nii.gz", 2 * self.masks["spleen"].astype(np.uint8) + self.masks["skull"].astype(np.uint8))
        self.fail_with(REJECTED, "masks", "no/", "--segments", "all", says="spleen.nii.gz: it has more than one value besides 0")
        self.succeed("masks", "bones/", "--segments", "bones", "--target-reduction", "0.5")

    def test_segments_that_are_a_voxel_thin_are_named(self):
        labels = np.zeros(SHAPE, np.uint8)
        labels[5, 5, 5:35] = 1
        labels[15:30, 15:30, 10:30] = 2
        self.write("rods.nii.gz", labels)
        said = self.succeed("rods.nii.gz", "out/", "--segments", "all", "--target-reduction", "0.5").stdout
        self.assertRegex(said, r"warning: segment 1 is so thin that its surface has [3-6]\d % of the volume of its 30 voxels\n")
        self.assertNotIn("segment 2 is so thin", said)

    def test_folders_of_studies_stay_batches(self):
        for folder, names in (("cases", ("case_1", "case_2")), ("grids", ("left", "right"))):
            for number, name in enumerate(names):
                affine = AFFINE if folder == "cases" else AFFINE * np.array([1 + number, 1, 1, 1])
                self.write(f"{folder}/{name}.nii.gz", self.masks["skull"].astype(np.uint8), affine)
            self.succeed(folder, f"out-{folder}/", "--segments", "all", "--target-reduction", "0.5", "--format", "stl")
            self.assertEqual(sorted(entry.name for entry in self.path(f"out-{folder}").iterdir() if entry.is_dir()), list(names))

    def test_each_patient_of_a_batch_may_have_a_folder_of_masks(self):
        for patient in ("a", "b"):
            for name in ("skull", "hip_left"):
                self.write(f"patients/{patient}/{name}.nii.gz", self.masks[name].astype(np.uint8))
        self.succeed("patients", "out/", "--segments", "bones", *BOUND)
        with open(self.path("out/segments.csv"), newline="", encoding="utf-8") as file:
            rows = list(csv.DictReader(file))
        self.assertEqual([(row["name"], row["segment"]) for row in rows], [(patient, name) for patient in "ab" for name in ("hip_left", "skull")])
        for row in rows:
            voxels = int(self.masks[row["segment"]].sum())
            self.assertEqual(int(row["voxels"]), voxels)
            size = voxels * abs(np.linalg.det(AFFINE))
            self.assertAlmostEqual(float(row["volume_in_mm3"]), size, delta=0.1 * size)
            self.assertAlmostEqual(float(row["volume_out_mm3"]), size, delta=0.1 * size)
            self.assertGreater(float(row["thickness_in_mm"]), 0)
            self.assertEqual((row["voxels_lost"], row["voxels_gained"]), ("0", "0"))
        self.path("out/segments.csv").unlink()
        page = self.path("out/summary.html").read_text(encoding="utf-8")
        for link in re.findall(r'href="([^"]+)"', page):
            self.assertTrue(self.path("out").joinpath(link).is_file(), link)
        self.assertIn('href="a/index.html"', page)
        self.succeed("summary", "out")
        self.assertEqual(self.path("out/summary.html").read_text(encoding="utf-8"), page)
        self.assertTrue(self.path("out/segments.csv").exists())
        (skull,) = self.path("out/a").glob("skull.*")
        skull.rename(self.path("away"))
        self.assertEqual(self.run_program("summary", "out").returncode, REJECTED)
        self.assertIn("the surfaces changed after the report", self.path("out/summary.csv").read_text(encoding="utf-8"))
        self.path("away").rename(skull)
        for patient in ("a", "b"):
            self.assertEqual(list(self.files(f"out/{patient}")), ["hip_left", "skull"])


if __name__ == "__main__":
    main()
