# Not tested, as there was no vcpkg where this was written. It builds the files around it, not a release:
#   vcpkg install boundary-recovery-3 --overlay-ports=packaging/vcpkg
get_filename_component(SOURCE_PATH "${CMAKE_CURRENT_LIST_DIR}/../../.." ABSOLUTE)

vcpkg_check_features(OUT_FEATURE_OPTIONS options FEATURES programs BR3_BUILD_PROGRAMS)
vcpkg_cmake_configure(SOURCE_PATH "${SOURCE_PATH}"
  OPTIONS ${options} -DBUILD_TESTING=OFF -DBR3_BUILD_EXAMPLES=OFF)
vcpkg_cmake_install()
vcpkg_cmake_config_fixup(PACKAGE_NAME Boundary_recovery_3 CONFIG_PATH share/cmake/Boundary_recovery_3)
if("programs" IN_LIST FEATURES)
  vcpkg_copy_tools(TOOL_NAMES mesh_surface recover_boundary AUTO_CLEAN)
endif()
file(REMOVE_RECURSE "${CURRENT_PACKAGES_DIR}/debug/include" "${CURRENT_PACKAGES_DIR}/debug/share")
vcpkg_install_copyright(FILE_LIST "${SOURCE_PATH}/LICENSE")
