# Makes the script of the interactive view: fetches the packages of package-lock.json, whose checksums npm compares, and bundles what
# the modules of this folder use of them. Without npm or a network the program is built without the view, and a warning says so.
#   cmake -DNPM=... -DSOURCE=... -DBINARY=... -DTEMPLATE=... -DOUTPUT=... -P bundle.cmake
set(viewer_program "")

# The packages are fetched again only if the list of them is another one.
function (fetch_packages result)
  file(SHA256 "${SOURCE}/package-lock.json" wanted)
  set(stamp "${BINARY}/node_modules/fetched")
  set(fetched "")
  if (EXISTS "${stamp}")
    file(READ "${stamp}" fetched)
  endif ()
  set(status 0)
  if (NOT fetched STREQUAL wanted)
    file(COPY "${SOURCE}/package.json" "${SOURCE}/package-lock.json" "${SOURCE}/.npmrc" DESTINATION "${BINARY}")
    execute_process(COMMAND "${NPM}" ci --loglevel=error WORKING_DIRECTORY "${BINARY}" RESULT_VARIABLE status OUTPUT_QUIET)
    if (status EQUAL 0)
      file(WRITE "${stamp}" "${wanted}")
    endif ()
  endif ()
  set(${result} "${status}" PARENT_SCOPE)
endfunction ()

file(REMOVE "${BINARY}/viewer.js")
if (NPM)
  file(MAKE_DIRECTORY "${BINARY}")
  fetch_packages(status)
  if (status EQUAL 0)
    file(GLOB modules "${SOURCE}/*.js")
    file(COPY ${modules} DESTINATION "${BINARY}")
    execute_process(
      COMMAND "${NPM}" exec --offline --no -- esbuild main.js --bundle --minify --format=iife --target=es2021 --charset=ascii
        --legal-comments=none --log-level=warning --outfile=viewer.js
      WORKING_DIRECTORY "${BINARY}" RESULT_VARIABLE status)
  endif ()
  if (status EQUAL 0)
    file(READ "${BINARY}/viewer.js" script)
    file(READ "${SOURCE}/LICENSES.txt" licenses)
    set(viewer_program "/*\n${licenses}*/\n${script}")
  endif ()
endif ()

if (NPM AND viewer_program STREQUAL "")
  message(WARNING "The packages of Applications/Picture/Viewer/package-lock.json could not be fetched or bundled: pages of this program have a "
    "picture and no interactive view.")
endif ()
configure_file("${TEMPLATE}" "${OUTPUT}" @ONLY)
