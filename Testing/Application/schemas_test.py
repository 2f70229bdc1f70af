# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Files of --report and of certify --json are valid by the published schemas, by the library that users take."""

import json
import pathlib
import re

from jsonschema import Draft202012Validator
from vtkmodules.vtkFiltersSources import vtkSphereSource

from application import ApplicationTest, main, sphere, together, torus, write
from label_maps import blocks, write_map

ROOT = pathlib.Path(__file__).resolve().parents[2]
PAGES = [page for page in (ROOT / "Documentation").glob("*/*.md") if page.parent.name != "results"]
SCHEMAS = {name: json.loads((ROOT / "Documentation" / f"{name}.schema.json").read_text(encoding="utf-8")) for name in ("report", "certificate")}


def hemisphere():
    """With an open boundary."""
    source = vtkSphereSource()
    source.SetRadius(20.0)
    source.SetThetaResolution(40)
    source.SetPhiResolution(40)
    source.SetEndPhi(90.0)
    source.GenerateNormalsOff()
    source.Update()
    return source.GetOutput()


class Schemas(ApplicationTest):
    def validate(self, name, file):
        found = json.loads(self.path(file).read_text(encoding="utf-8"))
        problems = [f"{error.json_path}: {error.message}" for error in Draft202012Validator(SCHEMAS[name]).iter_errors(found)]
        self.assertEqual(problems, [])
        return found

    def test_are_schemas_themselves(self):
        for schema in SCHEMAS.values():
            Draft202012Validator.check_schema(schema)

    def test_have_every_key_that_a_page_names(self):
        schema, text = SCHEMAS["report"], json.dumps(SCHEMAS["report"])
        described = {key for key, value in schema["properties"].items() if "properties" in value or "$ref" in value}
        named = {(key, page.name) for page in PAGES for key in re.findall(r"`([a-z_]+(?:\.[a-z_]+)+)`", page.read_text(encoding="utf-8"))}
        named = {(key, page) for key, page in named if key.split(".")[0] in described and not re.search(r"\.of_|\.(?:vtp|json|csv|html)$", key)}
        self.assertGreater(len(named), 30)
        self.assertEqual([name for name in sorted(named) if any(f'"{word}"' not in text for word in name[0].split("."))], [])

    def test_describe_reports(self):
        write(together(torus(), sphere(8, center=60.0), hemisphere()), self.path("in.ply"))
        runs = (
            ("--max-error", 0.5, "--diagnose", "on", "--prune-size", 25, "--close-tunnels", 15),
            ("--profile", "FEM"),
            ("--max-error", 0.5, "--region", "rest=0", "--region", "sphere:0,20,0,6=0.3"),
            ("--mode", "Thesis", "--target-triangles", 700, "--measure", "off"),
            ("--max-error", 0.5, "--reference", "in.ply", "--unit", "cm", "--allow-large-error", "on"),
            ("--max-error", 0.5, "--smooth", 0.2),
        )
        for words in runs:
            with self.subTest(words):
                self.succeed("in.ply", "out.ply", *words, "--report", "report.json", "--quiet")
                self.validate("report", "report.json")

    def test_describe_reports_of_label_maps(self):
        write_map(blocks(5, 7), self.path("two.mha"))
        words = ("--segments", "all", "--max-error", 0.5, "--report", "report.json", "--quiet")
        self.succeed("two.mha", "bones", *words)
        self.assertEqual(len(self.validate("report", "report.json")["segments"]["list"]), 2)

    def test_describe_certificates(self):
        write(torus(), self.path("a.ply"))
        write(hemisphere(), self.path("open.ply"))
        write_map(blocks(5), self.path("one.mha"))
        self.succeed("certify", "a.ply", "a.ply", "--tolerance", 0.1, "--json", "c.json", "--quiet")
        self.validate("certificate", "c.json")
        self.succeed("certify", "open.ply", "open.ply", "--json", "c.json", "--quiet")
        self.validate("certificate", "c.json")
        self.run_program("certify", "a.ply", "--labels", "one.mha", "--json", "c.json", "--quiet")
        self.validate("certificate", "c.json")


if __name__ == "__main__":
    main()
