# Law: programs for a Cortex-M7 without an operating system link no heap, no exceptions, no function
# that aborts, and no code that runs before main.
#   cmake -DCOMPILER=arm-none-eabi-g++ -DNM=arm-none-eabi-nm -DFLAGS="-I..." -DWORK=... -DASSUR=...
#     -DSCENE=<four-bar.json> -DEXAMPLES=examples -P metal.cmake
cmake_minimum_required(VERSION 3.25)
separate_arguments(flags UNIX_COMMAND "${FLAGS}")
set(flags -std=c++17 -mcpu=cortex-m7 -mfloat-abi=hard -mfpu=fpv5-d16 -fno-exceptions -fno-rtti
  -ffunction-sections -fdata-sections -Wl,--gc-sections --specs=nosys.specs -Wno-psabi ${flags}
  -I${WORK})
file(MAKE_DIRECTORY ${WORK})

# check(NAME SOURCE OPTION...): links a program and reads its symbols and its map.
function(check name source)
  execute_process(COMMAND ${COMPILER} ${flags} ${ARGN} -Wl,-Map=${WORK}/${name}.map
    ${CMAKE_CURRENT_LIST_DIR}/${source} -o ${WORK}/${name}.elf
    ERROR_VARIABLE messages RESULT_VARIABLE status)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "${name}: does not link\n${messages}")
  endif()
  execute_process(COMMAND ${NM} -C ${WORK}/${name}.elf OUTPUT_VARIABLE symbols
    COMMAND_ERROR_IS_FATAL ANY)
  if(NOT symbols MATCHES " main\n")
    message(FATAL_ERROR "${name}: the symbols were not read")
  endif()
  set(forbidden "__cxa_|__assert|abort|malloc|_sbrk|operator new|guard variable|_GLOBAL__sub_I")
  string(REGEX MATCHALL "[^\n]*(${forbidden})[^\n]*" found "${symbols}")
  if(found)
    list(JOIN found "\n  " found)
    message(SEND_ERROR "${name} ${ARGN} links\n  ${found}")
  else()
    message(STATUS "${name} ${ARGN}: nothing of ${forbidden}")
  endif()
endfunction()

execute_process(COMMAND ${ASSUR} emit --scene ${SCENE} --output ${WORK} COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${ASSUR} emit --scene ${EXAMPLES}/four_bar_coupler_curve.json --output ${WORK}
  COMMAND_ERROR_IS_FATAL ANY)
check(tetrad tetrad.cpp -O2)
set(four_bar -DASSUR_SOLVER=FourBar "-DASSUR_HEADER=<assur/scenes/four_bar.hpp>")
check(four_bar solver.cpp -O2 ${four_bar})
# Where rates and derivatives are asked for, and at -Os, Eigen's checks at run time are left out by
# the definition that assur_add_solver gives to programs without an operating system.
check(tetrad tetrad.cpp -Os -DEIGEN_NO_DEBUG)
check(four_bar_coupler_curve solver.cpp -Os -DEIGEN_NO_DEBUG -DASSUR_SOLVER=FourBarCouplerCurve
  "-DASSUR_HEADER=<assur/scenes/four_bar_coupler_curve.hpp>")
