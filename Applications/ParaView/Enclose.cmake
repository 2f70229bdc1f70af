# Builds the plugin in a build tree of its own, with the objects of this build's core.
set(BONEDECIMATE_PARAVIEW AUTO CACHE STRING "Build the plugin for ParaView: ON, OFF, or AUTO where ParaView and its headers are found")
set_property(CACHE BONEDECIMATE_PARAVIEW PROPERTY STRINGS AUTO ON OFF)
if (NOT BONEDECIMATE_PARAVIEW)
  return ()
endif ()

# pvpython tells a whole ParaView from the parts of it that go with Debian's VTK.
set(BONEDECIMATE_PARAVIEW_PREFIX "${PROJECT_SOURCE_DIR}/build/paraview/usr" CACHE PATH
  "Where ParaView is installed; by default where Utilities/install_paraview.sh puts it")
find_program(BONEDECIMATE_PVPYTHON pvpython PATHS "${BONEDECIMATE_PARAVIEW_PREFIX}/bin" NO_DEFAULT_PATH)
file(GLOB configs
  "${BONEDECIMATE_PARAVIEW_PREFIX}/lib*/cmake/paraview-*/paraview-config.cmake"
  "${BONEDECIMATE_PARAVIEW_PREFIX}/lib/*/cmake/paraview-*/paraview-config.cmake")
if (NOT BONEDECIMATE_PVPYTHON OR NOT configs)
  if (BONEDECIMATE_PARAVIEW STREQUAL "ON")
    message(FATAL_ERROR "No ParaView with headers and Python in ${BONEDECIMATE_PARAVIEW_PREFIX} (BONEDECIMATE_PARAVIEW_PREFIX)")
  endif ()
  return ()
endif ()
list(GET configs 0 config)
cmake_path(GET config PARENT_PATH paraview_dir)
cmake_path(GET paraview_dir PARENT_PATH paraview_libraries)
cmake_path(GET paraview_libraries PARENT_PATH paraview_libraries)

# ParaView's tools find its libraries wherever it lies.
set(environment "${CMAKE_COMMAND}" -E env "LD_LIBRARY_PATH=${paraview_libraries}")
get_target_property(option_table option_table TABLE_FILE)
include(ExternalProject)
ExternalProject_Add(BoneDecimateParaView
  SOURCE_DIR "${CMAKE_CURRENT_LIST_DIR}"
  BINARY_DIR "${PROJECT_BINARY_DIR}/paraview"
  CONFIGURE_COMMAND ${environment} "${CMAKE_COMMAND}" -G "${CMAKE_GENERATOR}" -S <SOURCE_DIR> -B <BINARY_DIR>
    "-DCMAKE_BUILD_TYPE=${CMAKE_BUILD_TYPE}"
    "-DCMAKE_CXX_COMPILER=${CMAKE_CXX_COMPILER}"
    "-DCMAKE_CXX_FLAGS=${CMAKE_CXX_FLAGS}"
    "-DCMAKE_UNITY_BUILD=${CMAKE_UNITY_BUILD}"
    "-DCMAKE_UNITY_BUILD_BATCH_SIZE=${CMAKE_UNITY_BUILD_BATCH_SIZE}"
    "-DParaView_DIR=${paraview_dir}"
    "-DBONEDECIMATE_CORE_TARGETS=${core_targets}"
    "-DBONEDECIMATE_OPTION_TABLE=${option_table}"
    "-DPython3_EXECUTABLE=${Python3_EXECUTABLE}"
  BUILD_COMMAND ${environment} "${CMAKE_COMMAND}" --build <BINARY_DIR>
  INSTALL_COMMAND ""
  BUILD_ALWAYS ON
  USES_TERMINAL_BUILD ON)
add_dependencies(BoneDecimateParaView BoneDecimateCore option_table)

# For the tests.
set(BONEDECIMATE_PARAVIEW_PLUGIN "${PROJECT_BINARY_DIR}/paraview/${CMAKE_INSTALL_LIBDIR}/BoneDecimate/BoneDecimate.so")
set(BONEDECIMATE_PARAVIEW_LIBRARIES "${paraview_libraries}")
