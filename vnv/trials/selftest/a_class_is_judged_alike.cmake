# A method of ours, run as a class of others in a program of its own, has the values of its particles in the case, to the last bit.
set(folder "${CMAKE_CURRENT_BINARY_DIR}/a class is judged alike/${METHOD}")
file(REMOVE_RECURSE ${folder})
file(WRITE ${folder}/ours.toml "name = \"${METHOD}\"
flow = \"manufactured\"
across = [32]
command = [\"${CLASSES}\", \"{spacing}\", \"{times}\", \"{particles}\", \"{parameters}\", \"${METHOD}\"]
output = \"samples.csv\"
claims = { at_most = 100 }
")
function(run)
  execute_process(COMMAND ${ARGN} OUTPUT_VARIABLE said ERROR_VARIABLE said RESULT_VARIABLE ended)
  if(NOT ended EQUAL 0)
    message(FATAL_ERROR "${ARGN}: ended with '${ended}', expected 0; it said: ${said}")
  endif()
endfunction()
run(${PROGRAM} --method ${METHOD} --spacing 0.03125 --until 0.2 --vtp ${folder}/vtp)
file(MAKE_DIRECTORY ${folder}/inner)
run(${VNV} judge manufactured ${folder}/vtp/manufactured.${METHOD}.custom.pvd --at-most 100 --name ${METHOD} --records ${folder}/inner)
run(${VNV} run ${folder}/ours.toml --records ${folder}/class)
foreach(kind inner class)
  file(READ ${folder}/${kind}/manufactured.${METHOD}.json record)
  string(JSON ${kind} GET ${record} values)
endforeach()
if(NOT inner STREQUAL class OR NOT inner MATCHES "\"value\" : [0-9.]+")
  message(FATAL_ERROR "${METHOD}: as a class ${class}\nexpected ${inner}")
endif()
