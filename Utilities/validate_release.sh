#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
#
# Bills of materials, CITATION.cff and the recipe for conda-forge against their schemas, by validators from PyPI.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/venv"
"$folder/venv/bin/pip" -q install --disable-pip-version-check "cyclonedx-python-lib[json-validation]==11.12.0" jsonschema PyYAML \
  py-rattler-build==0.73.0
# The schema alone: what cffconvert needs besides does not build for every Python.
"$folder/venv/bin/pip" -q install --disable-pip-version-check --no-deps cffconvert==2.0.0
for product in deb wheel wheel-windows wheel-program page browser; do
  python3 -B Utilities/third_party.py --sbom "$product" "$folder/$product.json"
done
python3 -B Utilities/submissions/write.py --repository https://host/a/b --slicer-repository https://host/a/c \
  --archive LICENSE --maintainer a --folder "$folder/submissions" >"$folder/written"
"$folder/venv/bin/python" - "$folder" <<'PYTHON'
import json
import pathlib
import sys
from importlib.util import find_spec

import jsonschema
import rattler_build
import yaml
from cyclonedx.schema import SchemaVersion
from cyclonedx.validation.json import JsonStrictValidator

problems = []
for file in sorted(pathlib.Path(sys.argv[1]).glob("*.json")):
    problem = JsonStrictValidator(SchemaVersion.V1_6).validate_str(file.read_text(encoding="utf-8"))
    problems += [f"{file.stem}: {problem}"] if problem else []
package = pathlib.Path(find_spec("cffconvert").submodule_search_locations[0])
schema = json.loads((package / "schemas/1.2.0/schema.json").read_text(encoding="utf-8"))
citation = yaml.load(pathlib.Path("CITATION.cff").read_text(encoding="utf-8"), Loader=yaml.BaseLoader)
problems += [f"CITATION.cff: {error.message}" for error in jsonschema.Draft7Validator(schema).iter_errors(citation)]
try:
    rattler_build.Stage0Recipe.from_file(f"{sys.argv[1]}/submissions/recipe.yaml")
except rattler_build.RecipeParseError as problem:
    problems.append(f"recipe.yaml: {problem}")
print("\n".join(problems) or "bills of materials, CITATION.cff and recipe are valid")
sys.exit(bool(problems))
PYTHON
