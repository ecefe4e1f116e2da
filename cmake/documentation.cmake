# The target `doc`: the manual, made by Doxygen from the files that CGAL's own documentation build would read.
find_package(Doxygen QUIET)
if(DOXYGEN_FOUND)
  # Formulas are shown by MathJax. Debian's copy of it (libjs-mathjax) is put beside the pages, as far as they need it, so
  # that they need no network; without it, they load MathJax from the net.
  find_path(BR3_MATHJAX_DIR MathJax.js PATHS /usr/share/javascript/mathjax NO_DEFAULT_PATH)
  mark_as_advanced(BR3_MATHJAX_DIR)
  set(BR3_MATHJAX_SETTINGS "")
  set(br3_copy_mathjax "")
  if(BR3_MATHJAX_DIR)
    # SVG needs no fonts, which some browsers do not load for local pages.
    set(BR3_MATHJAX_SETTINGS "MATHJAX_RELPATH = mathjax\nMATHJAX_FORMAT = SVG")
    if(DOXYGEN_VERSION VERSION_GREATER_EQUAL 1.9.2)
      string(APPEND BR3_MATHJAX_SETTINGS "\nMATHJAX_VERSION = MathJax_2") # Debian's; Doxygen's default may change
    endif()
    set(br3_mathjax_target ${CMAKE_CURRENT_BINARY_DIR}/doc_output/mathjax)
    foreach(folder extensions jax/element jax/input/TeX jax/output/SVG/autoload jax/output/SVG/fonts/TeX)
      list(APPEND br3_copy_mathjax
           COMMAND ${CMAKE_COMMAND} -E copy_directory ${BR3_MATHJAX_DIR}/${folder} ${br3_mathjax_target}/${folder})
    endforeach()
    foreach(file MathJax.js jax/output/SVG/config.js jax/output/SVG/jax.js)
      list(APPEND br3_copy_mathjax
           COMMAND ${CMAKE_COMMAND} -E copy_if_different ${BR3_MATHJAX_DIR}/${file} ${br3_mathjax_target}/${file})
    endforeach()
  endif()

  set(CGAL_DOC_VERSION ${CGAL_VERSION})
  set(CGAL_PACKAGE_DOC_DIR ${CMAKE_CURRENT_SOURCE_DIR}/doc/Boundary_recovery_3)
  set(CGAL_DOC_PACKAGE_DEFAULTS ${CMAKE_CURRENT_BINARY_DIR}/defaults.dxy)
  configure_file(doc/standalone_defaults.dxy.in ${CGAL_DOC_PACKAGE_DEFAULTS})
  configure_file(doc/Boundary_recovery_3/Doxyfile.in Boundary_recovery_3.dxy)
  # CGAL puts its version before the title; outside of CGAL it would be that of another project.
  file(APPEND ${CMAKE_CURRENT_BINARY_DIR}/Boundary_recovery_3.dxy "PROJECT_NAME = \"3D Boundary Recovery\"\n")
  add_custom_target(doc COMMAND Doxygen::doxygen Boundary_recovery_3.dxy ${br3_copy_mathjax}
                    WORKING_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR} VERBATIM)
endif()
