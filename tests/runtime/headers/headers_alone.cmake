# Turns each header of the runtime into a file of its own, and fails where it needs another first:
#   cmake -DHEADERS=runtime/include -DFLAGS="-I..." -DCOMPILERS="g++;clang++" -P headers_alone.cmake
file(GLOB_RECURSE headers RELATIVE ${HEADERS} ${HEADERS}/assur/*.hpp)
separate_arguments(flags UNIX_COMMAND "${FLAGS}")
set(source ${CMAKE_CURRENT_BINARY_DIR}/header_alone.cpp)
set(failed FALSE)
foreach(header IN LISTS headers)
  file(WRITE ${source} "#include <${header}>\n")
  foreach(compiler IN LISTS COMPILERS)
    execute_process(COMMAND ${compiler} -std=c++17 -Wall -Wextra -Wconversion -Wshadow -Werror
        -fsyntax-only -I${HEADERS} ${flags} ${source}
      RESULT_VARIABLE result ERROR_VARIABLE messages)
    if(NOT result EQUAL 0)
      message(STATUS "${compiler}, ${header} alone:\n${messages}")
      set(failed TRUE)
    endif()
  endforeach()
endforeach()
if(failed)
  message(FATAL_ERROR "a header needs another before it")
endif()
