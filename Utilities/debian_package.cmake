# What `cpack` makes in the build folder: a package for the Debian that it was built on. Libraries it needs are found by
# dpkg-shlibdeps (dpkg-dev).
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME vtkbonedecimate)
# As Debian's tools take it: the maintainer of a package is the one that builds it.
set(CPACK_PACKAGE_CONTACT "vtkBoneDecimate contributors")
if (DEFINED ENV{DEBEMAIL})
  set(maintainer "vtkBoneDecimate contributors")
  if (DEFINED ENV{DEBFULLNAME})
    set(maintainer "$ENV{DEBFULLNAME}")
  endif ()
  set(CPACK_PACKAGE_CONTACT "${maintainer} <$ENV{DEBEMAIL}>")
endif ()
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "Bone surfaces with fewer triangles, and the proved error in millimeters")
set(CPACK_DEBIAN_PACKAGE_DESCRIPTION
  "Makes surfaces of bone from CT smaller by edge collapse and proves, in\n millimeters, how far the result is from the \
input.\n .\n The program bonedecimate, the VTK filter vtkBoneDecimate with its headers and\n CMake package, and the Python \
package bonedecimate. Not a medical device.")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS "${CMAKE_LIBRARY_OUTPUT_DIRECTORY}")
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS python3-vtk9)
set(CPACK_DEBIAN_PACKAGE_SUGGESTS libvtk9-dev)
# Files that Python compiles there belong to no package and would remain.
file(CONFIGURE OUTPUT "${PROJECT_BINARY_DIR}/debian/prerm" @ONLY CONTENT [[#!/bin/sh
set -e
rm -rf "/usr/@CMAKE_INSTALL_LIBDIR@/python3/dist-packages/bonedecimate/__pycache__"
]])
file(CHMOD "${PROJECT_BINARY_DIR}/debian/prerm"
  PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_DEBIAN_PACKAGE_CONTROL_EXTRA "${PROJECT_BINARY_DIR}/debian/prerm")
# What others wrote of it.
find_package(Python3 COMPONENTS Interpreter)
if (Python3_Interpreter_FOUND)
  set(sbom "${PROJECT_BINARY_DIR}/debian/sbom.cdx.json")
  add_custom_command(OUTPUT "${sbom}"
    COMMAND "${Python3_EXECUTABLE}" -B "${PROJECT_SOURCE_DIR}/Utilities/third_party.py" --sbom deb "${sbom}"
    DEPENDS "${PROJECT_SOURCE_DIR}/Utilities/third_party.py" "${PROJECT_SOURCE_DIR}/Utilities/third_party.json"
      "${PROJECT_SOURCE_DIR}/Applications/Picture/Viewer/package-lock.json"
    VERBATIM)
  add_custom_target(bonedecimate_sbom ALL DEPENDS "${sbom}")
  install(FILES "${sbom}" DESTINATION "${CMAKE_INSTALL_DATADIR}/doc/vtkbonedecimate")
else ()
  message(STATUS "No Python: the Debian package has no bill of materials")
endif ()
install(FILES "${PROJECT_SOURCE_DIR}/Applications/Picture/Viewer/LICENSES.txt" DESTINATION "${CMAKE_INSTALL_DATADIR}/doc/vtkbonedecimate")
install(FILES "${PROJECT_SOURCE_DIR}/LICENSE" DESTINATION "${CMAKE_INSTALL_DATADIR}/doc/vtkbonedecimate" RENAME copyright)
include(CPack)
