# Compiles the runtime's headers and emitted solvers with several compilers and levels of
# optimisation; no warning may occur.
#   cmake -DCOMPILERS="g++;clang++" -DFLAGS="-I..." -DASSUR=... -DWORK=...
#     [-DWHOLE="scene.json;..." -DHEADERS=headers_compile.cpp -DSOLVER=solver.cpp] -P inclusion.cmake
# By default one solver, which has one configuration, is compiled and run.
cmake_minimum_required(VERSION 3.25)
separate_arguments(flags UNIX_COMMAND "${FLAGS}")
set(flags -std=c++17 -Wall -Wextra -Wconversion -Wshadow -Werror ${flags} -I${WORK})
file(MAKE_DIRECTORY ${WORK})

function(compile title)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE status ERROR_VARIABLE messages)
  if(NOT status EQUAL 0)
    message(SEND_ERROR "${title}:\n${messages}")
  endif()
endfunction()

# emit(SCENE OPTION...): the options that make a program of the scene's solver.
function(emit scene)
  execute_process(COMMAND ${ASSUR} emit --scene ${scene} --output ${WORK} ${ARGN} ERROR_QUIET
    RESULT_VARIABLE status)
  set(solver "" PARENT_SCOPE)
  if(status EQUAL 0)
    get_filename_component(stem ${scene} NAME_WE)
    string(MAKE_C_IDENTIFIER ${stem} name)
    file(STRINGS ${WORK}/assur/scenes/${name}.hpp structure REGEX "support::Branch<")
    string(REGEX REPLACE ".*<(.*), Scalar>.*" "\\1" structure "${structure}")
    set(solver -DASSUR_SOLVER=${structure} "-DASSUR_HEADER=<assur/scenes/${name}.hpp>" PARENT_SCOPE)
  endif()
endfunction()

emit(${CMAKE_CURRENT_LIST_DIR}/scotch_yoke.json)
foreach(compiler IN LISTS COMPILERS)
  compile("${compiler}, inclusion.cpp" ${compiler} ${flags} -O1
    ${CMAKE_CURRENT_LIST_DIR}/inclusion.cpp -o ${WORK}/inclusion)
  execute_process(COMMAND ${WORK}/inclusion COMMAND_ERROR_IS_FATAL ANY)
endforeach()
if(NOT WHOLE)
  return()
endif()

set(compiled 0)
foreach(scene IN LISTS WHOLE)
  emit(${scene})
  if(solver)
    list(GET COMPILERS 0 compiler)
    compile("${scene} at -O2" ${compiler} ${flags} -O2 ${solver} -c ${SOLVER} -o ${WORK}/solver.o)
    math(EXPR compiled "${compiled} + 1")
  endif()
endforeach()
message(STATUS "${compiled} solvers")
if(compiled LESS 15)
  message(SEND_ERROR "only ${compiled} scenes have a solver")
endif()
# A solver of positions alone is so small that compilers see all of it.
emit(${CMAKE_CURRENT_LIST_DIR}/scotch_yoke.json --want position)
set(yoke ${solver})
list(GET WHOLE 0 first)
emit(${first})
foreach(compiler IN LISTS COMPILERS)
  foreach(level -O0 -O1 -O2 -O3 -Os)
    compile("${compiler} ${level}, headers" ${compiler} ${flags} ${level} -c ${HEADERS}
      -o ${WORK}/headers.o)
    compile("${compiler} ${level}, ${first}" ${compiler} ${flags} ${level} ${solver} -c ${SOLVER}
      -o ${WORK}/solver.o)
    compile("${compiler} ${level}, yoke" ${compiler} ${flags} ${level} ${yoke} -c ${SOLVER}
      -o ${WORK}/solver.o)
    message(STATUS "${compiler} ${level}")
  endforeach()
endforeach()
