# What `cmake --install` installs. Its components are headers, library, programs and programs_mpi (see program/), and
# python (see python/); the headers alone need no build before: `cmake --install BUILD --component headers`.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)
set(config_dir ${CMAKE_INSTALL_DATADIR}/cmake/Boundary_recovery_3)
install(TARGETS Boundary_recovery_3 EXPORT Boundary_recovery_3Targets)
install(DIRECTORY include/CGAL DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT headers FILES_MATCHING PATTERN "*.h")
install(FILES LICENSE README.md CHANGES.md DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/Boundary_recovery_3 COMPONENT headers)
install(EXPORT Boundary_recovery_3Targets NAMESPACE Boundary_recovery_3:: DESTINATION ${config_dir} COMPONENT headers)

# The compiled library depends on the architecture, on whether the TBB and METIS were there, and may be left out: its
# targets are in a file of their own.
set(architecture ARCH_INDEPENDENT)
if(TARGET Boundary_recovery_3_compiled AND BR3_LIBRARY_IS_WHOLE)
  unset(architecture)
  install(TARGETS Boundary_recovery_3_compiled EXPORT Boundary_recovery_3CompiledTargets
          ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT library
          LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT library
          RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT library)
  install(EXPORT Boundary_recovery_3CompiledTargets NAMESPACE Boundary_recovery_3:: DESTINATION ${config_dir}
          COMPONENT library)
endif()

configure_package_config_file(cmake/Boundary_recovery_3Config.cmake.in
  Boundary_recovery_3Config.cmake INSTALL_DESTINATION ${config_dir})
write_basic_package_version_file(Boundary_recovery_3ConfigVersion.cmake COMPATIBILITY SameMinorVersion ${architecture})
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/Boundary_recovery_3Config.cmake
              ${CMAKE_CURRENT_BINARY_DIR}/Boundary_recovery_3ConfigVersion.cmake
        DESTINATION ${config_dir} COMPONENT headers)
