# SPDX-License-Identifier: MIT
# find_package(Touchstone): with it a class that has step(), time() and samples() becomes a method of a flow.
#
#   touchstone_add_case(NAME mine FLOW poiseuille SOURCES mine.cpp ACROSS 20 40 80 [TIMES 0.1 1] [EVERY 0.02] [SET H=1e-3 nu=1e-6]
#                       [AT_MOST 1] [ORDER_AT_LEAST 1.8])
#
# makes a program of the sources, whose main() returns touchstone::client::run<Class>(count, words); a TOML file for `vnv run`, with
# these words as its keys; and a test of ctest, poiseuille.mine. Its record lies in BUILD/records/acceptance: `vnv report` in BUILD makes
# pages of it.
get_filename_component(TOUCHSTONE_PREFIX ${CMAKE_CURRENT_LIST_DIR}/../../.. ABSOLUTE)
if(NOT TARGET Touchstone::client)
  add_library(Touchstone::client INTERFACE IMPORTED)
endif()
target_include_directories(Touchstone::client INTERFACE ${TOUCHSTONE_PREFIX}/include)
target_compile_features(Touchstone::client INTERFACE cxx_std_20)

function(touchstone_add_case)
  cmake_parse_arguments(PARSE_ARGV 0 case "" "NAME;FLOW;EVERY;AT_MOST;ORDER_AT_LEAST" "SOURCES;ACROSS;TIMES;SET")
  foreach(word NAME FLOW SOURCES ACROSS)
    if(NOT case_${word})
      message(FATAL_ERROR "touchstone_add_case: no ${word}, expected NAME, FLOW, SOURCES and ACROSS")
    endif()
  endforeach()
  if(case_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "touchstone_add_case: '${case_UNPARSED_ARGUMENTS}', expected values of NAME, FLOW, SOURCES, ACROSS, TIMES, EVERY, SET, AT_MOST, ORDER_AT_LEAST")
  endif()
  foreach(word IN LISTS case_ACROSS case_TIMES)
    if(NOT word MATCHES "^[0-9.eE+-]+$")
      message(FATAL_ERROR "touchstone_add_case: '${word}' in ACROSS or TIMES, expected numbers")
    endif()
  endforeach()
  set(program ${case_FLOW}_${case_NAME})
  add_executable(${program} ${case_SOURCES})
  target_link_libraries(${program} PRIVATE Touchstone::client)

  set(keys "name = \"${case_NAME}\"" "flow = \"${case_FLOW}\"")
  foreach(word ACROSS TIMES)
    if(case_${word})
      string(TOLOWER ${word} key)
      list(JOIN case_${word} ", " numbers)
      list(APPEND keys "${key} = [${numbers}]")
    endif()
  endforeach()
  foreach(pair IN LISTS case_SET)
    list(APPEND keys "set.${pair}")
  endforeach()
  foreach(key every claims.at_most claims.order_at_least)
    string(REGEX REPLACE ".*[.]" "" word ${key})
    string(TOUPPER ${word} word)
    if(DEFINED case_${word})
      list(APPEND keys "${key} = ${case_${word}}")
    endif()
  endforeach()
  list(JOIN keys "\n" keys)
  file(GENERATE OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/${program}.toml CONTENT "${keys}
command = [\"$<TARGET_FILE:${program}>\", \"{spacing}\", \"{times}\", \"{particles}\", \"{parameters}\"]
output = \"samples.csv\"
")
  add_test(NAME ${case_FLOW}.${case_NAME}
           COMMAND ${TOUCHSTONE_PREFIX}/bin/vnv run ${CMAKE_CURRENT_BINARY_DIR}/${program}.toml --records ${CMAKE_BINARY_DIR}/records/acceptance)
endfunction()
