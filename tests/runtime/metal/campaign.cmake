# Runs the campaign (campaign.py) on a named board, after building the program that makes the
# groups.
#   cmake -DBUILD=... -DPYTHON=... -DGROUPS=... -DCOMPILER=... -DWORK=... -DCOUNT=... -DFLAGS=...
#     -DBOARD=m7 -P campaign.cmake
execute_process(COMMAND ${CMAKE_COMMAND} --build ${BUILD} --target campaign_groups
  OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${PYTHON} -B ${CMAKE_CURRENT_LIST_DIR}/campaign.py ${GROUPS} ${COMPILER}
  ${WORK} ${COUNT} ${FLAGS} ${BOARD} COMMAND_ERROR_IS_FATAL ANY)
