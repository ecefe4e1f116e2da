# The target `doc`: the manual, made by Doxygen from the files that CGAL's own documentation build would read.
find_package(Doxygen QUIET)
if(DOXYGEN_FOUND)
  set(CGAL_DOC_VERSION ${CGAL_VERSION})
  set(CGAL_PACKAGE_DOC_DIR ${CMAKE_CURRENT_SOURCE_DIR}/doc/Boundary_recovery_3)
  set(CGAL_DOC_PACKAGE_DEFAULTS ${CMAKE_CURRENT_BINARY_DIR}/defaults.dxy)
  configure_file(doc/standalone_defaults.dxy.in ${CGAL_DOC_PACKAGE_DEFAULTS})
  configure_file(doc/Boundary_recovery_3/Doxyfile.in Boundary_recovery_3.dxy)
  add_custom_target(doc COMMAND Doxygen::doxygen Boundary_recovery_3.dxy
                    WORKING_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR} VERBATIM)
endif()
