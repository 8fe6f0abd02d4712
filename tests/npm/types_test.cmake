# Law: a program compiles against the types of the packed npm package in strict mode, and runs.
#   cmake -DFOLDER=<where the tarball is> -DWORK=... -DTSC=tsc -DNODE=node -P types_test.cmake
file(REMOVE_RECURSE ${WORK})
file(GLOB tarball ${FOLDER}/assur-*.tgz)
file(ARCHIVE_EXTRACT INPUT ${tarball} DESTINATION ${WORK}/node_modules)
file(RENAME ${WORK}/node_modules/package ${WORK}/node_modules/assur)
file(WRITE ${WORK}/package.json "{\"type\": \"module\"}\n")
configure_file(${CMAKE_CURRENT_LIST_DIR}/strict_program.ts ${WORK} COPYONLY)
execute_process(COMMAND ${TSC} --strict --noUnusedLocals --target es2022 --module node16
    --moduleResolution node16 --lib es2022,dom strict_program.ts
  WORKING_DIRECTORY ${WORK} OUTPUT_VARIABLE messages RESULT_VARIABLE status)
if(NOT status EQUAL 0)
  message(FATAL_ERROR "the types do not fit the program\n${messages}")
endif()
execute_process(COMMAND ${NODE} strict_program.js WORKING_DIRECTORY ${WORK} OUTPUT_VARIABLE told
  COMMAND_ERROR_IS_FATAL ANY)
if(NOT told STREQUAL "10 2 2\n")
  message(FATAL_ERROR "the program says ${told}")
endif()
