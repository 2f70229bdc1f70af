# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Every output is there whole or not at all."""

import os
import resource
import shutil
import subprocess

from application import (
    NOT_WRITTEN,
    PROGRAM,
    SURFACES,
    UNMEASURED,
    ApplicationTest,
    limit,
    main,
    read,
    torus,
    write,
)


class OutputFiles(ApplicationTest):
    def setUp(self):
        super().setUp()
        write(torus(), self.path("in.ply"))

    def test_full_disk_leaves_nothing(self):
        for target in SURFACES:
            for size in (0, 4096, 20000):
                with self.subTest(target=target, size=size):
                    words = ("in.ply", "out." + target, "--target-triangles", 1900, *UNMEASURED)
                    self.fail_with(NOT_WRITTEN, *words, says="out.", preexec_fn=limit(resource.RLIMIT_FSIZE, size))

    def test_full_disk_for_the_last_file_leaves_none_of_them(self):
        words = ("in.ply", "out.stl", "--target-triangles", 40, "--report", "report.json", "--heatmap", "heat.vtp")
        self.fail_with(NOT_WRITTEN, *words, preexec_fn=limit(resource.RLIMIT_FSIZE, 15000))

    def test_small_file_system(self):
        """A real one where one can be mounted, otherwise the limit of a file's size."""
        self.path("disk").mkdir()
        run = '"$0" in.ply disk/out.vtk --target-triangles 1900 --measure off; code=$?; ls -A disk; exit $code'
        mount = "mount -t tmpfs -o size=16k tmpfs disk && " + run
        small = ["unshare", "--mount", "--map-root-user", "sh", "-c", mount, PROGRAM]
        if subprocess.run(small[:3] + ["true"], stderr=subprocess.DEVNULL, check=False).returncode != 0:
            small = ["sh", "-c", "ulimit -f 32; " + run, PROGRAM]
        completed = subprocess.run(small, cwd=self.folder, capture_output=True, encoding="utf-8", check=False)
        self.assertEqual(completed.returncode, NOT_WRITTEN, completed.stderr)
        self.assertEqual(completed.stdout, "")
        self.assertRegex(completed.stderr, r"\Abonedecimate: could not write 'disk/out.vtk': [^\n]+\n\Z")

    def test_failed_run_leaves_the_older_output(self):
        self.path("out.vtp").write_text("of yesterday")
        self.fail_with(
            NOT_WRITTEN, "in.ply", "out.vtp", "--target-triangles", 1900, *UNMEASURED, preexec_fn=limit(resource.RLIMIT_FSIZE, 4096)
        )
        self.assertEqual(self.path("out.vtp").read_text(), "of yesterday")

    def test_output_replaces_an_older_one(self):
        self.path("out.vtp").write_text("of yesterday")
        self.succeed("in.ply", "out.vtp", "--target-triangles", 700, *UNMEASURED)
        self.assertEqual(read(self.path("out.vtp")).GetNumberOfPolys(), 700)

    def test_link_stays_a_link(self):
        self.path("store").mkdir()
        self.path("store/real.vtp").write_text("of yesterday")
        self.path("out.vtp").symlink_to("store/real.vtp")
        self.succeed("in.ply", "out.vtp", "--target-triangles", 700, *UNMEASURED)
        self.assertTrue(self.path("out.vtp").is_symlink())
        self.assertEqual(read(self.path("store/real.vtp")).GetNumberOfPolys(), 700)

    def test_files_get_the_permissions_of_any_other_file(self):
        self.succeed("in.ply", "out.vtp", "--report", "report.json", *UNMEASURED, preexec_fn=lambda: os.umask(0o027))
        for name in ("out.vtp", "report.json"):
            self.assertEqual(self.path(name).stat().st_mode & 0o777, 0o640)

    def test_same_input_gives_the_same_bytes(self):
        for target in SURFACES:
            if target in ("vtp", "vtk"):
                continue  # they hold the seconds of the run
            self.succeed("in.ply", "a." + target, "--threads", 1, *UNMEASURED)
            self.succeed("in.ply", "b." + target, "--threads", 3, *UNMEASURED)
            self.assertEqual(self.path("a." + target).read_bytes(), self.path("b." + target).read_bytes())

    def test_page_holds_the_picture_and_the_notice(self):
        self.succeed("in.ply", "out.vtp", "--page", "page.html", "--picture", "picture.png")
        page = self.path("page.html").read_text(encoding="utf-8")
        self.assertIn("not a medical device", page)
        self.assertIn("data:image/png;base64,", page)
        self.assertTrue(self.path("picture.png").read_bytes().startswith(b"\x89PNG"))

    def test_page_alone_leaves_no_picture_behind(self):
        self.succeed("in.ply", "out.vtp", "--page", "page.html")
        self.assertEqual(self.names(), ["in.ply", "out.vtp", "page.html"])
        self.assertIn("data:image/png;base64,", self.path("page.html").read_text(encoding="utf-8"))

    def test_without_any_display_everything_but_the_picture_is_written(self):
        nothing = {"PATH": str(self.folder), "HOME": str(self.folder)}
        program = shutil.which(PROGRAM) or PROGRAM
        completed = subprocess.run(
            [program, "in.ply", "out.vtp", "--page", "page.html"],
            cwd=self.folder, env=nothing, capture_output=True, encoding="utf-8", check=False,
        )
        self.assertEqual((completed.returncode, completed.stderr), (0, ""))
        self.assertIn("warning: the picture could not be drawn", completed.stdout)
        self.assertNotIn("data:image/png", self.path("page.html").read_text(encoding="utf-8"))
        completed = subprocess.run(
            [program, "in.ply", "b.vtp", "--picture", "picture.png"],
            cwd=self.folder, env=nothing, capture_output=True, encoding="utf-8", check=False,
        )
        self.assertEqual(completed.returncode, NOT_WRITTEN)
        self.assertIn("everything else is written", completed.stderr)
        self.assertEqual(self.names(), ["b.vtp", "in.ply", "out.vtp", "page.html"])


if __name__ == "__main__":
    main()
