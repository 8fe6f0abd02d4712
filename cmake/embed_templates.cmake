# Turns the files of templates/ into one header of string constants, so that the generator carries
# its templates and needs no files at run time.
# cmake -DTEMPLATES=a;b -DOUTPUT=templates.hpp -P embed_templates.cmake
set(text "// Made from templates/ by cmake/embed_templates.cmake.\n#pragma once\n\n")
string(APPEND text "namespace assur::generator::templates {\n\n")
foreach(template IN LISTS TEMPLATES)
  get_filename_component(name ${template} NAME)
  string(REGEX REPLACE "\\.mustache$" "" name ${name})
  string(REPLACE "." "_" name ${name})
  file(READ ${template} content)
  string(APPEND text "inline constexpr const char* ${name} = R\"assur(${content})assur\";\n\n")
endforeach()
string(APPEND text "}  // namespace assur::generator::templates\n")
file(CONFIGURE OUTPUT ${OUTPUT} CONTENT "${text}" @ONLY)
