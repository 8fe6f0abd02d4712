# Packs the build tree into Debian packages, unpacks each beside those that it depends on, and
# builds outside projects with the installed files. cmake -DBUILD=... -DSOURCE=... -DWORK=...
# -DCOMPILER=... -DPYTHON=... -P packages_test.cmake
include(${CMAKE_CURRENT_LIST_DIR}/../run_command.cmake)

file(REMOVE_RECURSE ${WORK})
run(cpack --config ${BUILD}/CPackConfig.cmake -G DEB -B ${WORK}/packages)
set(root ${WORK}/root)

# unpack(PACKAGE DEPENDS...): the package must need just those packages of this project.
function(unpack package)
  file(GLOB file ${WORK}/packages/${package}_*.deb)
  run(dpkg-deb -f ${file} Depends)
  string(REGEX MATCHALL "(lib|python3-)?assur[a-z-]*" needed "${output}")
  if(NOT needed STREQUAL "${ARGN}")
    message(FATAL_ERROR "${package} needs '${needed}', expected '${ARGN}'")
  endif()
  run(dpkg-deb -x ${file} ${root})
endfunction()

function(build name source)
  run(${CMAKE_COMMAND} -S ${source} -B ${WORK}/${name} -DCMAKE_PREFIX_PATH=${root}/usr
    -DCMAKE_CXX_COMPILER=${COMPILER} -DCMAKE_BUILD_TYPE=Debug)
  run(${CMAKE_COMMAND} --build ${WORK}/${name})
endfunction()

unpack(libassur-dev)
build(runtime ${SOURCE}/tests/runtime/consumer)
run(${WORK}/runtime/consumer)
execute_process(COMMAND ${CMAKE_COMMAND} -S ${SOURCE}/examples/cpp -B ${WORK}/refused
  -DCMAKE_PREFIX_PATH=${root}/usr RESULT_VARIABLE status ERROR_VARIABLE said OUTPUT_QUIET)
if(status EQUAL 0 OR NOT said MATCHES "install its package")
  message(FATAL_ERROR "expected to be told of the package, found ${status}: ${said}")
endif()

unpack(assur)
build(command ${SOURCE}/tests/generator/emission/consumer_scene)
run(${WORK}/command/consumer_scene)
unpack(assur-doc)
set(scene ${root}/usr/share/doc/assur/examples/four_bar_coupler_curve.json)
run(${root}/usr/bin/assur solve ${scene})
file(GLOB campaigns ${WORK}/packages/assur-campaigns_*.deb)
if(campaigns)
  unpack(assur-campaigns assur)
  run(${root}/usr/bin/assur sample ${scene} --count 100 --seed 1 --output ${WORK}/sample.h5)
endif()

unpack(libassur-mechanism-dev libassur-dev)
build(mechanism ${SOURCE}/examples/cpp)
run(${WORK}/mechanism/four_bar)

file(GLOB python ${WORK}/packages/python3-assur_*.deb)
if(python)
  unpack(python3-assur)
  file(GLOB package ${root}/usr/lib/python3*/dist-packages)
  set(ENV{PYTHONPATH} ${package})
  run(${PYTHON} -c "import assur
print(assur.__file__)")
  string(FIND "${output}" ${root} place)
  if(place EQUAL -1)
    message(FATAL_ERROR "another package was imported: ${output}")
  endif()
endif()
