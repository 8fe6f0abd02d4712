# Compiles each header of the runtime alone, and fails if it needs another one before it:
#   cmake -DHEADERS=runtime/include -DFLAGS="-I..." -DCOMPILERS="g++;clang++" -P headers_alone.cmake
#
# Most of a header's time is Eigen's. A header that comes to include Eigen sees it before its own
# code, so it is compiled with Eigen precompiled; what it includes before Eigen is compiled alone
# here too, and without Eigen where it includes none.
cmake_minimum_required(VERSION 3.25)
file(GLOB_RECURSE headers RELATIVE ${HEADERS} ${HEADERS}/assur/*.hpp)
separate_arguments(flags UNIX_COMMAND "${FLAGS}")
set(flags -std=c++17 -Wall -Wextra -Wconversion -Wshadow -Werror -I${HEADERS} ${flags})
set(source ${CMAKE_CURRENT_BINARY_DIR}/header_alone.cpp)
set(eigen ${CMAKE_CURRENT_BINARY_DIR}/eigen_before.hpp)

# Those that include Eigen, themselves or by another header of the runtime.
set(with_eigen "")
set(before -1)
list(LENGTH with_eigen found)
while(NOT found EQUAL before)
  set(before ${found})
  foreach(header IN LISTS headers)
    file(STRINGS ${HEADERS}/${header} includes REGEX "^#include <(Eigen/.*|assur/.*)>$")
    list(TRANSFORM includes REPLACE "^#include <(.*)>$" "\\1")
    foreach(included IN LISTS includes)
      if(included MATCHES "^Eigen/" OR included IN_LIST with_eigen)
        list(APPEND with_eigen ${header})
        break()
      endif()
    endforeach()
  endforeach()
  list(REMOVE_DUPLICATES with_eigen)
  list(LENGTH with_eigen found)
endwhile()

# One header in two by default, and all of them by `ctest -L long`.
set(chosen ${headers})
if(NOT DEFINED ENV{ASSUR_WHOLE_CAMPAIGN})
  list(LENGTH headers count)
  math(EXPR last "${count} - 1")
  set(chosen "")
  foreach(index RANGE 0 ${last} 2)
    list(GET headers ${index} header)
    list(APPEND chosen ${header})
  endforeach()
endif()

set(failed FALSE)
foreach(compiler IN LISTS COMPILERS)
  file(WRITE ${eigen} "#include <Eigen/Core>\n")
  execute_process(COMMAND ${compiler} ${flags} -x c++-header ${eigen} -o ${eigen}.gch
    COMMAND_ERROR_IS_FATAL ANY)
  foreach(header IN LISTS chosen)
    file(WRITE ${source} "#include <${header}>\n")
    set(first "")
    if(header IN_LIST with_eigen)
      set(first -Winvalid-pch -include ${eigen})
    endif()
    execute_process(COMMAND ${compiler} ${flags} -fsyntax-only ${first} ${source}
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
