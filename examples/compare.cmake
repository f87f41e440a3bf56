# SPDX-License-Identifier: MIT
# Runs PROGRAM and compares what it prints with the file EXPECTED. EYRIE_UPDATE_GOLDEN=1 rewrites the file.
execute_process(COMMAND ${PROGRAM} OUTPUT_VARIABLE printed RESULT_VARIABLE code)
if(NOT code EQUAL 0)
  message(FATAL_ERROR "${PROGRAM} ended with ${code}")
endif()
if("$ENV{EYRIE_UPDATE_GOLDEN}" STREQUAL "1")
  file(WRITE ${EXPECTED} "${printed}")
endif()
file(READ ${EXPECTED} expected)
if(NOT printed STREQUAL expected)
  message(FATAL_ERROR "not what ${EXPECTED} says:\n${printed}")
endif()
