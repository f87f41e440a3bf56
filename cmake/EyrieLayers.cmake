# SPDX-License-Identifier: MIT
# eyrie_layer(NAME LINK libs... PRIVATE libs...)
# Makes eyrie_NAME from src/NAME/**/*.cpp (header-only layers become INTERFACE-like with an empty
# anchor) and, with EYRIE_TESTS, NAME_test from src/NAME/**/*_test.cpp. What the tests of a layer
# and others share is in tests/support/NAME: eyrie_NAME_testing.
function(eyrie_layer name)
  cmake_parse_arguments(ARG "" "" "LINK;PRIVATE" ${ARGN})
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/src/${name}/*.cpp)
  set(tests ${sources})
  list(FILTER sources EXCLUDE REGEX "_test\\.cpp$")
  list(FILTER tests INCLUDE REGEX "_test\\.cpp$")
  file(GLOB testing CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/tests/support/${name}/*.cpp)
  if(EYRIE_LEFT_OUT)
    list(FILTER sources EXCLUDE REGEX ${EYRIE_LEFT_OUT})
  endif()
  if(sources)
    add_library(eyrie_${name} STATIC ${sources})
    target_link_libraries(eyrie_${name} PUBLIC eyrie_options ${ARG_LINK} PRIVATE ${ARG_PRIVATE})
    eyrie_optimizes(eyrie_${name} ${name})
  else()
    add_library(eyrie_${name} INTERFACE)
    target_link_libraries(eyrie_${name} INTERFACE eyrie_options ${ARG_LINK} ${ARG_PRIVATE})
  endif()
  add_library(Eyrie::${name} ALIAS eyrie_${name})
  set_property(GLOBAL APPEND PROPERTY EYRIE_LAYERS ${name})
  set(needs ${ARG_LINK})
  list(FILTER needs INCLUDE REGEX "^eyrie_")
  list(TRANSFORM needs REPLACE "^eyrie_" "")
  list(JOIN needs " " needs)
  set_property(GLOBAL APPEND_STRING PROPERTY EYRIE_LAYERS_NEED "set(_eyrie_needs_${name} ${needs})\n")
  if(testing AND (EYRIE_TESTS OR EYRIE_BENCH))
    if(name STREQUAL "pilot")  # compiled once, by the library that is installed too
      add_library(eyrie_pilot_testing INTERFACE)
      target_link_libraries(eyrie_pilot_testing INTERFACE eyrie_testing eyrie_test_support $<TARGET_NAME_IF_EXISTS:rapidcheck>)
    else()
      add_library(eyrie_${name}_testing STATIC EXCLUDE_FROM_ALL ${testing})
      target_link_libraries(eyrie_${name}_testing PUBLIC eyrie_${name} eyrie_test_support
                                                         $<TARGET_NAME_IF_EXISTS:rapidcheck>)
    endif()
  endif()
  if(EYRIE_TESTS AND tests)
    add_executable(${name}_test ${tests})
    target_link_libraries(${name}_test PRIVATE ${ARG_PRIVATE})
    if(testing)
      target_link_libraries(${name}_test PRIVATE eyrie_${name}_testing)
    endif()
    eyrie_test_executable(${name}_test LINK eyrie_${name})
    if(name MATCHES "^(pilot|scenario|record|train|debrief|dis|live|page|campaign|tables)$")  # which load missiles
      target_sources(${name}_test PRIVATE ${PROJECT_SOURCE_DIR}/tests/support/launch_zones.cpp)
    endif()
    eyrie_suites(${name}_test ${name} 300)
  endif()
endfunction()

# eyrie_header_print(TARGET layers...)
# Gives TARGET scenario/header_print.hpp, which is another as soon as a header of one of the layers is.
function(eyrie_header_print target)
  set(folder ${PROJECT_BINARY_DIR}/generated)
  set(headers "")
  foreach(layer ${ARGN})
    file(GLOB_RECURSE of_layer CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/src/${layer}/*.hpp)
    list(APPEND headers ${of_layer})
  endforeach()
  list(JOIN ARGN "," layers)
  add_custom_command(OUTPUT ${folder}/stamp BYPRODUCTS ${folder}/scenario/header_print.hpp VERBATIM
                     DEPENDS ${headers} ${PROJECT_SOURCE_DIR}/cmake/header_print.cmake
                     COMMAND ${CMAKE_COMMAND} -D SOURCE=${PROJECT_SOURCE_DIR}/src -D LAYERS=${layers}
                             -D OUT=${folder}/scenario/header_print.hpp -P ${PROJECT_SOURCE_DIR}/cmake/header_print.cmake
                     COMMAND ${CMAKE_COMMAND} -E touch ${folder}/stamp)
  target_sources(${target} PRIVATE ${folder}/stamp)
  target_include_directories(${target} PUBLIC $<BUILD_INTERFACE:${folder}>)
endfunction()

# eyrie_optimizes(TARGET LAYER)
# Compiling is what counts where little time is spent running: -O1 for what reads, asks and writes beside a run. Sanitized code is
# slow to compile as it is to run: there only what flies is optimized.
function(eyrie_optimizes target layer)
  if(EYRIE_SANITIZE)
    if(NOT layer MATCHES "^(core|sim|model|pilot|ubf|team|record)$")
      target_compile_options(${target} PRIVATE -O0)
    endif()
  elseif(NOT EYRIE_WASM  # the page has everything with -Os
         AND layer MATCHES "^(scenario|record|debrief|stats|sql|net|campaign|dis|live|tables|page|apps|web)$")
    target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O1>)
  endif()
endfunction()

# eyrie_links_layers_first(TARGET libs...)
# The linker keeps the first copy of an inline function that it meets. With this it is that of the lowest layer, which is
# optimised, and not that of the target's own sources.
function(eyrie_links_layers_first target)
  set(used "")
  set(libs ${ARGN})
  while(NOT libs STREQUAL "")
    list(POP_FRONT libs lib)
    if(lib MATCHES "^eyrie_" AND TARGET ${lib} AND NOT lib IN_LIST used)
      list(APPEND used ${lib})
      get_target_property(below ${lib} INTERFACE_LINK_LIBRARIES)
      list(APPEND libs ${below})
    endif()
  endwhile()
  get_property(layers GLOBAL PROPERTY EYRIE_LAYERS)
  set(files "")
  foreach(layer ${layers})
    if(eyrie_${layer} IN_LIST used)
      get_target_property(type eyrie_${layer} TYPE)
      if(type STREQUAL "STATIC_LIBRARY")
        string(APPEND files ",$<TARGET_FILE:eyrie_${layer}>")
      endif()
    endif()
  endforeach()
  target_link_options(${target} PRIVATE "LINKER:--whole-archive${files},--no-whole-archive")
endfunction()

# eyrie_test_executable(TARGET LINK libs...)
# What is tested is optimised as it is shipped; the tests themselves need not be. What they include
# most is parsed once, by the first of them.
function(eyrie_test_executable target)
  cmake_parse_arguments(ARG "" "" "LINK" ${ARGN})
  target_link_libraries(${target} PRIVATE ${ARG_LINK} eyrie_test_support GTest::gtest_main rapidcheck
                        rapidcheck_gtest)
  eyrie_links_layers_first(${target} ${ARG_LINK})
  target_compile_options(${target} PRIVATE -O0)
  set_target_properties(${target} PROPERTIES UNITY_BUILD_BATCH_SIZE 16)
  get_property(owner GLOBAL PROPERTY EYRIE_PRECOMPILED_BY)
  if(owner)
    target_precompile_headers(${target} REUSE_FROM ${owner})
  else()
    target_precompile_headers(${target} PRIVATE <gtest/gtest.h> <rapidcheck/gtest.h> <algorithm>
      <array> <cmath> <filesystem> <fstream> <map> <memory> <optional> <set> <span> <string>
      <vector> <fmt/format.h>)
    set_property(GLOBAL PROPERTY EYRIE_PRECOMPILED_BY ${target})
  endif()
endfunction()

# What tests and benchmarks share: the counting allocator and the files of data/.
if(EYRIE_TESTS OR EYRIE_BENCH)
  find_package(GTest REQUIRED)
  add_library(eyrie_test_support OBJECT EXCLUDE_FROM_ALL
              ${PROJECT_SOURCE_DIR}/tests/support/no_allocation.cpp
              ${PROJECT_SOURCE_DIR}/tests/support/data_file.cpp)
  target_link_libraries(eyrie_test_support PUBLIC eyrie_options fmt::fmt GTest::gtest)
  target_include_directories(eyrie_test_support PUBLIC ${PROJECT_SOURCE_DIR}/tests)
endif()
