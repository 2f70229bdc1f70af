# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Narrow tunnels closed on request: in summary, report and page."""

from application import REJECTED, ApplicationTest, main, torus, write

GAP = 25.0  # mm; the tunnel of the torus is 24 wide, its tube 16 thick


class Tunnels(ApplicationTest):
    def setUp(self):
        super().setUp()
        write(torus(), self.path("in.ply"))

    def test_none_is_closed_by_default(self):
        said = self.succeed("in.ply", "out.ply", "--report", "report.json", "--target-triangles", 300).stdout
        self.assertNotIn("tunnels", said)
        self.assertNotIn("tunnels", self.report())
        self.assertEqual(self.report()["output"]["euler_number"], 0)

    def test_what_was_closed_is_told_everywhere(self):
        words = ("--close-tunnels", GAP, "--report", "report.json", "--page", "page.html", "--max-error", 0.5)
        run = self.succeed("in.ply", "out.ply", *words)
        self.assertRegex(run.stdout, r"tunnels         1 closed, 0 left although narrow; handles 1 -> 0; the plugs are at most \d")
        self.assertIn("warning: 1 tunnel was closed, so there is bone where the input has none", run.stdout)
        report = self.report()
        self.assertEqual(report["output"]["euler_number"], 2)
        self.assertEqual((report["tunnels"]["closed"], len(report["tunnels"]["list"])), (1, 1))
        self.assertEqual(report["units"]["tunnels.distance"], "mm")
        self.assertEqual(report["proof"]["status"], "proved")
        page = self.path("page.html").read_text(encoding="utf-8")
        self.assertIn("Closed tunnels", page)
        self.assertIn("there is bone where the input has none", page)

    def test_what_does_not_go_with_it_is_rejected(self):
        self.fail_with(REJECTED, "in.ply", "out.ply", "--close-tunnels", GAP, "--keep-voxels", "On", says="--close-tunnels does not go with --keep-voxels")


if __name__ == "__main__":
    main()
