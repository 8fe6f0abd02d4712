# A library target that holds the solver of a scene file, generated at build time.
#
#   assur_add_solver(<target> SCENE <file.json> [VARIABLE <parameter>...] [WANT <result>...]
#                    [INTERFACE c|c-float])
#
# makes <target>, to link and then include <assur/scenes/NAME.hpp>; NAME is the scene's file name
# without extension, with `_` for all but letters and digits. The parameters after VARIABLE stay
# arguments of the solver, beside those that the scene makes so; `all` stands for all. The results
# after WANT (position, velocity, acceleration, sensitivity, forces) are given instead of what the
# scene wants. With INTERFACE c <target> is a static library, to link from C too and then include
# <assur/scenes/NAME.h>, whose numbers are double, or float with c-float; the implementation is in
# C++, so find_package(assur) enables that language in a project of C alone. The files are written anew when
# the scene or the generator changes. The generator is the target assur::assur or, where that runs
# on another machine than the one that builds, the program ASSUR_GENERATOR_EXECUTABLE. For a machine
# without an operating system Eigen's checks at run time are left out (EIGEN_NO_DEBUG), because they
# link the functions that end a program.
set(ASSUR_GENERATOR_EXECUTABLE "" CACHE FILEPATH
  "The command assur for the machine that builds; empty: the target assur::assur")

function(assur_add_solver target)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "SCENE;INTERFACE" "VARIABLE;WANT")
  if(NOT arg_SCENE OR arg_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "assur_add_solver: expected assur_add_solver(<target> SCENE <file.json> "
      "[VARIABLE <parameter>...] [WANT <result>...] [INTERFACE c|c-float])")
  endif()
  if(arg_INTERFACE AND NOT arg_INTERFACE MATCHES "^(c|c-float|cpp)$")
    message(FATAL_ERROR "assur_add_solver: ${target}: no interface '${arg_INTERFACE}'; the "
      "interfaces are c, c-float and cpp")
  endif()
  set(is_c FALSE)
  if(arg_INTERFACE MATCHES "^c(-float)?$")
    set(is_c TRUE)
  endif()
  if(is_c AND NOT CMAKE_CXX_COMPILER_LOADED)
    message(FATAL_ERROR "assur_add_solver: ${target}: the C interface is implemented in C++; add "
      "CXX to the languages of project()")
  endif()
  get_filename_component(scene ${arg_SCENE} ABSOLUTE)
  get_source_file_property(is_generated ${scene} GENERATED)
  if(NOT EXISTS ${scene} AND NOT is_generated)
    message(FATAL_ERROR "assur_add_solver: ${target}: no file ${scene}")
  endif()
  if(ASSUR_GENERATOR_EXECUTABLE)
    set(generator ${ASSUR_GENERATOR_EXECUTABLE})
    set(generator_dependency ${ASSUR_GENERATOR_EXECUTABLE})
  elseif(TARGET assur::assur AND NOT CMAKE_CROSSCOMPILING)
    set(generator $<TARGET_FILE:assur::assur>)
    set(generator_dependency assur::assur $<TARGET_FILE:assur::assur>)
  else()
    message(FATAL_ERROR "assur_add_solver: no generator that runs here; install the command "
      "assur, build it with ASSUR_BUILD_GENERATOR, or set ASSUR_GENERATOR_EXECUTABLE to it")
  endif()
  get_filename_component(stem ${scene} NAME)
  string(REGEX REPLACE "\\.[^.]*$" "" stem ${stem})
  # The name as the generator makes it: one underscore for several, and none at the ends.
  string(REGEX REPLACE "[^A-Za-z0-9]+" "_" name "${stem}")
  if(name MATCHES "^_?(.*[A-Za-z0-9])_?$")
    set(name "${CMAKE_MATCH_1}")
  endif()
  string(MAKE_C_IDENTIFIER "${name}" name)
  # A program that links both would read one of the headers twice.
  get_property(other GLOBAL PROPERTY assur_scene_of_${name})
  if(other AND NOT other STREQUAL stem)
    message(FATAL_ERROR "assur_add_solver: ${target}: the names of the scenes ${other} and ${stem} "
      "differ in punctuation alone, and both headers are assur/scenes/${name}.hpp; rename one")
  endif()
  set_property(GLOBAL PROPERTY assur_scene_of_${name} ${stem})
  set(options "")
  if(arg_VARIABLE)
    list(JOIN arg_VARIABLE "," names)
    list(APPEND options --variable ${names})
  endif()
  if(arg_WANT)
    list(JOIN arg_WANT "," names)
    list(APPEND options --want ${names})
  endif()
  set(directory ${CMAKE_CURRENT_BINARY_DIR}/${target}_solver)
  set(stem_of_files ${directory}/assur/scenes/${name})
  set(files ${stem_of_files}.hpp)
  if(is_c)
    list(APPEND options --interface ${arg_INTERFACE})
    list(APPEND files ${stem_of_files}.h ${stem_of_files}.cpp)
  endif()
  add_custom_command(OUTPUT ${files}
    COMMAND ${generator} emit --scene ${scene} --output ${directory} ${options}
    DEPENDS ${scene} ${generator_dependency} VERBATIM
    COMMENT "Generating the solver of ${stem}")
  add_custom_target(${target}_header DEPENDS ${files})
  if(is_c)
    add_library(${target} STATIC ${stem_of_files}.cpp)
    set(reach PUBLIC)
  else()
    add_library(${target} INTERFACE)
    set(reach INTERFACE)
  endif()
  add_dependencies(${target} ${target}_header)
  target_include_directories(${target} ${reach} ${directory})
  target_link_libraries(${target} ${reach} assur::runtime)
  if(CMAKE_SYSTEM_NAME STREQUAL "Generic")
    target_compile_definitions(${target} ${reach} EIGEN_NO_DEBUG)
  endif()
endfunction()
