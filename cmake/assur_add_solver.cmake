# Turns a scene file into a library target that holds the scene's solver, generated at build time.
#
#   assur_add_solver(<target> SCENE <file.json> [VARIABLE <parameter>...])
#
# makes <target>, to link and then include <assur/scenes/NAME.hpp>; NAME is the scene's file name
# without extension, with `_` for all but letters and digits. The parameters after VARIABLE stay
# arguments of the solver, beside those that the scene makes so; `all` stands for all. The header is written anew when the
# scene or the generator changes. The generator is the target assur::assur or, where that runs on
# another machine than the one that builds, the program ASSUR_GENERATOR_EXECUTABLE.
set(ASSUR_GENERATOR_EXECUTABLE "" CACHE FILEPATH
  "The command assur for the machine that builds; empty: the target assur::assur")

function(assur_add_solver target)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "SCENE" "VARIABLE")
  if(NOT arg_SCENE OR arg_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "assur_add_solver: expected assur_add_solver(<target> SCENE <file.json> "
      "[VARIABLE <parameter>...])")
  endif()
  if(ASSUR_GENERATOR_EXECUTABLE)
    set(generator ${ASSUR_GENERATOR_EXECUTABLE})
    set(generator_dependency ${ASSUR_GENERATOR_EXECUTABLE})
  elseif(TARGET assur::assur AND NOT CMAKE_CROSSCOMPILING)
    set(generator $<TARGET_FILE:assur::assur>)
    set(generator_dependency assur::assur $<TARGET_FILE:assur::assur>)
  else()
    message(FATAL_ERROR "assur_add_solver: no generator that runs here; build assur with "
      "ASSUR_BUILD_GENERATOR, or set ASSUR_GENERATOR_EXECUTABLE to the command assur")
  endif()
  get_filename_component(scene ${arg_SCENE} ABSOLUTE)
  get_filename_component(stem ${scene} NAME)
  string(REGEX REPLACE "\\.[^.]*$" "" stem ${stem})
  string(MAKE_C_IDENTIFIER ${stem} name)
  set(variable "")
  if(arg_VARIABLE)
    list(JOIN arg_VARIABLE "," names)
    set(variable --variable ${names})
  endif()
  set(directory ${CMAKE_CURRENT_BINARY_DIR}/${target}_solver)
  set(header ${directory}/assur/scenes/${name}.hpp)
  add_custom_command(OUTPUT ${header}
    COMMAND ${generator} emit --scene ${scene} --output ${directory} ${variable}
    DEPENDS ${scene} ${generator_dependency} VERBATIM
    COMMENT "Generating the solver of ${stem}")
  add_custom_target(${target}_header DEPENDS ${header})
  add_library(${target} INTERFACE)
  add_dependencies(${target} ${target}_header)
  target_include_directories(${target} INTERFACE ${directory})
  target_link_libraries(${target} INTERFACE assur::runtime)
endfunction()
