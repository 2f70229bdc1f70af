# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Names of files and folders in letters of any language."""

import csv

import vtk

import volumes_test
from application import OTHER_FORMATS, REJECTED, SURFACES, UNMEASURED, ApplicationTest, main, read, sphere, torus, write

NAME = "Kn\u00f6chel \u9aa8 \u043a\u043e\u0441\u0442\u044c"


class FileNames(ApplicationTest):
    def setUp(self):
        super().setUp()
        self.path(NAME).mkdir()

    def test_surfaces(self):
        for extension in SURFACES:
            source, target = f"{NAME}/{NAME}.{extension}", f"{NAME}/out {NAME}.{extension}"
            write(torus(), self.path(source))
            self.succeed(source, target, "--target-reduction", 0.5, "--report", f"{NAME}.json", *UNMEASURED)
            self.assertEqual(read(self.path(target)).GetNumberOfCells(), 960)
            self.assertEqual(self.report(f"{NAME}.json")["files"]["output"], f"out {NAME}.{extension}")

    def test_formats_for_the_web_and_for_printing(self):
        write(torus(), self.path(f"{NAME}.ply"))
        for extension in OTHER_FORMATS:
            target = f"{NAME}.{extension}"
            if "lacks" not in self.run_program("none.ply", target).stderr:
                self.succeed(f"{NAME}.ply", target, "--max-error", 1, *UNMEASURED)
                self.succeed("certify", f"{NAME}.ply", target, "--tolerance", 1)

    def test_volumes(self):
        writers = {"vti": vtk.vtkXMLImageDataWriter, "mha": vtk.vtkMetaImageWriter, "mhd": vtk.vtkMetaImageWriter,
                   "nii": vtk.vtkNIFTIImageWriter, "nii.gz": vtk.vtkNIFTIImageWriter}
        for extension, kind in writers.items():
            writer = kind()
            writer.SetFileName(str(self.path(f"{NAME}.{extension}")))
            writer.SetInputData(volumes_test.ball())
            writer.Write()
            self.succeed(f"{NAME}.{extension}", "out.ply", "--iso", 226, "--target-reduction", 0.2, *UNMEASURED)

    def test_segments(self):
        self.path(f"{NAME}.seg.nrrd").write_bytes(volumes_test.segmentation((1, 2)))
        self.succeed(f"{NAME}.seg.nrrd", f"{NAME}/", "--segments", "all", "--max-error", 1)
        for segment in self.report(f"{NAME}/report.json")["segments"]["list"]:
            self.assertGreater(read(self.path(f"{NAME}/{segment['file']}")).GetNumberOfCells(), 0)

    def test_batch(self):
        write(torus(), self.path(f"{NAME}/b {NAME}.stl"))
        write(sphere(), self.path(f"{NAME}/a.ply"))
        self.succeed(NAME, f"out {NAME}", "--only", f"b {NAME[:3]}*", "--target-reduction", 0.5, "--jobs", 2, *UNMEASURED)
        with open(self.path(f"out {NAME}/summary.csv"), newline="", encoding="utf-8") as file:
            self.assertEqual([(row["name"], row["status"]) for row in csv.DictReader(file)], [(f"b {NAME}", "done")])
        self.assertEqual(read(self.path(f"out {NAME}/b {NAME}.stl")).GetNumberOfCells(), 960)

    def test_settings_and_levels(self):
        write(torus(), self.path(f"{NAME}.ply"))
        self.path(f"{NAME}.toml").write_text("target-reduction = 0.5\n")
        self.succeed(f"{NAME}.ply", f"out {NAME}.ply", "--config", f"{NAME}.toml", *UNMEASURED)
        self.assertEqual(read(self.path(f"out {NAME}.ply")).GetNumberOfCells(), 960)
        self.succeed("levels", f"{NAME}.ply", "--record", f"{NAME}.log", "--triangles", 1200, "--coarsest", 1000, "--output", f"level {NAME}.ply")
        self.assertEqual(read(self.path(f"level {NAME}-1200.ply")).GetNumberOfCells(), 1200)

    def test_messages(self):
        self.fail_with(REJECTED, f"{NAME}.ply", "out.ply", says=f"'{NAME}.ply' was rejected: there is no such file")


if __name__ == "__main__":
    main()
