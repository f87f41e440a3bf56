# SPDX-License-Identifier: MIT
# cmake --install: the program with its data and scenarios, and each layer as a component of the
# package: find_package(Eyrie COMPONENTS ubf) gives Eyrie::ubf and what that needs, which is core.
include(CMakePackageConfigHelpers)
# whatever umask it is installed with
set(CMAKE_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(package lib/cmake/Eyrie)

install(TARGETS eyrie_options EXPORT EyrieTargets-core)
get_property(layers GLOBAL PROPERTY EYRIE_LAYERS)
get_property(layers_need GLOBAL PROPERTY EYRIE_LAYERS_NEED)
foreach(layer ${layers})
  set_target_properties(eyrie_${layer} PROPERTIES EXPORT_NAME ${layer})
  install(TARGETS eyrie_${layer} EXPORT EyrieTargets-${layer} DESTINATION lib COMPONENT library)
  install(EXPORT EyrieTargets-${layer} NAMESPACE Eyrie:: DESTINATION ${package} COMPONENT library)
  install(DIRECTORY src/${layer} DESTINATION include/eyrie COMPONENT library FILES_MATCHING PATTERN "*.hpp"
          PATTERN "*test*" EXCLUDE)
endforeach()

set(parts ${layers})
if(NOT EYRIE_UBF_ONLY)
  list(APPEND parts testing plugin)
endif()
configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/EyrieConfig.cmake.in EyrieConfig.cmake INSTALL_DESTINATION ${package})
write_basic_package_version_file(EyrieConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/EyrieConfig.cmake ${PROJECT_BINARY_DIR}/EyrieConfigVersion.cmake
        DESTINATION ${package} COMPONENT library)

if(EYRIE_UBF_ONLY)
  return()
endif()

install(FILES ${PROJECT_BINARY_DIR}/generated/scenario/header_print.hpp DESTINATION include/eyrie/scenario COMPONENT library)
install(TARGETS eyrie DESTINATION bin COMPONENT program)
install(DIRECTORY data scenarios DESTINATION share/eyrie COMPONENT program)
install(FILES ${PROJECT_BINARY_DIR}/viewer/debrief.html ${PROJECT_BINARY_DIR}/viewer/playground.html
        DESTINATION share/eyrie COMPONENT program OPTIONAL)
install(DIRECTORY examples/plugin DESTINATION share/eyrie/examples COMPONENT program PATTERN build EXCLUDE)

# the cockpit for tests of behaviors, pilot/testing.hpp, without what Eyrie's own tests need besides
add_library(eyrie_testing STATIC tests/support/pilot/testing.cpp tests/support/data_file.cpp)
target_include_directories(eyrie_testing PRIVATE tests)
target_link_libraries(eyrie_testing PUBLIC eyrie_pilot)
set_target_properties(eyrie_testing PROPERTIES EXPORT_NAME testing UNITY_BUILD OFF)
install(TARGETS eyrie_testing EXPORT EyrieTargets-testing DESTINATION lib COMPONENT library)
install(EXPORT EyrieTargets-testing NAMESPACE Eyrie:: DESTINATION ${package} COMPONENT library)
install(FILES tests/support/pilot/testing.hpp DESTINATION include/eyrie/pilot COMPONENT library)
install(FILES tests/support/model/flying.hpp tests/support/model/stores.hpp DESTINATION include/eyrie/support/model COMPONENT library)
install(FILES cmake/EyriePlugin.cmake DESTINATION ${package} COMPONENT library)
install(FILES cmake/plugin_test_main.cpp DESTINATION share/eyrie COMPONENT library)

# all that is installed; and the package beside the build, for whoever works from a checkout (./eyrie new)
list(TRANSFORM layers PREPEND eyrie_ OUTPUT_VARIABLE targets)
add_custom_target(eyrie_parts DEPENDS eyrie eyrie_testing ${targets})
add_custom_target(eyrie_package DEPENDS eyrie_parts VERBATIM
                  COMMAND ${CMAKE_COMMAND} --install ${PROJECT_BINARY_DIR} --prefix ${PROJECT_BINARY_DIR}/package > install.log)
