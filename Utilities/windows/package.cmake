# What `cpack` makes for Windows: an archive with the program, which needs nothing else, and the licenses of what is in it.
set(CPACK_GENERATOR ZIP)
set(CPACK_PACKAGE_NAME vtkbonedecimate)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_CMAKE_PROJECTS "${CMAKE_BINARY_DIR};${PROJECT_NAME};program;/")
install(FILES "${PROJECT_SOURCE_DIR}/LICENSE" DESTINATION . COMPONENT program)
install(DIRECTORY "${PROJECT_SOURCE_DIR}/build/windows-libraries/licenses" DESTINATION . COMPONENT program)
include(CPack)
