# SPDX-License-Identifier: MIT
# The library of behaviors by itself: below WORK a project adds the folder EYRIE and builds with it; what that installs is
# found by the same project again. Neither may look for what ubf has no use for.
include(${CMAKE_CURRENT_LIST_DIR}/command.cmake)

file(REMOVE_RECURSE ${WORK})
set(without)
foreach(package GeographicLib nlohmann_json CLI11 ZLIB)
  list(APPEND without -DCMAKE_DISABLE_FIND_PACKAGE_${package}=ON)
endforeach()
file(READ ${EYRIE}/examples/01_first_tree.txt first_tree)
set(from_yaml "9 m: root/turn with 10
1 m: root/guard/avoid with 25
robot.yaml:1:8: turn has no parameter 'buy'; did you mean 'by'?
")
foreach(way "added;-DEYRIE=${EYRIE}" "found;-DCMAKE_PREFIX_PATH=${WORK}/installed")
  list(GET way 0 name)
  list(GET way 1 option)
  run(${CMAKE_COMMAND} -S ${CMAKE_CURRENT_LIST_DIR}/alone -B ${WORK}/${name} -G Ninja ${without} ${option}
      -DEXAMPLES=${EYRIE}/examples -DCMAKE_BUILD_TYPE=Debug -DCMAKE_CXX_COMPILER=${COMPILER})
  run(${CMAKE_COMMAND} --build ${WORK}/${name})
  foreach(program first_tree from_yaml)
    run(${WORK}/${name}/${program})
    if(NOT output STREQUAL "${${program}}")
      message(FATAL_ERROR "${program}, ${name}, prints\n${output}instead of\n${${program}}")
    endif()
    run(ldd ${WORK}/${name}/${program})
    if(output MATCHES Geographic)
      message(FATAL_ERROR "${program} links geodesy:\n${output}")
    endif()
  endforeach()
  run(ninja -C ${WORK}/${name} -t commands CMakeFiles/from_yaml.dir/from_yaml.cpp.o)
  if(output MATCHES "-Wconversion|prefix-map" OR NOT output MATCHES "-ffp-contract=off")
    message(FATAL_ERROR "from_yaml, ${name}, is compiled as Eyrie itself, or without what its headers need:\n${output}")
  endif()
  if(name STREQUAL "added")
    run(${CMAKE_COMMAND} --install ${WORK}/added --prefix ${WORK}/installed)
  endif()
endforeach()

# what was installed there is told to who asks for more
file(WRITE ${WORK}/asks/CMakeLists.txt "cmake_minimum_required(VERSION 3.25)
project(Asks LANGUAGES NONE)
find_package(Eyrie REQUIRED COMPONENTS plugin)
")
execute_process(COMMAND ${CMAKE_COMMAND} -S ${WORK}/asks -B ${WORK}/asks/build -DCMAKE_PREFIX_PATH=${WORK}/installed
                OUTPUT_QUIET ERROR_VARIABLE said RESULT_VARIABLE code)
if(code EQUAL 0 OR NOT said MATCHES "has no component 'plugin', only[ \n]+core,[ \n]+ubf")
  message(FATAL_ERROR "a component that is not installed is answered with\n${said}")
endif()
