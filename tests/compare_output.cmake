# SPDX-License-Identifier: MIT
# Runs a program in an empty folder of its own and compares all that it prints with a text:
#
#   cmake -D PROGRAM=... -D ARGUMENTS=... -D EXPECTED=... -D FOLDER=... -P compare_output.cmake
#
# Shows the difference if there is one. To accept a new output, copy FOLDER/output.txt to EXPECTED.
file(REMOVE_RECURSE ${FOLDER})
file(MAKE_DIRECTORY ${FOLDER})
set(output ${FOLDER}/output.txt)
execute_process(COMMAND ${PROGRAM} ${ARGUMENTS} WORKING_DIRECTORY ${FOLDER}
  OUTPUT_FILE ${output} ERROR_FILE ${output} RESULT_VARIABLE result)
if(NOT result EQUAL 0)
  message(SEND_ERROR "${PROGRAM} fails: ${result}")
endif()
execute_process(COMMAND ${CMAKE_COMMAND} -E compare_files --ignore-eol ${EXPECTED} ${output}
  RESULT_VARIABLE differs ERROR_QUIET)
if(differs)
  find_program(DIFF diff)
  if(DIFF)
    execute_process(COMMAND ${DIFF} -u ${EXPECTED} ${output})
  else()
    file(READ ${output} text)
    message("${text}")
  endif()
  message(FATAL_ERROR "the output in ${output} is not that of ${EXPECTED}")
endif()
