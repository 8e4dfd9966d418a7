# What a case measures of its own method, `vnv run` measures of the same program behind a TOML file, to the last digit, and
# the gate finds it the same as itself.
set(folder "${CMAKE_CURRENT_BINARY_DIR}/a program is judged alike")
file(REMOVE_RECURSE ${folder})
file(WRITE ${folder}/ours.toml "flow = \"poiseuille\"
across = [20]
times = [0.1]
command = [\"${PROGRAM}\", \"--method\", \"mpm\", \"--spacing\", \"{spacing}\", \"--until\", \"{until}\", \"--vtp\", \"{folder}\"]
output = \"*.pvd\"
claims = { at_most = 100 }
")
file(COPY_FILE ${folder}/ours.toml ${folder}/changed.toml)
execute_process(COMMAND ${PROGRAM} --method mpm --spacing 5e-5 --until 0.1 OUTPUT_VARIABLE inner RESULT_VARIABLE ended)
if(NOT ended EQUAL 0 OR NOT inner MATCHES "L2 v_x, per particle \\[%\\] = ([0-9.]+) at 0.1 s")
  message(FATAL_ERROR "${PROGRAM}: ended with '${ended}', expected its error at 0.1 s; it said: ${inner}")
endif()
set(error ${CMAKE_MATCH_1})
execute_process(COMMAND ${VNV} run ${folder}/ours.toml --records ${folder}/records OUTPUT_VARIABLE said ERROR_VARIABLE said RESULT_VARIABLE ended)
if(NOT ended EQUAL 0)
  message(FATAL_ERROR "vnv run: ended with '${ended}', expected 0; it said: ${said}")
endif()
file(READ ${folder}/records/poiseuille.ours.json record)
string(REPLACE "." "[.]" digits ${error})
if(NOT record MATCHES "\"L2 v_x, per particle\"[^}]*},\"value\":${digits}")
  message(FATAL_ERROR "${folder}/records/poiseuille.ours.json: expected L2 ${error} % per particle")
endif()
execute_process(COMMAND ${VNV} gate ${folder}/ours.toml ${folder}/changed.toml --repeats 0 RESULT_VARIABLE ended OUTPUT_VARIABLE said ERROR_VARIABLE said)
if(NOT ended EQUAL 0)
  message(FATAL_ERROR "vnv gate: ended with '${ended}', expected the same code to be the same; it said: ${said}")
endif()
