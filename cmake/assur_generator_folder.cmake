# The library of a folder of generator/.
#
# assur_generator_folder(SOURCES FILE... [LINKS FOLDER...] [PUBLIC TARGET...] [PRIVATE TARGET...])
# adds the library assur_generator_<folder>. With the tests, a program is added that contains the
# whole library and all that it declares to link: the linker then reports a reference to a higher
# floor as undefined.
function(assur_generator_folder)
  cmake_parse_arguments(arg "" "" "SOURCES;LINKS;PUBLIC;PRIVATE" ${ARGN})
  file(RELATIVE_PATH folder ${PROJECT_SOURCE_DIR}/generator ${CMAKE_CURRENT_SOURCE_DIR})
  string(REPLACE "/" "_" folder ${folder})
  set(library assur_generator_${folder})
  add_library(${library} STATIC ${arg_SOURCES})
  set_property(GLOBAL APPEND PROPERTY ASSUR_FOLDERS ${library})
  target_compile_features(${library} PUBLIC cxx_std_20)
  target_include_directories(${library} PUBLIC ${PROJECT_SOURCE_DIR}/generator)
  list(TRANSFORM arg_LINKS PREPEND assur_generator_)
  target_link_libraries(${library} PUBLIC ${arg_LINKS} ${arg_PUBLIC}
    PRIVATE ${arg_PRIVATE} assur_build_flags)
  # GiNaC does the work and is optimised; optimising the code that calls it costs more than it
  # saves.
  target_compile_options(${library} PRIVATE $<$<NOT:$<CONFIG:Debug>>:-Og>)
  if(ASSUR_BUILD_TESTS)
    add_executable(${library}_alone ${PROJECT_SOURCE_DIR}/tests/house/empty_program.cpp)
    set_target_properties(${library}_alone PROPERTIES UNITY_BUILD OFF)
    target_link_libraries(${library}_alone
      PRIVATE $<LINK_LIBRARY:WHOLE_ARCHIVE,${library}> assur_build_flags)
  endif()
  # GiNaC's header takes longer to read than most files that include it: it is read once.
  if(folder STREQUAL "equations")
    target_precompile_headers(${library} PRIVATE <algorithm> <deque> <functional> <ginac/ginac.h>
      <map> <optional> <set> <sstream> <string> <vector>)
  elseif(arg_LINKS)
    target_precompile_headers(${library} REUSE_FROM assur_generator_equations)
  endif()
endfunction()

# assur_module(TARGET): a part of the command that it loads when it is needed.
function(assur_module module)
  target_compile_features(${module} PRIVATE cxx_std_20)
  target_include_directories(${module} PRIVATE ${PROJECT_SOURCE_DIR}/generator)
  set_target_properties(${module} PROPERTIES PREFIX "" LIBRARY_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR})
  install(TARGETS ${module} LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}/assur COMPONENT campaigns)
endfunction()
