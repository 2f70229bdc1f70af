#!/usr/bin/env bash
# Builds the wheel from a clean copy of the tree and installs it twice.
#
#   install_wheel.sh FOLDER     FOLDER/environment  with VTK, PyVista and the rest from PyPI
#                               FOLDER/alone        the package alone, for a Python that has numpy and VTK
#
# Without PyPI that is skipped (77), except where CI=true says that it must be reached.
set -euo pipefail
folder=$1
source=$SOURCE_DIR
rm -rf "$folder"
mkdir -p "$folder/tree"

if ! "$PYTHON" -m venv "$folder/probe" || ! "$folder/probe/bin/pip" -q --retries 1 download --no-deps -d "$folder/probe" nanobind; then
  echo "The Python packages to build with cannot be had: no python3-venv, or PyPI is out of reach."
  [ "${CI:-}" = true ] && exit 1
  exit 77
fi

# What git knows or would know, as a fresh clone has it.
(cd "$source" && git -c safe.directory="$source" ls-files -z --cached --others --exclude-standard |
  tar --null --ignore-failed-read -T - -cf -) | tar -xf - -C "$folder/tree"
PYTHON=$PYTHON "$folder/tree/Utilities/build_wheel.sh" "$folder/dist"
wheel=$(echo "$folder"/dist/bonedecimate-*.whl)
"$PYTHON" -m venv "$folder/environment"
"$folder/environment/bin/pip" -q install --disable-pip-version-check "$wheel[pyvista,progress,files]" \
  highdicom nibabel pydicom pynrrd SimpleITK tifffile # images, for tests alone
"$folder/environment/bin/pip" -q install --disable-pip-version-check --no-deps --target "$folder/alone" "$wheel"
