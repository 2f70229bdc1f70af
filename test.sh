#!/usr/bin/env bash
# Builds the project and runs every test; installs what is missing for that.
set -euo pipefail
cd "$(dirname "$0")"

Utilities/install_packages.sh test
Utilities/build_release.sh
run=(ctest --preset release --parallel "$(getconf _NPROCESSORS_ONLN)")
# Image tests need a display.
if command -v xvfb-run > /dev/null; then
  # Without a reset: the server would start afresh whenever a test leaves it alone.
  run=(xvfb-run -a -s "-screen 0 1280x1024x24 -noreset" "${run[@]}")
fi
"${run[@]}"
