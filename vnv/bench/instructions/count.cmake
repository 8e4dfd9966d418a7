# cmake -DVALGRIND=... -DPROGRAM=... -DOTHER=... -P count.cmake: a term that is not listed costs no instruction.
# PROGRAM counts the sum over pairs from a list of terms and by hand; OTHER is the same program that knows of more terms.
# The difference of two runs of different length is free of what comes before and after. The environment is empty,
# because its length changed the count by up to 16 instructions.
if(NOT VALGRIND)
  message(FATAL_ERROR "valgrind: not found; install it (Debian: apt install valgrind), or nothing counts instructions")
endif()

# Sets `name` to the instructions of `more` sums, over a fluid of 1600 particles with 31000 pairs.
set(more 2)
function(count name program how)
  foreach(times 1 3)
    execute_process(COMMAND env -i ${VALGRIND} --tool=cachegrind --cache-sim=no --cachegrind-out-file=/dev/null ${program} ${how} ${times}
                    RESULT_VARIABLE status ERROR_VARIABLE said OUTPUT_QUIET)
    if(NOT status EQUAL 0 OR NOT said MATCHES "I +refs: +([0-9,]+)")
      message(FATAL_ERROR "${program} ${how}: no count of instructions: ${said}")
    endif()
    string(REPLACE "," "" count_${times} ${CMAKE_MATCH_1})
  endforeach()
  math(EXPR counted "${count_3} - ${count_1}")
  message(STATUS "${name}: ${counted} instructions in ${more} sums")
  set(${name} ${counted} PARENT_SCOPE)
endfunction()

count(listed ${PROGRAM} listed)
count(by_hand ${PROGRAM} by_hand)
count(with_viscosity ${PROGRAM} with_viscosity)
count(knows_more ${OTHER} listed)

# Two a particle are left for handing over its sums: of some 580, and none of a pair.
math(EXPR most "${by_hand} + ${more} * 2 * 1600")
if(listed GREATER most)
  message(FATAL_ERROR "the sum from a list of terms takes ${listed} instructions, expected at most ${most}: by hand it takes ${by_hand}")
endif()
if(NOT knows_more EQUAL listed)
  message(FATAL_ERROR "terms that are only known cost instructions: ${knows_more}, expected ${listed}")
endif()
math(EXPR least "${listed} + ${more} * 31000")
if(with_viscosity LESS least)
  message(FATAL_ERROR "a term that is listed costs no instruction a pair, so this test sees nothing: ${with_viscosity} and ${listed}")
endif()
