# The nightly suite for a dashboard, and for the trend over all nights:
#
#   ctest -S .ci/nightly.cmake -V [-DBUILD=FOLDER] [-DHISTORY=FOLDER] [-DDROP_SITE=HOST -DDROP_LOCATION=PATH -DDROP_METHOD=http]
#
# BUILD          folder to build in; build/ in the sources if none is named
# HISTORY        folder of the summaries of all nights; history/ in BUILD. Outside of it they outlive the build
# ENGINE         local, parallel or slurm: `vnv run` makes the suite by it, with ENGINE_OPTIONS (--hosts;a,b), and skips what this
#                revision has done; none: ctest does, here, from nothing
# METHODS        those of the suite that ENGINE makes, as `vnv run` takes them (couette;dam_break.mpm); all
# LABEL          regular expression of the labels to run; units, the nightly suite, README's lines on bare machines, and all commands
#                that the texts print, which take two hours
# DROP_SITE      host of a CDash server that gets the results; none: nothing leaves this machine
# DROP_LOCATION  where on it, /submit.php?project=Touchstone
# DROP_METHOD    https, or http for one within reach
#
# It fails if the build or a test does; BUILD/site/nightly/index.html and Testing/ in BUILD tell what.
cmake_minimum_required(VERSION 3.25)

function(set_unless_named name value)
  if(NOT DEFINED ${name} OR "${${name}}" STREQUAL "")
    set(${name} "${value}" PARENT_SCOPE)
  endif()
endfunction()

cmake_path(GET CMAKE_CURRENT_LIST_DIR PARENT_PATH CTEST_SOURCE_DIRECTORY)
set_unless_named(BUILD ${CTEST_SOURCE_DIRECTORY}/build)
set_unless_named(HISTORY ${BUILD}/history)
set_unless_named(LABEL "^(unit|nightly|bare|commands)$")
set_unless_named(DROP_LOCATION "/submit.php?project=Touchstone")
set_unless_named(DROP_METHOD https)
get_filename_component(CTEST_BINARY_DIRECTORY ${BUILD} ABSOLUTE)
get_filename_component(HISTORY ${HISTORY} ABSOLUTE)

set(CTEST_PROJECT_NAME Touchstone)
set(CTEST_NIGHTLY_START_TIME "00:00:00 UTC")
cmake_host_system_information(RESULT CTEST_SITE QUERY HOSTNAME)
set(CTEST_BUILD_NAME "nightly")
set(CTEST_CMAKE_GENERATOR Ninja)
set(CTEST_CUSTOM_MAXIMUM_PASSED_TEST_OUTPUT_SIZE 100000)  # bytes; measurements stand in the output
set(CTEST_CUSTOM_MAXIMUM_FAILED_TEST_OUTPUT_SIZE 300000)

set(failed)
function(note what result)
  if(NOT result EQUAL 0)
    set(failed ${failed} ${what} PARENT_SCOPE)
  endif()
endfunction()

ctest_start(Nightly)
ctest_configure(OPTIONS "-DCMAKE_BUILD_TYPE=Release;-DTOUCHSTONE_NATIVE=ON;-DTOUCHSTONE_HISTORY=${HISTORY}" RETURN_VALUE configured)
note(configure ${configured})
if(NOT failed)
  foreach(target all check_headers)
    ctest_build(TARGET ${target} APPEND RETURN_VALUE built)
    note("build of ${target}" ${built})
  endforeach()
  if(NOT METHODS)
    set(ENV{TOUCHSTONE_WHOLE_SUITE} 1)  # the pages miss an accepted method that has no record
  endif()
  if(NOT ENGINE)
    ctest_test(INCLUDE_LABEL "${LABEL}" PARALLEL_LEVEL 2 RETURN_VALUE tested)
    note(tests ${tested})
  else()
    ctest_test(INCLUDE_LABEL "${LABEL}" EXCLUDE_LABEL "^nightly$" PARALLEL_LEVEL 2 RETURN_VALUE tested)
    note(tests ${tested})
    set(vnv ${CTEST_BINARY_DIRECTORY}/vnv/vnv)
    set(records ${CTEST_BINARY_DIRECTORY}/records/nightly)
    execute_process(COMMAND ${vnv} list --names --suite nightly OUTPUT_VARIABLE methods COMMAND_ERROR_IS_FATAL ANY)
    string(REPLACE "\n" ";" methods "${methods}")
    file(GLOB former RELATIVE ${records} ${records}/*.json)
    foreach(record IN LISTS former)  # of methods that are gone
      string(REGEX REPLACE "[.]json$" "" method ${record})
      if(NOT method IN_LIST methods)
        file(REMOVE ${records}/${record})
      endif()
    endforeach()
    execute_process(COMMAND ${vnv} run ${METHODS} --suite nightly --engine ${ENGINE} ${ENGINE_OPTIONS} RESULT_VARIABLE ran)
    note("suite by ${ENGINE}" ${ran})
    ctest_test(INCLUDE "^nightly[.](pages|browser)$" EXCLUDE_FIXTURE_SETUP nightly_records APPEND RETURN_VALUE shown)
    note(pages ${shown})
  endif()
endif()
if(DROP_SITE)
  set(CTEST_SUBMIT_URL "${DROP_METHOD}://${DROP_SITE}${DROP_LOCATION}")
  ctest_submit(RETURN_VALUE submitted)
  note("submission to ${DROP_SITE}" ${submitted})
endif()
if(failed)
  message(FATAL_ERROR "nightly: ${failed}: not as expected")  # ctest ends with another status than 0
endif()
