# SPDX-License-Identifier: MIT
# launch_zones.bin beside the program (installed: share/eyrie): the zones of the shipped missiles, flown while Eyrie is
# built by the very code that would fly them at load (apps/launch_zones). What is built for another machine cannot run
# here: there is no file then, and each load flies what it needs.
set(EYRIE_ZONES ${PROJECT_BINARY_DIR}/launch_zones.bin)

# eyrie_needs_launch_zones(TARGET): the file is there when the target is. Linking waits for it, compiling does not.
function(eyrie_needs_launch_zones target)
  if(NOT CMAKE_CROSSCOMPILING)
    set_property(TARGET ${target} APPEND PROPERTY LINK_DEPENDS ${EYRIE_ZONES})
  endif()
endfunction()

# eyrie_takes_launch_zones(TARGET SOURCE...): the same for a test or a benchmark, which also reads it when it begins.
# These sources know the file as EYRIE_ZONES.
function(eyrie_takes_launch_zones target)
  eyrie_needs_launch_zones(${target})
  target_sources(${target} PRIVATE ${PROJECT_SOURCE_DIR}/tests/support/launch_zones.cpp)
  # in these files alone, so that a checkout elsewhere shares the compiler cache for the others
  list(TRANSFORM ARGN PREPEND ${CMAKE_CURRENT_SOURCE_DIR}/)
  set_source_files_properties(${PROJECT_SOURCE_DIR}/tests/support/launch_zones.cpp ${ARGN} TARGET_DIRECTORY ${target}
                              PROPERTIES COMPILE_DEFINITIONS EYRIE_ZONES="${EYRIE_ZONES}")
endfunction()
