set(ZIG_PROCESSOR x86_64)
set(ZIG_TARGET linux-x86_64)
include("${CMAKE_CURRENT_LIST_DIR}/toolchain.cmake")
