# Turns compilers and their options for arithmetic into a comparison of answers.cpp with what it says
# without options: every answer is the same, or it says that the arithmetic is unsound.
#   cmake -DCOMPILERS="g++;clang++" -DFLAGS="-I..." -DWORK=... -DREFERENCE=<answers of the dyads>
#     -P arithmetic.cmake
#   cmake ... -DASSUR=<the command> -DSCENE=<four-bar.json> -P arithmetic.cmake
# The first compares dyads under few options; the second, under all, also tetrads, an emitted solver
# and emitted closures.
cmake_minimum_required(VERSION 3.25)
separate_arguments(flags UNIX_COMMAND "${FLAGS}")
set(flags -std=c++17 ${flags})
set(source ${CMAKE_CURRENT_LIST_DIR}/answers.cpp)
file(MAKE_DIRECTORY ${WORK})

# Options that end with "untold" hide GCC's macros that reveal options; other compilers have none.
set(untold -U__FAST_MATH__ -U__ASSOCIATIVE_MATH__ -U__RECIPROCAL_MATH__ -U__FLT_EVAL_METHOD__)
set(associative -fassociative-math -fno-signed-zeros -fno-trapping-math)

# compare(COMPILER REFUSED SETTING OPTION...): what answers.cpp says where it is compiled with
# options and run with a setting. REFUSED: whether some answers must be refusals.
function(compare compiler refused setting)
  list(JOIN ARGN " " options)
  list(TRANSFORM ARGN REPLACE "^untold$" "${untold}" OUTPUT_VARIABLE given)
  set(title "${compiler} ${options} ${setting}")
  if("-m32" IN_LIST given)
    file(WRITE ${WORK}/empty.cpp "#include <cmath>\nint main() { return 0; }\n")
    execute_process(COMMAND ${compiler} -m32 ${WORK}/empty.cpp -o ${WORK}/empty
      RESULT_VARIABLE status OUTPUT_QUIET ERROR_QUIET)
    if(NOT status EQUAL 0)
      message(STATUS "${title}: left out, for nothing links with -m32 here")
      return()
    endif()
  endif()
  execute_process(COMMAND ${compiler} ${flags} ${given} ${source} -o ${WORK}/answers
    COMMAND_ERROR_IS_FATAL ANY)
  execute_process(COMMAND ${WORK}/answers ${setting} OUTPUT_VARIABLE answers
    COMMAND_ERROR_IS_FATAL ANY)
  string(REGEX MATCHALL "[^\n]+" answers "${answers}")
  list(LENGTH answers count)
  list(LENGTH expected expected_count)
  if(NOT count EQUAL expected_count)
    message(FATAL_ERROR "${title}: ${count} answers instead of ${expected_count}")
  endif()
  set(refusals 0)
  foreach(answer truth IN ZIP_LISTS answers expected)
    if(answer MATCHES ": unsound")
      math(EXPR refusals "${refusals} + 1")
    elseif(NOT answer STREQUAL truth)
      message(SEND_ERROR "${title}:\n  ${answer}\n  instead of\n  ${truth}")
    endif()
  endforeach()
  message(STATUS "${title}: ${count} answers, ${refusals} of them refusals")
  if(refused AND refusals EQUAL 0)
    message(SEND_ERROR "${title}: nothing was refused")
  elseif(NOT refused AND NOT refusals EQUAL 0)
    message(SEND_ERROR "${title}: sound arithmetic was refused")
  endif()
endfunction()

list(GET COMPILERS 0 first)
if(NOT ASSUR)
  execute_process(COMMAND ${REFERENCE} OUTPUT_VARIABLE expected COMMAND_ERROR_IS_FATAL ANY)
  string(REGEX MATCHALL "[^\n]+" expected "${expected}")
  compare(${first} TRUE "" -O1 -m32 -mfpmath=387)
  compare(${first} TRUE "" -O1 ${associative} untold)
  return()
endif()

execute_process(COMMAND ${ASSUR} emit --scene ${SCENE} --output ${WORK}
  COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${ASSUR} emit --closures ${CMAKE_CURRENT_LIST_DIR}/four_bar.audit
  --output ${WORK} COMMAND_ERROR_IS_FATAL ANY)
list(APPEND flags -DASSUR_WHOLE_ANSWERS -I${WORK})
execute_process(COMMAND ${first} ${flags} -O1 ${source} -o ${WORK}/answers
  COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${WORK}/answers OUTPUT_VARIABLE expected COMMAND_ERROR_IS_FATAL ANY)
string(REGEX MATCHALL "[^\n]+" expected "${expected}")
foreach(compiler IN LISTS COMPILERS)
  foreach(level -O0 -O2 -O3)
    compare(${compiler} FALSE "" ${level})
  endforeach()
  compare(${compiler} FALSE "" -O2 -mfma)
  compare(${compiler} FALSE "" -O2 -m32 -msse2 -mfpmath=sse)
  foreach(harmless -fno-math-errno -fno-signed-zeros -fno-trapping-math)
    compare(${compiler} FALSE "" -O2 ${harmless})
  endforeach()
  compare(${compiler} TRUE "" -O2 -m32 -mfpmath=387)
  compare(${compiler} TRUE "" -O2 -m32 -mfpmath=387 untold)
  compare(${compiler} TRUE "" -O2 -ffast-math)
  compare(${compiler} TRUE "" -Ofast)
  compare(${compiler} TRUE "" -O2 -ffinite-math-only)
  foreach(level -O1 -O2 -O3)
    compare(${compiler} TRUE "" ${level} -funsafe-math-optimizations untold)
    compare(${compiler} TRUE "" ${level} ${associative} untold)
  endforeach()
  foreach(setting upward downward towardzero flush)
    compare(${compiler} TRUE ${setting} -O2)
  endforeach()
  # A library whose fused product rounds twice: it is not called, or else what it gives is refused.
  compare(${compiler} FALSE "" -O2 -fno-builtin -DASSUR_FMA_ROUNDS_TWICE)
  compare(${compiler} TRUE "" -O2 -fno-builtin -DASSUR_FMA_ROUNDS_TWICE -DFP_FAST_FMA)
endforeach()
# Options that GCC reveals by macros are refused when a program is compiled.
if(first MATCHES "g\\+\\+")
  compare(${first} TRUE "" -O2 -freciprocal-math)
  compare(${first} TRUE "" -O2 ${associative})
  compare(${first} TRUE "" -O2 -mfpmath=sse+387)
endif()
