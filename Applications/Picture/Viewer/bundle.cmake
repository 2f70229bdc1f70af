# Makes the script of the interactive view: fetches the packages of package-lock.json, whose checksums npm compares, and bundles what
# the modules of this folder use of them. Without npm or a network the program is built without the view, and a warning says so.
#   cmake -DNPM=... -DPYTHON=... -DSOURCE=... -DBINARY=... -DTEMPLATE=... -DOUTPUT=... -P bundle.cmake
set(viewer_program "")

include("${CMAKE_CURRENT_LIST_DIR}/fetch_packages.cmake")
file(REMOVE "${BINARY}/bundle.js")
find_npm("${PYTHON}" "${BINARY}" NPM)
if (NPM)
  file(MAKE_DIRECTORY "${BINARY}")
  fetch_packages("${SOURCE}" "${BINARY}" status)
  if (status EQUAL 0)
    file(GLOB modules "${SOURCE}/*.js")
    file(COPY ${modules} DESTINATION "${BINARY}")
    execute_process(
      COMMAND "${NPM}" exec --offline --no -- esbuild main.js --bundle --minify --format=iife --target=es2021 --charset=ascii
        --legal-comments=none --log-level=warning --outfile=bundle.js
      WORKING_DIRECTORY "${BINARY}" RESULT_VARIABLE status)
  endif ()
  if (status EQUAL 0)
    file(READ "${BINARY}/bundle.js" script)
    file(READ "${SOURCE}/LICENSES.txt" licenses)
    set(viewer_program "/*\n${licenses}*/\n${script}")
  endif ()
endif ()

if ((NPM OR PYTHON) AND viewer_program STREQUAL "")
  message(WARNING "The packages of Applications/Picture/Viewer/package-lock.json could not be fetched or bundled: pages of this program have a "
    "picture and no interactive view.")
endif ()
configure_file("${TEMPLATE}" "${OUTPUT}" @ONLY)
