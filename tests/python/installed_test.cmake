# Installs the Python package alone, and imports it from where it was installed.
# cmake -DBUILD=... -DWORK=... -DPYTHON=... -DSCENE=... -P installed_test.cmake
include(${CMAKE_CURRENT_LIST_DIR}/../run_command.cmake)

file(REMOVE_RECURSE ${WORK})
run(${CMAKE_COMMAND} --install ${BUILD} --component python --prefix ${WORK})
file(GLOB_RECURSE installed RELATIVE ${WORK} ${WORK}/*)
list(FILTER installed EXCLUDE REGEX "^share/doc/")  # the licence, for packages
list(FILTER installed EXCLUDE REGEX "/assur/(__init__\\.pyi?|errors\\.py|statuses\\.py|tables\\.py|py\\.typed)$")
if(NOT installed MATCHES "^lib/[^;]*-packages/assur/_assur\\.[^;]*so$")
  message(FATAL_ERROR "the package alone was expected, found ${installed}")
endif()
get_filename_component(package ${WORK}/${installed} DIRECTORY)
set(ENV{PYTHONPATH} ${package}/..)
set(ENV{PYTHONDONTWRITEBYTECODE} 1)
run(${PYTHON} -c "from assur import *
print(len(Plan(read_scene('${SCENE}')).solve()))")
if(NOT output MATCHES "^2\n")
  message(FATAL_ERROR "two configurations were expected: ${output}")
endif()
