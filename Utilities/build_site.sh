#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
#
# The documentation as a site: build/site/html/index.html. A broken link or an undocumented class fails.
# Needs doxygen and python3-venv (Utilities/install_packages.sh site); MkDocs comes from PyPI.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
readonly mkdocs_packages=(mkdocs==1.6.1 mkdocs-material==9.6.23)
readonly venv=build/site/venv pages=build/site/pages

rm -rf "$pages" build/site/html
mkdir -p "$pages"
# One folder of pages: links out of the root and into it become links between neighbors.
for page in README.md ARCHITECTURE.md CHANGELOG.md CONTRIBUTING.md Documentation/*.md; do
  sed -e 's#](Documentation/#](#g' -e 's#](\.\./#](#g' -e 's#](README\.md#](index.md#g' "$page" > "$pages/$(basename "$page")"
done
mv "$pages/README.md" "$pages/index.md"
cp -r Documentation/images Documentation/benchmark-data Documentation/*.ipynb LICENSE CITATION.cff "$pages"
doxygen Utilities/site/Doxyfile
printf '# Classes\n\n[The classes for VTK and the interface of the core](classes/index.html)\n' > "$pages/api.md"

if [ ! -x "$venv/bin/mkdocs" ]; then
  python3 -m venv "$venv"
  "$venv/bin/pip" --disable-pip-version-check --quiet install "${mkdocs_packages[@]}"
fi
NO_MKDOCS_2_WARNING=1 "$venv/bin/mkdocs" --quiet build --config-file Utilities/site/mkdocs.yml
echo "build/site/html/index.html"
