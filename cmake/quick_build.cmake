# Most of the time of our CI is the compiler's, and much of that goes to the same headers of CGAL again and again.
set(br3_precompiled_headers <CGAL/Delaunay_triangulation_3.h> <CGAL/Exact_predicates_exact_constructions_kernel.h>
  <CGAL/Exact_predicates_inexact_constructions_kernel.h>)

# br3_build_quickly(FOLDER OPTION...): compiles the programs of this folder with these options, too. What most of them
# include is parsed once for all that have the same options, and Clang also instantiates its templates once; but not for
# those that are linked with more than the first one is, or define macros before they include CGAL.
function(br3_build_quickly folder)
  get_property(targets DIRECTORY ${folder} PROPERTY BUILDSYSTEM_TARGETS)
  foreach(target ${targets})
    get_target_property(type ${target} TYPE)
    if(NOT type STREQUAL "EXECUTABLE")
      continue()
    endif()
    target_compile_options(${target} PRIVATE ${ARGN})
    get_target_property(source ${target} SOURCES)
    get_target_property(source_dir ${target} SOURCE_DIR)
    cmake_path(ABSOLUTE_PATH source BASE_DIRECTORY ${source_dir})
    file(STRINGS ${source} macros REGEX "^#define CGAL_" LIMIT_COUNT 1)
    get_target_property(definitions ${target} COMPILE_DEFINITIONS)
    get_target_property(libraries ${target} LINK_LIBRARIES)
    if(NOT DEFINED usual_libraries)
      set(usual_libraries ${libraries})
    endif()
    if(libraries STREQUAL usual_libraries AND NOT definitions AND NOT macros)
      br3_reuse_precompiled_headers(${target})
    endif()
  endforeach()
endfunction()

# Of a library that has the options of this target.
function(br3_reuse_precompiled_headers target)
  get_target_property(options ${target} COMPILE_OPTIONS)
  get_target_property(libraries ${target} LINK_LIBRARIES)
  string(MD5 name "${options} ${libraries}")
  set(library precompiled_headers_${name})
  if(NOT TARGET ${library})
    file(CONFIGURE OUTPUT ${CMAKE_BINARY_DIR}/${library}.cpp CONTENT "// only for its precompiled headers\n")
    add_library(${library} OBJECT EXCLUDE_FROM_ALL ${CMAKE_BINARY_DIR}/${library}.cpp)
    set_target_properties(${library} PROPERTIES COMPILE_OPTIONS "${options}" LINK_LIBRARIES "${libraries}")
    target_precompile_headers(${library} PRIVATE ${br3_precompiled_headers})
  endif()
  target_precompile_headers(${target} REUSE_FROM ${library})
endfunction()
