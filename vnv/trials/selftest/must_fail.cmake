cmake_minimum_required(VERSION 3.25)

# Runs COMMAND, which must fail by itself (not by a signal) and say EXPECTED, a regular expression, in its output.
# A program that is not built is skipped by who chose what to build.
if("${EXPECTED}" STREQUAL "")
  message(FATAL_ERROR "EXPECTED is empty, expected words that the failure must have")  # everything matches nothing
endif()
list(GET COMMAND 0 program)
if(NOT EXISTS ${program} AND NOT "$ENV{TOUCHSTONE_EXPECT_ALL}" AND NOT "$ENV{CI}")
  message("SKIP: ${program} is not built")
  return()
endif()
execute_process(COMMAND ${COMMAND} RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
if(NOT result MATCHES "^[1-9][0-9]*$")
  message(FATAL_ERROR "ended with '${result}', expected a failure of its own; it said:\n${output}")
endif()
if(NOT output MATCHES "${EXPECTED}")
  message(FATAL_ERROR "failed without the words '${EXPECTED}'; it said:\n${output}")
endif()
message("${output}")
