# SPDX-License-Identifier: MIT
# eyrie_add_plugin(NAME source... [TEST source...] [SCENARIO file...])
# The plug-in libNAME.so (target NAME_plugin). It holds what it uses of Eyrie and shows EYRIE_PLUGIN alone, so that two
# plug-ins, or a plug-in and the program, never take each other's functions; the floating-point flags of Eyrie come with
# its targets. With TEST also the test NAME: sources in the words of GoogleTest and pilot/testing.hpp, whose decide()
# knows the plug-in's nodes. Each SCENARIO must pass `eyrie validate`. Editors find the JSON schema of scenarios with the
# plug-in's nodes in the build folder, NAME.schema.json.
function(eyrie_add_plugin name)
  cmake_parse_arguments(PARSE_ARGV 1 ARG "" "" "TEST;SCENARIO")
  add_library(${name}_objects OBJECT ${ARG_UNPARSED_ARGUMENTS})
  set_target_properties(${name}_objects PROPERTIES POSITION_INDEPENDENT_CODE ON CXX_EXTENSIONS OFF
                        CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON)
  target_compile_options(${name}_objects PRIVATE $<$<CONFIG:>:-O2>)
  target_link_libraries(${name}_objects PUBLIC Eyrie::scenario)
  add_library(${name}_plugin MODULE)
  set_target_properties(${name}_plugin PROPERTIES OUTPUT_NAME ${name} LINKER_LANGUAGE CXX)
  target_link_libraries(${name}_plugin PRIVATE ${name}_objects)
  target_link_options(${name}_plugin PRIVATE LINKER:--exclude-libs,ALL LINKER:--no-undefined)
  add_custom_command(TARGET ${name}_plugin POST_BUILD VERBATIM
                     COMMAND ${Eyrie_PROGRAM} catalog --json-schema --plugin $<TARGET_FILE:${name}_plugin> > ${name}.schema.json)
  if(ARG_TEST)
    find_package(GTest REQUIRED)
    add_executable(${name}_test ${ARG_TEST} ${Eyrie_SHARE}/plugin_test_main.cpp)
    set_target_properties(${name}_test PROPERTIES CXX_EXTENSIONS OFF)
    target_compile_definitions(${name}_test PRIVATE EYRIE_SHARE="${Eyrie_SHARE}")
    target_link_libraries(${name}_test PRIVATE ${name}_objects Eyrie::testing GTest::gtest)
    add_test(NAME ${name} COMMAND ${name}_test)
  endif()
  foreach(scenario IN LISTS ARG_SCENARIO)
    add_test(NAME ${scenario} COMMAND ${Eyrie_PROGRAM} validate ${scenario} --plugin $<TARGET_FILE:${name}_plugin>
             WORKING_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR})
  endforeach()
endfunction()
