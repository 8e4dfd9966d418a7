cmake_minimum_required(VERSION 3.25)
# Writes HEADER with the revision of SOURCE, only when it changed: run at each build, it recompiles one small file after
# a commit or an edit, and nothing else.
set(revision unknown)
if(GIT)
  execute_process(COMMAND ${GIT} describe --always --dirty WORKING_DIRECTORY ${SOURCE}
                  OUTPUT_VARIABLE described OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET RESULT_VARIABLE failed)
  if(NOT failed)
    set(revision ${described})
  endif()
endif()
file(CONFIGURE OUTPUT ${HEADER} CONTENT "#pragma once\n#define TOUCHSTONE_REVISION \"@revision@\"\n" @ONLY)
