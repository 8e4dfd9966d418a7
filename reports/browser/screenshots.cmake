# Takes pictures of the index and of the page of Poiseuille flow of a SITE, into PICTURES.
foreach(page index poiseuille)
  set(file ${SITE}/index.html)
  if(NOT page STREQUAL index)
    set(file ${SITE}/${page}/index.html)
  endif()
  if(NOT EXISTS ${file})
    message(FATAL_ERROR "${file}: not there, expected a site: run the workflow `first` or `acceptance`")
  endif()
  set(profile ${SITE}/../.screenshots)
  execute_process(COMMAND ${CHROMIUM} --headless --no-sandbox --disable-gpu --no-first-run --disable-background-networking
                          --disable-sync --hide-scrollbars --user-data-dir=${profile} --window-size=1100,1400
                          --screenshot=${PICTURES}/${page}.png file://${file}
                  RESULT_VARIABLE result OUTPUT_QUIET ERROR_VARIABLE said)
  file(REMOVE_RECURSE ${profile})
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "${CHROMIUM}: ended with '${result}': ${said}")
  endif()
endforeach()
