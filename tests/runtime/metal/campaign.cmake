# Turns a board's name into the verdict of the campaign on it (campaign.py), once the program that
# makes the groups is built.
#   cmake -DBUILD=... -DPYTHON=... -DGROUPS=... -DCOMPILER=... -DWORK=... -DCOUNT=... -DFLAGS=...
#     -DBOARD=m7 -P campaign.cmake
execute_process(COMMAND ${CMAKE_COMMAND} --build ${BUILD} --target campaign_groups
  OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${PYTHON} -B ${CMAKE_CURRENT_LIST_DIR}/campaign.py ${GROUPS} ${COMPILER}
  ${WORK} ${COUNT} ${FLAGS} ${BOARD} COMMAND_ERROR_IS_FATAL ANY)
