# Writes the files of templates/ into one header of names and texts, so that the generator carries
# its templates and needs no files at run time.
# cmake -DTEMPLATES=a;b -DNAMESPACE=a::b -DOUTPUT=templates.hpp -P embed_templates.cmake
set(text "// Made from templates/ by cmake/embed_templates.cmake.\n#pragma once\n\n")
string(APPEND text "#include <array>\n#include <string_view>\n#include <utility>\n\n")
string(APPEND text "namespace ${NAMESPACE}::templates {\n\n")
string(APPEND text "inline constexpr auto all = std::to_array<std::pair<std::string_view, const char*>>({\n")
foreach(template IN LISTS TEMPLATES)
  get_filename_component(name ${template} NAME)
  string(REGEX REPLACE "\\.(mustache|in)$" "" name ${name})
  file(READ ${template} content)
  string(APPEND text "    {\"${name}\", R\"assur(${content})assur\"},\n")
endforeach()
string(APPEND text "});\n\n}  // namespace ${NAMESPACE}::templates\n")
file(CONFIGURE OUTPUT ${OUTPUT} CONTENT "${text}" @ONLY)
