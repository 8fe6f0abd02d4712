# Installs the build tree, then configures, builds and runs the example project in C++ against the
# install tree, without access to GiNaC; then requests components that do not exist.
# cmake -DBUILD=... -DSOURCE=... -DEXAMPLE=... -DWORK=... -DCOMPILER=... [-DSANITIZE=...] -P run.cmake
include(${CMAKE_CURRENT_LIST_DIR}/../../run_command.cmake)

file(REMOVE_RECURSE ${WORK})
run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${WORK}/install)
# A program links a library that was built with sanitizers only if it has them, too.
set(flags "")
if(SANITIZE)
  set(flags "-fsanitize=${SANITIZE}")
endif()
set(configure ${CMAKE_COMMAND} -DCMAKE_CXX_COMPILER=${COMPILER} -DCMAKE_BUILD_TYPE=Release
  -DCMAKE_CXX_FLAGS=${flags} -DCMAKE_DISABLE_FIND_PACKAGE_PkgConfig=ON)
run(${configure} -S ${EXAMPLE} -B ${WORK}/build -DCMAKE_PREFIX_PATH=${WORK}/install)
run(${CMAKE_COMMAND} --build ${WORK}/build --verbose)
string(TOLOWER "${output}" said)
if(NOT said MATCHES "libassur_mechanism")
  message(FATAL_ERROR "the library is not linked:\n${output}")
endif()
if(said MATCHES "ginac" OR said MATCHES "lcln|libcln")
  message(FATAL_ERROR "the library brings GiNaC or CLN:\n${output}")
endif()
run(${WORK}/build/four_bar)
# With the crank upright the joint C is at (80, 100) or (0, -60), and P = 2 C - B with B = (0, 40).
foreach(point "160.000, +160.000" "-?0.000, +-160.000")
  if(NOT output MATCHES " 90 deg:[^\n]*P \\( *${point}\\) mm")
    message(FATAL_ERROR "P at (${point}) was expected at 90 degrees:\n${output}")
  endif()
endforeach()

# A program for another instruction set is refused by the linker, and does not crash.
execute_process(COMMAND ${COMPILER} -mavx -x c++ - -fsyntax-only INPUT_FILE /dev/null
  RESULT_VARIABLE no_avx ERROR_QUIET)
if(no_avx EQUAL 0)
  execute_process(COMMAND ${configure} -S ${EXAMPLE} -B ${WORK}/avx
    -DCMAKE_PREFIX_PATH=${WORK}/install "-DCMAKE_CXX_FLAGS=${flags} -mavx" -DCMAKE_BUILD_TYPE=Debug
    OUTPUT_QUIET)
  execute_process(COMMAND ${CMAKE_COMMAND} --build ${WORK}/avx
    RESULT_VARIABLE status OUTPUT_VARIABLE messages ERROR_VARIABLE messages)
  if(status EQUAL 0 OR NOT messages MATCHES "LibraryForEigenAlignment<32>")
    message(FATAL_ERROR "expected an undefined reference, found ${status}: ${messages}")
  endif()
endif()

# All refusals share a build tree, so that the compiler is examined once; where the package was found
# before is forgotten.
function(expect_refusal prefix components message)
  execute_process(COMMAND ${configure} -S ${SOURCE} -B ${WORK}/refused -U assur_DIR
    -DCMAKE_PREFIX_PATH=${prefix} -DCOMPONENTS=${components}
    RESULT_VARIABLE status ERROR_VARIABLE messages OUTPUT_QUIET)
  string(REGEX REPLACE "[ \n]+" " " messages "${messages}")
  string(FIND "${messages}" "${message}" place)
  if(status EQUAL 0 OR place EQUAL -1)
    message(FATAL_ERROR "expected '${message}', found ${status}: ${messages}")
  endif()
endfunction()

expect_refusal(${WORK}/install gears "no component 'gears'; the components are runtime and mechanism")
run(${configure} -S ${SOURCE} -B ${WORK}/runtime -DCMAKE_PREFIX_PATH=${WORK}/install
  -DCOMPONENTS=runtime)

# An installation of the runtime alone.
run(${configure} -S ${EXAMPLE}/../.. -B ${WORK}/headers -DASSUR_BUILD_GENERATOR=OFF
  -DASSUR_BUILD_MECHANISM=OFF -DASSUR_BUILD_TESTS=OFF)
run(${CMAKE_COMMAND} --install ${WORK}/headers --prefix ${WORK}/headers_install)
expect_refusal(${WORK}/headers_install mechanism "the library assur::mechanism was not installed")
run(${configure} -S ${SOURCE} -B ${WORK}/runtime_alone
  -DCMAKE_PREFIX_PATH=${WORK}/headers_install -DCOMPONENTS=runtime)
