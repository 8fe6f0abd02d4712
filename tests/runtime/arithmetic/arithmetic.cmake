# Compares the answers of answers.cpp under compilers' options for arithmetic with those without
# options: every answer is the same, or states that the arithmetic is unsound. Options that the
# compiler reports are refused by the headers.
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

# read(COMPILER SENTENCE OPTION...): the preprocessor accepts the headers with these options, or
# refuses them with the sentence if there is one.
function(read compiler sentence)
  execute_process(COMMAND ${compiler} ${flags} ${ARGN} -E ${source} RESULT_VARIABLE status
    OUTPUT_QUIET ERROR_VARIABLE said)
  if(sentence AND (status EQUAL 0 OR NOT said MATCHES "${sentence}"))
    message(SEND_ERROR "${compiler} ${ARGN}: not refused with \"${sentence}\": ${said}")
  elseif(NOT sentence AND NOT status EQUAL 0)
    message(SEND_ERROR "${compiler} ${ARGN}: refused: ${said}")
  endif()
endfunction()

set(as_written "error: .*assur needs every operation rounded as it is written: compile without -ffast-math")
set(once "error: .*assur needs every operation rounded once, .*compile with -msse2 -mfpmath=sse")
foreach(compiler IN LISTS COMPILERS)
  read(${compiler} "" -O2)
  read(${compiler} "" -O2 -march=native -ffp-contract=fast)
  read(${compiler} "" -fno-math-errno -fno-signed-zeros -fno-trapping-math)
  foreach(option -ffast-math -Ofast -ffinite-math-only)
    read(${compiler} "${as_written}" ${option})
  endforeach()
  if(compiler MATCHES "clang")
    read(${compiler} "${as_written}" -ffp-model=fast)
  else()
    read(${compiler} "${as_written}" -funsafe-math-optimizations)
    read(${compiler} "${as_written}" ${associative})
    read(${compiler} "${as_written}" -freciprocal-math)
    read(${compiler} "${once}" -mfpmath=387)
    read(${compiler} "${once}" -mfpmath=sse+387)
  endif()
endforeach()

list(GET COMPILERS 0 first)
if(NOT ASSUR)
  execute_process(COMMAND ${REFERENCE} OUTPUT_VARIABLE expected COMMAND_ERROR_IS_FATAL ANY)
  string(REGEX MATCHALL "[^\n]+" expected "${expected}")
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
  compare(${compiler} FALSE "" -O2 -march=native -ffp-contract=fast)
  compare(${compiler} TRUE "" -O2 -m32 -mfpmath=387 untold)
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
