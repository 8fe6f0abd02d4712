# Packs the Python package as a source distribution, installs that by pip, without an index, into a
# new virtual environment, and makes a wheel of it.
# cmake -DSOURCE=... -DWORK=... -DPYTHON=... -P packed_test.cmake
include(${CMAKE_CURRENT_LIST_DIR}/../run_command.cmake)

# What setuptools writes beside the sources is written beside a copy. CMake's folder, with its
# compiled files, stays from one run to the next.
file(REMOVE_RECURSE ${WORK}/tree ${WORK}/packed ${WORK}/wheel ${WORK}/environment)
file(COPY ${SOURCE}/ DESTINATION ${WORK}/tree
  PATTERN ".git" EXCLUDE PATTERN "build*" EXCLUDE PATTERN "tests" EXCLUDE PATTERN "docs" EXCLUDE)
file(COPY ${SOURCE}/MANIFEST.in DESTINATION ${WORK}/tree)
set(ENV{PYTHONDONTWRITEBYTECODE} 1)
set(build ${PYTHON} -m build --no-isolation --skip-dependency-check)
run(${build} --sdist --outdir ${WORK}/packed ${WORK}/tree)
file(GLOB archive ${WORK}/packed/assur-*.tar.gz)
file(ARCHIVE_EXTRACT INPUT ${archive} DESTINATION ${WORK})
string(REGEX REPLACE ".*/(assur-[0-9.]+)\\.tar\\.gz$" "${WORK}/\\1" unpacked ${archive})

run(${PYTHON} -m venv --system-site-packages ${WORK}/environment)
set(python ${WORK}/environment/bin/python)
set(install ${python} -m pip install --no-index --no-build-isolation --no-deps)
run(${install} ${unpacked})
file(WRITE ${WORK}/environment/use.py "
import importlib.metadata, pathlib, sys
import assur
assert pathlib.Path(assur.__file__).is_relative_to(sys.prefix), assur.__file__
assert importlib.metadata.version('assur') == assur.__version__
assert (pathlib.Path(assur.__file__).parent / 'py.typed').exists()
import assur.tables
print(len(assur.Plan(assur.read_scene(sys.argv[1])).solve()))
")
set(scene ${SOURCE}/examples/four_bar_coupler_curve.json)
run(${python} ${WORK}/environment/use.py ${scene})
if(NOT output MATCHES "^2\n")
  message(FATAL_ERROR "two configurations were expected: ${output}")
endif()

run(${build} --wheel --outdir ${WORK}/wheel ${unpacked})
run(${python} -m pip uninstall --yes assur)
file(GLOB wheel ${WORK}/wheel/assur-*.whl)
run(${install} ${wheel})
run(${python} ${WORK}/environment/use.py ${scene})

# What is missing is told in one line.
function(expect_refusal words)
  execute_process(COMMAND ${install} ${unpacked} RESULT_VARIABLE status OUTPUT_VARIABLE said
    ERROR_VARIABLE said)
  if(status EQUAL 0 OR NOT said MATCHES "error: [^\n]*${words}[^\n]*; on Debian: apt-get install ")
    message(FATAL_ERROR "expected a line on '${words}', found ${status}: ${said}")
  endif()
endfunction()
set(ENV{CMAKE_ARGS} "-DCMAKE_DISABLE_FIND_PACKAGE_pybind11=ON")
expect_refusal("pybind11 with Python's headers and NumPy is not installed")
set(ENV{CMAKE_ARGS} "-DCMAKE_DISABLE_FIND_PACKAGE_pybind11=OFF -Dnlohmann_json_DIR=/nowhere")
set(ENV{PATH} "${WORK}/environment/bin")
expect_refusal("cmake is not installed")
