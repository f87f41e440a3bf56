# SPDX-License-Identifier: MIT
# eyrie_layer(NAME LINK libs... PRIVATE libs...)
# Makes eyrie_NAME from src/NAME/**/*.cpp (header-only layers become INTERFACE-like with an empty
# anchor) and, with EYRIE_TESTS, NAME_test from src/NAME/**/*_test.cpp.
function(eyrie_layer name)
  cmake_parse_arguments(ARG "" "" "LINK;PRIVATE" ${ARGN})
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/src/${name}/*.cpp)
  set(tests ${sources})
  list(FILTER sources EXCLUDE REGEX "_test\\.cpp$")
  list(FILTER tests INCLUDE REGEX "_test\\.cpp$")
  if(sources)
    add_library(eyrie_${name} STATIC ${sources})
    target_link_libraries(eyrie_${name} PUBLIC eyrie_options ${ARG_LINK} PRIVATE ${ARG_PRIVATE})
  else()
    add_library(eyrie_${name} INTERFACE)
    target_link_libraries(eyrie_${name} INTERFACE eyrie_options ${ARG_LINK} ${ARG_PRIVATE})
  endif()
  add_library(Eyrie::${name} ALIAS eyrie_${name})
  if(EYRIE_TESTS AND tests)
    add_executable(${name}_test ${tests})
    target_link_libraries(${name}_test PRIVATE eyrie_${name} eyrie_test_main ${ARG_PRIVATE})
    # what is tested is optimised as it is shipped; the tests themselves need not be
    target_compile_options(${name}_test PRIVATE -O1)
    gtest_discover_tests(${name}_test TEST_PREFIX ${name}. DISCOVERY_MODE PRE_TEST
                         WORKING_DIRECTORY ${CMAKE_SOURCE_DIR} PROPERTIES TIMEOUT 300)
  endif()
endfunction()

# What every test executable links: GoogleTest, RapidCheck and the counting allocator.
if(EYRIE_TESTS)
  find_package(GTest REQUIRED)
  find_package(rapidcheck REQUIRED)
  add_library(eyrie_test_main OBJECT ${CMAKE_SOURCE_DIR}/tests/support/no_allocation.cpp)
  target_link_libraries(eyrie_test_main PUBLIC eyrie_options GTest::gtest_main rapidcheck
                        rapidcheck_gtest)
  target_include_directories(eyrie_test_main PUBLIC ${CMAKE_SOURCE_DIR}/tests)
endif()
