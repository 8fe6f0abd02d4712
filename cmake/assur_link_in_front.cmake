# Links a program that is hardly optimised to the optimised code of its libraries.
#
# assur_link_in_front(TARGET LIBRARY...) lets the program TARGET take functions of headers from
# these static libraries of the project, and from those that they link publicly, if these define
# them. If several objects define one function, the linker keeps the first, and objects of a program
# come before libraries: without this, the libraries would call the program's own copies.
function(assur_link_in_front program)
  set(archives "")
  set(seen "")
  set(targets ${ARGN})
  while(targets)
    list(POP_FRONT targets target)
    if(NOT TARGET "${target}" OR target IN_LIST seen)
      continue()
    endif()
    list(APPEND seen ${target})
    get_target_property(aliased ${target} ALIASED_TARGET)
    get_target_property(type ${target} TYPE)
    get_target_property(links ${target} INTERFACE_LINK_LIBRARIES)
    if(aliased)
      list(APPEND targets ${aliased})
    elseif(type STREQUAL "STATIC_LIBRARY" AND target MATCHES "^assur_")
      list(APPEND archives $<TARGET_FILE:${target}>)
    endif()
    if(links)
      list(APPEND targets ${links})
    endif()
  endwhile()
  if(archives AND UNIX AND NOT APPLE)
    list(JOIN archives "," archives)
    target_link_options(${program} PRIVATE LINKER:--whole-archive,${archives},--no-whole-archive)
  endif()
endfunction()
