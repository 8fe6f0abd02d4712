# Writes the npm package, and its tarball as `npm pack` would.
# cmake -DSOURCE=... -DVERSION=... -DOUTPUT=... [-DNPM=...] -P pack.cmake
set(package ${OUTPUT}/package)
file(REMOVE_RECURSE ${package})
file(MAKE_DIRECTORY ${package})
set(PROJECT_VERSION ${VERSION})
configure_file(${SOURCE}/packaging/npm/package.json.in ${package}/package.json @ONLY)
file(COPY ${SOURCE}/packaging/npm/index.d.ts ${SOURCE}/packaging/npm/README.md ${SOURCE}/LICENSE
  DESTINATION ${package})
# One file, so that nothing has to be found at run time; pages share its first part.
file(READ ${SOURCE}/templates/page/lzma.js unpacker)
file(READ ${SOURCE}/templates/page/library.js library)
file(READ ${SOURCE}/packaging/npm/api.js api)
file(READ ${SOURCE}/mechanism/module/mechanism.wasm.lzma.base64 module)
file(WRITE ${package}/index.js "${unpacker}\n${library}\nconst packedModule = \"${module}\";\n\n${api}")
set(tarball ${OUTPUT}/assur-${VERSION}.tgz)
file(REMOVE ${tarball})
if(NPM)
  execute_process(COMMAND ${NPM} pack --offline --silent --pack-destination ${OUTPUT}
    WORKING_DIRECTORY ${package} OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
else()
  execute_process(COMMAND ${CMAKE_COMMAND} -E tar czf ${tarball} package
    WORKING_DIRECTORY ${OUTPUT} COMMAND_ERROR_IS_FATAL ANY)
endif()
