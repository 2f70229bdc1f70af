# bonedecimate_add_suites(TARGET PREFIX [LABELS LABEL]): each suite of a GoogleTest program becomes a test of CTest, in parts of
# at most 25 cases. gtest_discover_tests would start a process for each of some 2,000 cases.
set(BONEDECIMATE_SUITE_SCRIPT "${CMAKE_CURRENT_LIST_DIR}/list_suites.cmake")
function (bonedecimate_add_suites target prefix)
  if (CMAKE_CROSSCOMPILING) # Utilities/check_wasm.sh and check_arm64.sh run the program
    return ()
  endif ()
  cmake_parse_arguments(PARSE_ARGV 2 suites "" "LABELS" "")
  set(file "${CMAKE_CURRENT_BINARY_DIR}/${target}_suites.cmake")
  add_custom_command(TARGET ${target} POST_BUILD BYPRODUCTS "${file}"
    COMMAND "${CMAKE_COMMAND}" "-DPROGRAM=$<TARGET_FILE:${target}>" "-DPREFIX=${prefix}" "-DLABELS=${suites_LABELS}" "-DFILE=${file}"
      -P "${BONEDECIMATE_SUITE_SCRIPT}" VERBATIM)
  # Until it is built there is one test, which fails.
  file(WRITE "${file}.in.cmake"
    "if (EXISTS \"${file}\")\n  include(\"${file}\")\nelse ()\n  add_test(${prefix}${target}_NOT_BUILT ${target})\nendif ()\n")
  set_property(DIRECTORY APPEND PROPERTY TEST_INCLUDE_FILES "${file}.in.cmake")
endfunction ()
