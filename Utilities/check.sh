#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
#
# Style and static checks, and the core's tests under sanitizers: the same for people and for CI.
#
#   Utilities/check.sh                     all of them
#   Utilities/check.sh format tidy ...     only these
#   Utilities/check.sh --fix               put the sources into the format
#
# format        clang-format 14, .clang-format; comments of C++ fill their lines, Utilities/check_comments.py
# tidy          clang-tidy 23 of PyPI, .clang-tidy, over Filters and Applications (needs build/release, configured), without what
#               only ParaView's own build compiles; what the build compiles together is checked together
# spelling      codespell with American spelling, and no unfinished work in comments
# ascii         sources are ASCII
# sizes         no file over 400 lines, no function over 60, no line of C++ over 100 columns
# words         terms of the field, Utilities/check_words.py
# release       versions, dates, placeholders, versions of tools, third-party software, Utilities/check_release.py
# architecture  includes follow the module table of ARCHITECTURE.md; headers include <cstdint> for their integers
# site          builds the documentation as a site: links, anchors, references of Python and C++ (Utilities/build_site.sh)
# sanitize      builds the core with the address and undefined-behavior sanitizers and runs those tests that together reach
#               98 % of the basic blocks that were recorded (select_sanitized_tests.py), the fuzzers' corpora and a few attacks.
#               The tests are those that build/release compiled. Left out are the checks for null pointers, which the address
#               sanitizer finds where they are read or written, and for alignment, and the checksums of whole runs
# sanitize_whole  all tests of the core with all of these sanitizers, in the tests, too: far longer, and only if it is named
# thread        the core's tests of several threads with the thread sanitizer: proved runs with their draft, the certificate,
#               smoothing, labels, on 1 to 8 threads; only if it is named
set -uo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.." || exit 1

readonly all_checks=(format spelling words ascii sizes release architecture site tidy sanitize)
readonly most_lines=400
readonly most_lines_of_a_function=60
readonly most_columns=100
jobs=$(nproc 2>/dev/null || echo 2)
readonly jobs

# Names of tracked and new files that match the patterns, without what git ignores.
files()
{
  git ls-files --cached --others --exclude-standard -- "$@" | while read -r file; do
    [ -f "$file" ] && echo "$file"
  done
}

cxx_files() { files '*.h' '*.cxx'; }
source_files() { files '*.h' '*.cxx' '*.cxx.in' '*.py' '*.py.in' '*.sh' '*.cmake' '*.cmake.in' '*CMakeLists.txt' '*.js' .ci/run; }

# The name of the tool, of version 14 if there is one; fails with a message without the tool.
tool()
{
  local name
  for name in "$1-14" "$1"; do
    if command -v "$name" >/dev/null; then
      echo "$name"
      return 0
    fi
  done
  echo "$1 is not installed; see Utilities for the packages" >&2
  return 1
}

check_format()
{
  local clang_format
  clang_format=$(tool clang-format) || return 1
  cxx_files | xargs "$clang_format" --style=file --dry-run --Werror --ferror-limit=3 &&
    cxx_files | xargs python3 -B Utilities/check_comments.py
}

fix_format()
{
  local clang_format
  clang_format=$(tool clang-format) || return 1
  cxx_files | xargs "$clang_format" --style=file -i
}

# An XML tag of 3D Slicer, names of variables and functions, and words that scripts here look for.
readonly allowed_spellings='acknowledgements,anyother,fo,judgement,lod,parm,nd,positionof,te'

check_spelling()
{
  local codespell unfinished
  codespell=$(tool codespell) || return 1
  files '*.h' '*.cxx' '*.in' '*.py' '*.sh' '*.js' '*.md' '*.txt' '*.cmake' '*.json' | grep -v -e '^Data/.*\.sha' -e 'package-lock\.json$' |
    xargs "$codespell" --builtin clear,rare,informal,en-GB_to_en-US \
      --ignore-words-list "$allowed_spellings" || return 1
  unfinished='\b(TO''DO|FIX''ME|XX''X|HA''CK)\b'
  if source_files | xargs grep -nE "$unfinished"; then
    echo "finish it, or explain why it is unfinished"
    return 1
  fi
}

check_ascii()
{
  ! source_files | xargs grep -nP '[^\x00-\x7F]'
}

# Lines of each function by ctags: name, file, first line, length.
function_sizes()
{
  cxx_files | ctags -L - -o - --langmap=C++:+.h --kinds-C++=f --fields=+ne --extras=-p 2>/dev/null
  files '*.py' | ctags -L - -o - --kinds-Python=fm --fields=+ne --extras=-p 2>/dev/null
}

check_sizes()
{
  local failed=0
  tool ctags >/dev/null || return 1
  source_files | xargs wc -l | awk -v most="$most_lines" '$2 != "total" && $1 > most {
    print $2 ": " $1 " lines, " most " are the most"; found = 1 } END { exit found }' || failed=1
  cxx_files | xargs awk -v most="$most_columns" 'length > most {
    print FILENAME ":" FNR ": " length " columns, " most " are the most"; found = 1 } END { exit found }' || failed=1
  function_sizes | awk -F '\t' -v most="$most_lines_of_a_function" '{
    first = last = 0
    for (i = 4; i <= NF; ++i) {
      if ($i ~ /^line:/) first = substr($i, 6)
      if ($i ~ /^end:/) last = substr($i, 5)
    }
    if (last - first + 1 > most) {
      print $2 ":" first ": " $1 " has " last - first + 1 " lines, " most " are the most"
      found = 1
    } } END { exit found }' || failed=1
  return $failed
}

check_words() { python3 -B Utilities/check_words.py; }

check_site() { quietly Utilities/build_site.sh; }

check_release() { python3 -B Utilities/check_release.py; }

check_architecture()
{
  if git grep -nE '\.dot\(' -- Filters/Core; then
    echo "use Dot of Surface.h: the order of additions of Eigen's dot depends on its version"
    return 1
  fi
  python3 -B Testing/Architecture/modules.py && python3 -B Testing/Architecture/modules.py --self-test
}

# From PyPI: Debian's version also analyzes all system headers and takes three times as long.
check_tidy()
{
  local tools=build/checks database=build/release
  if [ ! -x "$tools/bin/clang-tidy" ]; then
    python3 -m venv "$tools" && "$tools/bin/pip" -q install --disable-pip-version-check clang-tidy==23.1.4 || return 1
  fi
  if [ ! -f "$database/compile_commands.json" ]; then
    cmake --preset release >/dev/null || return 1
  fi
  rm -rf "$tools/joined" && mkdir -p "$tools/joined" || return 1
  # What other systems or options compile is not in this build.
  files 'Filters/*.cxx' 'Applications/*.cxx' ':!Applications/ParaView/*' ':!*/Windows/*' ':!*/NoPicture.cxx' |
    xargs Utilities/tidy_database.py "$database/compile_commands.json" "$tools/joined" >"$tools/joined.txt" || return 1
  xargs -P "$jobs" -n 1 "$tools/bin/clang-tidy" -p "$tools/joined" --quiet <"$tools/joined.txt" 2>/dev/null
}

# Runs quietly; shows the output only if it fails.
quietly()
{
  local output
  output=$("$@" 2>&1) || { echo "$output" | tail -n 100; return 1; }
}

# Usage: build_preset PRESET [ARGUMENTS TO CONFIGURE IT]
build_preset() { quietly cmake --preset "$@" && quietly cmake --build --preset "$1" --parallel "$jobs"; }

# The chosen tests of the core, a part of them on each processor.
run_chosen_tests()
{
  local program=build/sanitize-short/bin/BoneDecimateCoreTests filter unknown part running=() failed=0
  chosen_tests() { grep -v '^#' Testing/Coverage/sanitized_tests.txt; }
  unknown=$("$program" --gtest_list_tests | awk '/^[^ ]/ { suite = $1 } /^ / { print suite $1 }' |
    grep -vxFf /dev/stdin <(chosen_tests))
  if [ -n "$unknown" ]; then
    echo "Testing/Coverage/sanitized_tests.txt names tests that do not exist; Utilities/select_sanitized_tests.py chooses anew:"
    echo "$unknown"
    return 1
  fi
  filter=$(chosen_tests | paste -sd ':')
  for ((part = 0; part < jobs; ++part)); do
    GTEST_TOTAL_SHARDS=$jobs GTEST_SHARD_INDEX=$part quietly "$program" --gtest_brief=1 --gtest_filter="$filter" &
    running+=($!)
  done
  for part in "${running[@]}"; do
    wait "$part" || failed=1
  done
  return $failed
}

check_sanitize()
{
  local tests
  quietly Utilities/build_core_tests.sh && tests=$(Utilities/build_core_tests.sh 2>/dev/null) || return 1
  build_preset sanitize-short "-DBONEDECIMATE_TEST_TARGETS=$tests" && run_chosen_tests &&
    quietly ctest --preset sanitize-short --parallel "$jobs" --exclude-regex '^(Core|Checksums|Architecture)\.'
}

check_sanitize_whole() { build_preset sanitize && quietly ctest --preset sanitize --parallel "$jobs"; }

check_thread()
{
  quietly cmake --preset thread && quietly cmake --build --preset thread --parallel "$jobs" --target BoneDecimateCoreTests &&
    quietly build/thread/bin/BoneDecimateCoreTests --gtest_brief=1 \
      --gtest_filter='Draft.*:*NumberOfThreads*:*WhateverTheThreads*-Shapes/*'
}

main()
{
  local check start failed=()
  if [ "${1:-}" = --fix ]; then
    fix_format
    return
  fi
  if [ $# -eq 0 ]; then
    set -- "${all_checks[@]}"
  fi
  for check in "$@"; do
    if ! declare -F "check_$check" >/dev/null; then
      echo "no check '$check'; there are: ${all_checks[*]}" >&2
      return 2
    fi
  done
  for check in "$@"; do
    start=$SECONDS
    if "check_$check" </dev/null; then
      echo "check $check: passed ($((SECONDS - start)) s)"
    else
      echo "check $check: FAILED ($((SECONDS - start)) s)"
      failed+=("$check")
    fi
  done
  if [ ${#failed[@]} -gt 0 ]; then
    echo "failed: ${failed[*]}"
    return 1
  fi
}

main "$@"
