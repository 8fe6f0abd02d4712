# Installs the headers and the command, has a project in C alone build solvers, and runs them.
# cmake -DBUILD=... -DSOURCE=... -DWORK=... -DCOMPILER=... -P run.cmake
include(${CMAKE_CURRENT_LIST_DIR}/../../../run_command.cmake)

file(REMOVE_RECURSE ${WORK})
foreach(component runtime command)
  run(${CMAKE_COMMAND} --install ${BUILD} --component ${component} --prefix ${WORK}/install)
endforeach()
run(${CMAKE_COMMAND} -S ${SOURCE} -B ${WORK}/build -DCMAKE_PREFIX_PATH=${WORK}/install
  -DCMAKE_CXX_COMPILER=${COMPILER})
run(${CMAKE_COMMAND} --build ${WORK}/build)
foreach(real double float)
  run(${WORK}/build/follow_${real})
endforeach()
