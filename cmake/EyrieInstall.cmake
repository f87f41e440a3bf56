# SPDX-License-Identifier: MIT
# cmake --install: the program with its data and scenarios, and each layer as a component of the
# package: find_package(Eyrie COMPONENTS ubf) gives Eyrie::ubf and what that needs, which is core.
include(CMakePackageConfigHelpers)
set(package lib/cmake/Eyrie)

install(TARGETS eyrie DESTINATION bin COMPONENT program)
install(DIRECTORY data scenarios DESTINATION share/eyrie COMPONENT program)

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

configure_package_config_file(cmake/EyrieConfig.cmake.in EyrieConfig.cmake INSTALL_DESTINATION ${package})
write_basic_package_version_file(EyrieConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/EyrieConfig.cmake ${PROJECT_BINARY_DIR}/EyrieConfigVersion.cmake
        DESTINATION ${package} COMPONENT library)
