# Law: configuring succeeds on a machine where optional packages are absent or broken, and reports
# each in one line. A broken package is found but names headers and libraries that are not there; a
# broken program fails.
# cmake -DSOURCE=... -DGENERATOR=... -DCOMPILER=... -DWORK=... -DSTATE=absent|broken|each
#   -P configuring_test.cmake
cmake_minimum_required(VERSION 3.25)
file(REMOVE_RECURSE ${WORK})

# The switch of each package, and how its line begins.
set(programs bash dpkg clang octave node pdflatex gnuplot valgrind Doxygen arm_compiler arm_nm wasm_compiler
  wasm_linker xz PHCpack)
set(files bash dpkg-deb clang++ octave-cli node pdflatex gnuplot valgrind doxygen arm-none-eabi-g++
  arm-none-eabi-nm clang++-22 wasm-ld-22 xz phc)
# The bench asks for these where Google Benchmark works.
set(peers Ceres ADOLC SUNDIALS GSL cminpack slvs)
set(headers ceres/jet.h adolc/adtl.h kinsol/kinsol.h gsl/gsl_multiroots.h cminpack.h slvs.h)
set(packages MPI HDF5 benchmark pybind11)
set(begin_benchmark "Google Benchmark")
set(begin_Ceres "Ceres Solver")
set(begin_ADOLC "ADOL-C")
set(begin_GSL "GNU Scientific Library")
set(begin_cminpack "C/C.. Minpack")
set(begin_slvs "SolveSpace's library")
foreach(program file IN ZIP_LISTS programs files)
  string(REPLACE "+" "." begin_${program} ${file})
endforeach()
set(begin_Doxygen "Doxygen")
set(begin_PHCpack "PHCpack")

# break_package(NAME): a package of that name, or a program, that is found first and does not work.
function(break_package name)
  set(broken ${WORK}/broken)
  list(FIND programs ${name} index)
  if(NOT index EQUAL -1)
    list(GET files ${index} file)
    file(CONFIGURE OUTPUT ${broken}/bin/${file} CONTENT "#!/bin/sh\nexit 127\n")
    file(CHMOD ${broken}/bin/${file} PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE)
    return()
  endif()
  list(FIND peers ${name} index)
  if(NOT index EQUAL -1)
    list(GET headers ${index} header)
    file(CONFIGURE OUTPUT ${broken}/include/${header} CONTENT "#include <header_that_is_missing.h>\n")
    foreach(library adolc sundials_kinsol sundials_nvecserial gsl gslcblas cminpack slvs)
      file(WRITE ${broken}/lib/lib${library}.so "")
    endforeach()
  elseif(name STREQUAL "MPI")
    # As with openmpi-bin of Debian without libopenmpi-dev.
    file(CONFIGURE OUTPUT ${broken}/bin/mpicxx CONTENT
      "#!/bin/sh\necho -I${broken}/missing -L${broken}/missing -lmpi_missing\n")
    file(CHMOD ${broken}/bin/mpicxx PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE)
  elseif(name STREQUAL "HDF5")
    foreach(file hdf5 hdf5-serial)
      file(CONFIGURE OUTPUT ${broken}/pkgconfig/${file}.pc CONTENT "Name: HDF5\nDescription: HDF5\n\
Version: 1.14\nCflags: -I${broken}/missing\nLibs: -L${broken}/missing -lhdf5_missing\n")
    endforeach()
  else()
    # As CMake writes them: the second where what they name is checked.
    set(target ${name}::${name})
    if(NOT name STREQUAL "benchmark")
      set(target ${name}::headers)
    endif()
    file(CONFIGURE OUTPUT ${broken}/lib/cmake/${name}/${name}ConfigVersion.cmake CONTENT
      "set(PACKAGE_VERSION 99)\nset(PACKAGE_VERSION_COMPATIBLE TRUE)\n")
    set(check "")
    if(name STREQUAL "benchmark")
      set(check "message(FATAL_ERROR \"The imported target references a file that does not exist\")\n")
    endif()
    file(CONFIGURE OUTPUT ${broken}/lib/cmake/${name}/${name}Config.cmake CONTENT
      "add_library(${target} INTERFACE IMPORTED)\nset_target_properties(${target} PROPERTIES\
 INTERFACE_INCLUDE_DIRECTORIES ${broken}/missing)\n${check}")
  endif()
endfunction()

# configure(NAME... SWITCHED NAME...): with these packages broken and those switched off, the tree is
# configured, and exactly the first are said not to work.
function(configure)
  cmake_parse_arguments(arg "" "" "BROKEN;SWITCHED" ${ARGN})
  file(REMOVE_RECURSE ${WORK})
  foreach(name IN LISTS arg_BROKEN)
    break_package(${name})
  endforeach()
  list(TRANSFORM arg_SWITCHED REPLACE "(.+)" "-DCMAKE_DISABLE_FIND_PACKAGE_\\1=ON"
    OUTPUT_VARIABLE switches)
  # CMake searches the folders beside the compiler before those of the environment.
  if("MPI" IN_LIST arg_BROKEN)
    list(APPEND switches -DMPI_CXX_COMPILER=${WORK}/broken/bin/mpicxx)
  endif()
  execute_process(
    COMMAND ${CMAKE_COMMAND} -E env PATH=${WORK}/broken/bin:$ENV{PATH}
      PKG_CONFIG_PATH=${WORK}/broken/pkgconfig
      ${CMAKE_COMMAND} -S ${SOURCE} -B ${WORK}/build -G ${GENERATOR} -DCMAKE_CXX_COMPILER=${COMPILER}
      -DCMAKE_BUILD_TYPE=Release -DCMAKE_PREFIX_PATH=${WORK}/broken ${switches}
    RESULT_VARIABLE status OUTPUT_VARIABLE said ERROR_VARIABLE said)
  message("${said}")
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "configuring failed with '${arg_BROKEN}' broken, '${arg_SWITCHED}' off")
  endif()
  foreach(name IN LISTS programs peers packages)
    set(begin ${name})
    if(DEFINED begin_${name})
      set(begin ${begin_${name}})
    endif()
    string(REGEX MATCH "-- ${begin} ([^\n]* )?does not work [^\n]*: " line "${said}")
    if(name IN_LIST arg_BROKEN AND NOT line)
      message(SEND_ERROR "no line tells that ${name} does not work")
    elseif(line AND NOT name IN_LIST arg_BROKEN)
      message(SEND_ERROR "${name} works: ${line}")
    endif()
    string(REGEX MATCH "-- ${begin} ([^\n]* )?is not installed: " line "${said}")
    if(name IN_LIST arg_SWITCHED AND NOT line)
      message(SEND_ERROR "no line tells that ${name} is not there")
    endif()
  endforeach()
endfunction()

set(of_bench ${peers} PHCpack)
set(others ${programs} ${packages})
list(REMOVE_ITEM others PHCpack)
if(STATE STREQUAL "absent")
  configure(SWITCHED ${others} Python3)
elseif(STATE STREQUAL "broken")
  configure(BROKEN ${others})
  list(REMOVE_ITEM others benchmark)
  configure(BROKEN ${of_bench} SWITCHED ${others})
else()
  configure()
  foreach(name IN LISTS others of_bench)
    configure(BROKEN ${name})
    configure(SWITCHED ${name})
  endforeach()
endif()
