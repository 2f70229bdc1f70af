#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
#
# The documentation as a site: build/site/html/index.html. A warning fails: a broken link or anchor, a page to which
# Documentation/README.md has no link, an undocumented class or member of C++, a resource of another server.
# Needs doxygen and python3-venv (Utilities/install_packages.sh site); the generator comes from PyPI, and so do the wheel's
# packages, unless the tests have built the wheel already.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
readonly site=build/site venv=build/site/venv pages=build/site/pages requirements=Utilities/site/requirements.txt
export SOURCE_DIR=$PWD

wheel=build/release/wheel
if [ ! -d "$wheel/environment" ]; then
  wheel=$site/wheel
  [ -d "$wheel/environment" ] || PYTHON=python3 CI=true Testing/Wheel/install_wheel.sh "$PWD/$wheel"
fi
if ! cmp -s "$requirements" "$venv/requirements.txt"; then
  rm -rf "$venv"
  "$wheel/environment/bin/python" -m venv "$venv" # the same Python, because the reference imports the wheel
  "$venv/bin/pip" --disable-pip-version-check --quiet install --no-deps -r "$requirements"
  cp "$requirements" "$venv/requirements.txt"
fi
WHEEL_PACKAGES=$(echo "$PWD/$wheel"/environment/lib/python3*/site-packages)
export WHEEL_PACKAGES

# The pages lie in the site as in the project, so their links stay as they are. The paper has a form of its own.
rm -rf "$pages" "$site/files" "$site/html"
mkdir -p "$pages" "$site/files"
cp -r ./*.md LICENSE CITATION.cff Documentation Utilities/site/*.md "$pages"
rm -r "$pages/Documentation/paper"
echo '<meta http-equiv="refresh" content="0; url=Documentation/README.html">' > "$site/files/index.html"
doxygen Utilities/site/Doxyfile
"$venv/bin/sphinx-build" --jobs auto --quiet --fail-on-warning --keep-going -c Utilities/site -d "$site/doctrees" "$pages" "$site/html"
python3 -B Utilities/site/check_links.py "$site/html"
echo "$site/html/index.html"
