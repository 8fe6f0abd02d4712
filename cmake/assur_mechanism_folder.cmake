# The library of a folder of mechanism/src, once for each way to compile it.
#
# assur_mechanism_folder(SOURCES FILE... [LINKS FOLDER...] [PUBLIC TARGET...] [PRIVATE TARGET...]
# [OPTIMISE LEVEL]) adds the library <library>_<folder> for each <library> of
# ASSUR_MECHANISM_LIBRARIES, compiled with the options in <library>_OPTIONS, too. Code that runs
# once, or where branches meet, is not worth more than the level g; code that runs for every
# position has the level 1, or 2 where <library>_FAST says so. With the tests, a program is added
# that contains the whole folder and all that it declares to link: the linker then reports a
# reference to a higher floor as undefined.
function(assur_mechanism_folder)
  cmake_parse_arguments(arg "" "OPTIMISE" "SOURCES;LINKS;PUBLIC;PRIVATE" ${ARGN})
  if(NOT DEFINED arg_OPTIMISE)
    set(arg_OPTIMISE g)
  endif()
  get_filename_component(folder ${CMAKE_CURRENT_SOURCE_DIR} NAME)
  foreach(whole IN LISTS ASSUR_MECHANISM_LIBRARIES)
    set(library ${whole}_${folder})
    set(level ${arg_OPTIMISE})
    if(${whole}_FAST AND level EQUAL 1)
      set(level 2)
    endif()
    add_library(${library} STATIC EXCLUDE_FROM_ALL ${arg_SOURCES})
    target_compile_features(${library} PUBLIC cxx_std_20)
    target_compile_options(${library} PRIVATE -O${level} ${${whole}_OPTIONS})
    target_include_directories(${library} PUBLIC ${PROJECT_SOURCE_DIR}/mechanism/include
      PRIVATE ${PROJECT_SOURCE_DIR}/mechanism/src)
    set(below ${arg_LINKS})
    list(TRANSFORM below PREPEND ${whole}_)
    target_link_libraries(${library} PUBLIC ${below} ${arg_PUBLIC} assur::text
      PRIVATE ${arg_PRIVATE} assur_build_flags)
    get_target_property(is_shareable ${whole} POSITION_INDEPENDENT_CODE)
    set_target_properties(${library} PROPERTIES ASSUR_COMPILER_HEAP 600000 ASSUR_FAST "${${whole}_FAST}"
      POSITION_INDEPENDENT_CODE ${is_shareable})
    target_sources(${whole} PRIVATE $<TARGET_OBJECTS:${library}>)
  endforeach()
  set_property(GLOBAL APPEND PROPERTY ASSUR_FOLDERS assur_mechanism_${folder})
  set_property(GLOBAL APPEND PROPERTY ASSUR_MECHANISM_FOLDERS assur_mechanism_${folder})
  if(ASSUR_BUILD_TESTS)
    set(library assur_mechanism_${folder})
    add_executable(${library}_alone ${PROJECT_SOURCE_DIR}/tests/house/empty_program.cpp)
    set_target_properties(${library}_alone PROPERTIES UNITY_BUILD OFF)
    target_link_libraries(${library}_alone
      PRIVATE $<LINK_LIBRARY:WHOLE_ARCHIVE,${library}> assur_build_flags)
  endif()
endfunction()
