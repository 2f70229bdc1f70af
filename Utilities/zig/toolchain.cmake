# For any Linux since glibc 2.17, by zig (make_compiler.sh), with the static libraries of Utilities/build_libraries.sh. ZIG_PROCESSOR and ZIG_TARGET are set by the file that includes this.
get_filename_component(zig_build "${CMAKE_CURRENT_LIST_DIR}/../../build" ABSOLUTE)
set(CMAKE_C_COMPILER "${zig_build}/zig/${ZIG_PROCESSOR}-cc")
set(CMAKE_CXX_COMPILER "${zig_build}/zig/${ZIG_PROCESSOR}-c++")
set(CMAKE_AR "${zig_build}/zig/ar" CACHE FILEPATH "")
set(CMAKE_RANLIB "${zig_build}/zig/ranlib" CACHE FILEPATH "")
set(BONEDECIMATE_LIBRARIES "${zig_build}/libraries-${ZIG_TARGET}" CACHE PATH "What the program brings along")
set(CMAKE_C_FLAGS_INIT "-g0 -ffp-contract=off -ffunction-sections -fdata-sections") # the same bytes on every processor
set(CMAKE_CXX_FLAGS_INIT "${CMAKE_C_FLAGS_INIT} -Wno-deprecated-declarations") # of JSON's own templates, in headers of libc++
set(CMAKE_EXE_LINKER_FLAGS_INIT "-s -Wl,--gc-sections")
set(BUILD_SHARED_LIBS OFF CACHE BOOL "Static libraries")
set(CMAKE_FIND_ROOT_PATH "${BONEDECIMATE_LIBRARIES}")
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE ONLY)
# Headers alone, from the system.
set(Eigen3_DIR /usr/share/eigen3/cmake CACHE PATH "")
set(Eigen3_INCLUDE_DIR /usr/include/eigen3 CACHE PATH "") # as VTK finds it
