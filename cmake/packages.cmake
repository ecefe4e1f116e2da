# What `cpack` makes of what is built: Debian packages of the programs, with and without MPI, of the headers and the library, and of the
# Python module. scripts/make_packages builds what they need, and makes them. The library is to be static, as it is by default:
# then none of the packages needs another one.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME boundary-recovery)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_GROUPING ONE_PER_GROUP)
set(CPACK_COMPONENT_HEADERS_GROUP development)
set(CPACK_COMPONENT_LIBRARY_GROUP development)
set(CPACK_COMPONENTS_ALL headers)

# What all of them have in common; dpkg-shlibdeps finds out what the programs are linked to.
file(STRINGS package_info/Boundary_recovery_3/maintainer CPACK_PACKAGE_CONTACT)
file(READ package_info/Boundary_recovery_3/long_description.txt long_description)
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "tetrahedral meshes that keep a given surface")
string(STRIP "${long_description}" long_description)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION math)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)

# br3_add_package(PACKAGE KEY COMPONENT CONTENTS): the description, and the licence where Debian wants it. KEY is the
# component that the package has, or the group of components, of which COMPONENT is one.
function(br3_add_package package key component contents)
  string(TOUPPER ${key} name)
  set(CPACK_DEBIAN_${name}_PACKAGE_NAME ${package} PARENT_SCOPE)
  set(CPACK_COMPONENT_${name}_DESCRIPTION "${long_description}\n.\nThis package has ${contents}." PARENT_SCOPE)
  install(FILES packaging/debian/copyright DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${package}
          COMPONENT ${component} EXCLUDE_FROM_ALL)
endfunction()

br3_add_package(libboundary-recovery-dev development headers "what is needed to use it in C++")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "libcgal-dev (>= 5.5)")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_RECOMMENDS "g++, cmake, make")
if(TARGET Boundary_recovery_3_compiled)
  list(APPEND CPACK_COMPONENTS_ALL library)
  foreach(library ${BR3_LIBRARIES_OF_COMPILED})
    string(TOLOWER ${library} name)
    string(APPEND CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS ", lib${name}-dev")
  endforeach()
else()
  set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_ARCHITECTURE all)
endif()

if(BR3_BUILD_PROGRAMS)
  list(APPEND CPACK_COMPONENTS_ALL programs)
  br3_add_package(boundary-recovery programs programs "the programs, which read and write files")
  set(CPACK_DEBIAN_PROGRAMS_PACKAGE_RECOMMENDS python3) # for what draws
  # The package of Gmsh's library, which the programs load if it is there.
  if(BR3_WITH_GMSH AND GMSH_LIBRARY)
    file(REAL_PATH ${GMSH_LIBRARY} gmsh_library)
    execute_process(COMMAND dpkg-query -S ${gmsh_library} OUTPUT_VARIABLE owner ERROR_QUIET)
    if(owner MATCHES "^([^:]+):")
      set(CPACK_DEBIAN_PROGRAMS_PACKAGE_SUGGESTS ${CMAKE_MATCH_1})
    endif()
  endif()
endif()

if(TARGET mesh_surface_mpi)
  list(APPEND CPACK_COMPONENTS_ALL programs_mpi)
  br3_add_package(boundary-recovery-mpi programs_mpi programs_mpi "the program for several machines")
  set(CPACK_DEBIAN_PROGRAMS_MPI_PACKAGE_DEPENDS openmpi-bin) # without mpirun, the program does not start
endif()

if(TARGET boundary_recovery_python)
  list(APPEND CPACK_COMPONENTS_ALL python)
  br3_add_package(python3-boundary-recovery python python "the module for Python")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
  # The compiled half is for this Python only, and is not found by another one.
  find_package(Python QUIET COMPONENTS Interpreter)
  math(EXPR next_minor "${Python_VERSION_MINOR} + 1")
  string(CONCAT CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS "python3 (>= ${Python_VERSION_MAJOR}.${Python_VERSION_MINOR}), "
         "python3 (<< ${Python_VERSION_MAJOR}.${next_minor}), python3-numpy")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SUGGESTS "python3-meshio, python3-vtk9")
endif()

include(CPack)
