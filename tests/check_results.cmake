# SPDX-License-Identifier: MIT
# Plans in SCENE with every search and smoother, and lets CHECK judge the paths. With the robot grown
# the same paths have to be refused.
file(MAKE_DIRECTORY ${FOLDER})
execute_process(COMMAND ${PLAN} --workspace ${SCENE} --start=-8,1.5 --goal 0,-3 --compare
  --json ${FOLDER}/results.json OUTPUT_QUIET)  # some searches find nothing
execute_process(COMMAND ${CHECK} ${SCENE} ${FOLDER}/results.json RESULT_VARIABLE code)
if(NOT code EQUAL 0)
  message(FATAL_ERROR "paths are wrong")
endif()
file(READ ${SCENE} scene)
string(JSON scene SET "${scene}" safety_radius 1)
file(WRITE ${FOLDER}/grown.json "${scene}")
execute_process(COMMAND ${CHECK} ${FOLDER}/grown.json ${FOLDER}/results.json
  RESULT_VARIABLE code OUTPUT_QUIET)
if(NOT code EQUAL 1)
  message(FATAL_ERROR "paths of a smaller robot pass")
endif()
