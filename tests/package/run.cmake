# SPDX-License-Identifier: MIT
# Installs BUILD into a fresh folder below WORK, builds the project beside this file against that and compares what its
# programs print with EXAMPLES/*.txt. The installed program flies from its own data, and what PAGE tells its reader to type
# is done word for word.
include(${CMAKE_CURRENT_LIST_DIR}/command.cmake)

file(REMOVE_RECURSE ${WORK})
set(prefix ${WORK}/home/eyrie)
run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${prefix})
run(${prefix}/bin/eyrie zones --check)
run(${CMAKE_COMMAND} -S ${CMAKE_CURRENT_LIST_DIR} -B ${WORK}/build -G Ninja -DCMAKE_PREFIX_PATH=${prefix}
    -DEXAMPLES=${EXAMPLES} -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_COMPILER=${COMPILER})
run(${CMAKE_COMMAND} --build ${WORK}/build)
foreach(pair first_tree=01_first_tree fly_a_mission=04_fly_a_mission)
  string(REPLACE "=" ";" pair ${pair})
  list(GET pair 0 program)
  list(GET pair 1 example)
  run(${WORK}/build/${program})
  file(READ ${EXAMPLES}/${example}.txt expected)
  if(NOT output STREQUAL expected)
    message(FATAL_ERROR "${program} prints\n${output}instead of\n${expected}")
  endif()
endforeach()
unset(ENV{EYRIE_HOME})
unset(ENV{EYRIE_VIEWER})
if(NOT EXISTS ${prefix}/share/eyrie/debrief.html)  # a page is not built with the program
  configure_file(${CMAKE_CURRENT_LIST_DIR}/../support/viewer.html ${prefix}/share/eyrie/debrief.html COPYONLY)
endif()
run(${prefix}/bin/eyrie fly merge --until "10 s" --quiet --out ${WORK}/run)
if(NOT output MATCHES "debrief.html")
  message(FATAL_ERROR "an installed Eyrie writes no page:\n${output}")
endif()
run(${prefix}/bin/eyrie debrief ${WORK}/run --out ${WORK}/page.html)
run(${prefix}/bin/eyrie replay ${WORK}/run)
run(${prefix}/bin/eyrie explain ${WORK}/run --player viper1 --at 0:05)

# type(PAGE FOLDER WORD...)   what PAGE tells its reader to type, in FOLDER, with nothing in the environment, says each WORD
function(type page folder)
  run(sed -n "/^```sh\$/,/^```\$/{/^```/!p}" ${page})
  if(NOT output MATCHES "cmake --build build\n")
    message(FATAL_ERROR "${page} builds nothing:\n${output}")
  endif()
  file(WRITE ${WORK}/page.sh "${output}")
  run(env -C ${folder} -i HOME=${WORK}/home PATH=/usr/bin:/bin sh -ex ${WORK}/page.sh)
  foreach(said ${ARGN})
    if(NOT output MATCHES "${said}")
      message(FATAL_ERROR "the commands of ${page} do not say '${said}':\n${output}")
    endif()
  endforeach()
endfunction()

# a reader with an empty folder and Eyrie in ~/eyrie
file(MAKE_DIRECTORY ${WORK}/empty)
type(${PAGE} ${WORK}/empty "100% tests passed, 0 tests failed out of 2"
     "turns its back on who is near .of libveer_off.so." "the same, [0-9]+ steps")
file(STRINGS ${WORK}/empty/veer_off/build/veer_off.schema.json known REGEX "turns its back on who is near")
if(NOT known)
  message(FATAL_ERROR "the schema of a plug-in does not know its behavior")
endif()
# one in a checkout: from a behavior to the decisions that it wins
file(MAKE_DIRECTORY ${WORK}/checkout)
file(CREATE_LINK ${prefix}/bin/eyrie ${WORK}/checkout/eyrie SYMBOLIC)
type(${CMAKE_CURRENT_LIST_DIR}/../../README.md ${WORK}/checkout "navigate +-> greet +navigate voted 10 against 50")
