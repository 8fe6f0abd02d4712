# assur_generator_folder(SOURCES FILE... [LINKS FOLDER...] [PUBLIC TARGET...] [PRIVATE TARGET...]): the
# library assur_generator_<folder> of this folder of generator/. It links the folders below it alone,
# so that the linker finds an arrow that points upwards.
function(assur_generator_folder)
  cmake_parse_arguments(arg "" "" "SOURCES;LINKS;PUBLIC;PRIVATE" ${ARGN})
  file(RELATIVE_PATH folder ${PROJECT_SOURCE_DIR}/generator ${CMAKE_CURRENT_SOURCE_DIR})
  string(REPLACE "/" "_" folder ${folder})
  set(library assur_generator_${folder})
  add_library(${library} STATIC ${arg_SOURCES})
  target_compile_features(${library} PUBLIC cxx_std_20)
  target_include_directories(${library} PUBLIC ${PROJECT_SOURCE_DIR}/generator)
  list(TRANSFORM arg_LINKS PREPEND assur_generator_)
  target_link_libraries(${library} PUBLIC ${arg_LINKS} ${arg_PUBLIC}
    PRIVATE ${arg_PRIVATE} assur_build_flags)
  # GiNaC, which has been optimised, does the work; optimising what calls it costs more than it saves.
  target_compile_options(${library} PRIVATE $<$<NOT:$<CONFIG:Debug>>:-Og>)
  # GiNaC's header takes longer to read than most files that include it: it is read once.
  if(folder STREQUAL "equations")
    target_precompile_headers(${library} PRIVATE <algorithm> <deque> <functional> <ginac/ginac.h>
      <map> <optional> <set> <sstream> <string> <vector>)
  elseif(NOT folder STREQUAL "structure")
    target_precompile_headers(${library} REUSE_FROM assur_generator_equations)
  endif()
endfunction()
