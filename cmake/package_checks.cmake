# Tests of the package rather than of the code: headers alone, conventions, data, installation, manual.

set(br3_package_tests ${CMAKE_CURRENT_SOURCE_DIR}/test/Boundary_recovery_3/package)

# Registers a test that reports itself as skipped, with the reason.
function(br3_add_skipped_test name reason)
  add_test(NAME ${name} COMMAND ${CMAKE_COMMAND} -E echo "skipped: ${reason}")
  set_tests_properties(${name} PROPERTIES SKIP_REGULAR_EXPRESSION "skipped: ")
endfunction()

# Every header alone, internal ones too: a header that leans on what another one includes does not compile. Where headers
# of CGAL are precompiled, only the headers that users include are to name all that they need of it.
file(GLOB_RECURSE br3_headers CONFIGURE_DEPENDS
     RELATIVE ${CMAKE_CURRENT_SOURCE_DIR}/include ${CMAKE_CURRENT_SOURCE_DIR}/include/CGAL/*.h)
add_library(headers_alone OBJECT)
target_link_libraries(headers_alone PRIVATE Boundary_recovery_3)
foreach(header ${br3_headers})
  string(MAKE_C_IDENTIFIER ${header} name)
  set(source ${CMAKE_CURRENT_BINARY_DIR}/headers_alone/${name}.cpp)
  file(CONFIGURE OUTPUT ${source} CONTENT "#include <${header}>\n")
  target_sources(headers_alone PRIVATE ${source})
  if(NOT header MATCHES "/internal/")
    set_source_files_properties(${source} PROPERTIES SKIP_PRECOMPILE_HEADERS ON)
  endif()
endforeach()
if(BR3_QUICK_BUILD)
  target_compile_options(headers_alone PRIVATE -O0)
  target_precompile_headers(headers_alone PRIVATE ${br3_precompiled_headers})
endif()

find_package(Python3 QUIET COMPONENTS Interpreter)
if(Python3_FOUND)
  add_test(NAME conventions COMMAND Python3::Interpreter
           ${br3_package_tests}/check_conventions.py ${CMAKE_CURRENT_SOURCE_DIR})
  add_test(NAME conventions_are_checked COMMAND Python3::Interpreter
           ${br3_package_tests}/check_conventions.py --self-test ${CMAKE_CURRENT_SOURCE_DIR})
  add_test(NAME data_is_reproducible COMMAND Python3::Interpreter
           ${CMAKE_CURRENT_SOURCE_DIR}/data/generate_meshes.py --check ${CMAKE_CURRENT_SOURCE_DIR}/data/meshes)
  set(br3_figures ${CMAKE_CURRENT_SOURCE_DIR}/doc/Boundary_recovery_3/fig)
  add_test(NAME figures_are_reproducible COMMAND Python3::Interpreter
           ${br3_figures}/draw_figures.py --check ${br3_figures})
  # br3_add_program_test(TEST PROGRAM SCRIPT ARGUMENT...)
  function(br3_add_program_test test program script)
    if(TARGET ${program})
      add_test(NAME ${test} COMMAND Python3::Interpreter ${br3_package_tests}/${script} $<TARGET_FILE:${program}> ${ARGN})
      set_tests_properties(${test} PROPERTIES DEPENDS compilation_of__${program} LABELS program)
    endif()
  endfunction()
  br3_add_program_test(program_behaves_as_documented recover_boundary test_program_br3.py)
  br3_add_program_test(mesh_surface_behaves_as_documented mesh_surface test_mesh_surface_br3.py)
  br3_add_program_test(names_and_polygons_of_surfaces mesh_surface test_named_surfaces_br3.py)
  br3_add_program_test(files_are_read_by_other_readers mesh_surface test_other_readers_br3.py)
  br3_add_program_test(faulty_surfaces_are_told_and_repaired mesh_surface test_faulty_surfaces_br3.py)
  br3_add_program_test(what_a_terminal_shows mesh_surface test_console_br3.py)
  br3_add_program_test(surfaces_of_needles_are_remeshed mesh_surface test_remesh_surface_br3.py)
  br3_add_program_test(mesh_surface_mpi_behaves_as_documented mesh_surface_mpi test_mesh_surface_mpi_br3.py
                       ${MPIEXEC_EXECUTABLE} $<TARGET_FILE:mesh_surface>)
  foreach(program mesh_surface mesh_surface_mpi recover_boundary)
    if(TARGET man_page_of_${program})
      add_test(NAME man_page_of_${program}_is_complete COMMAND Python3::Interpreter
               ${CMAKE_CURRENT_SOURCE_DIR}/program/make_man_page.py $<TARGET_FILE:${program}>
               --check $<TARGET_FILE_DIR:${program}>/${program}.1)
      set_tests_properties(man_page_of_${program}_is_complete PROPERTIES LABELS program)
    endif()
  endforeach()
  if(TARGET mesh_surface_mpi) # this runs for longest, and waits half of that for ranks to start and to end
    set_tests_properties(mesh_surface_mpi_behaves_as_documented PROPERTIES COST 10)
  endif()
  add_test(NAME model_of_parallel_runs COMMAND Python3::Interpreter
           ${CMAKE_CURRENT_SOURCE_DIR}/benchmark/Boundary_recovery_3/scaling_model.py --self-test)
else()
  br3_add_skipped_test(conventions "no python3 was found")
endif()

add_test(NAME install_and_find_package COMMAND ${CMAKE_COMMAND}
         -DBUILD_DIR=${CMAKE_CURRENT_BINARY_DIR} -DSOURCE_DIR=${CMAKE_CURRENT_SOURCE_DIR}
         -DSCRATCH_DIR=${CMAKE_CURRENT_BINARY_DIR}/install_test -DCGAL_DIR=${CGAL_DIR}
         -DCXX_COMPILER=${CMAKE_CXX_COMPILER} -DVERSION=${PROJECT_VERSION}
         -DCOMPILED=$<TARGET_EXISTS:Boundary_recovery_3_compiled>
         -P ${br3_package_tests}/install_test/run_install_test.cmake)
if(TARGET mesh_surface)
  set(programs recover_boundary mesh_surface $<$<TARGET_EXISTS:mesh_surface_mpi>:mesh_surface_mpi>)
  add_test(NAME programs_are_installed COMMAND ${CMAKE_COMMAND}
           -DBUILD_DIR=${CMAKE_CURRENT_BINARY_DIR} -DSCRATCH_DIR=${CMAKE_CURRENT_BINARY_DIR}/program_test
           "-DPROGRAMS=${programs}" -DMAN_PAGES=$<TARGET_EXISTS:man_page_of_mesh_surface>
           -P ${br3_package_tests}/install_test/check_programs.cmake)
  set_tests_properties(programs_are_installed PROPERTIES LABELS program)
endif()

if(DOXYGEN_FOUND)
  add_test(NAME manual_builds_without_warning
           COMMAND ${CMAKE_COMMAND} --build ${CMAKE_CURRENT_BINARY_DIR} --target doc)
  set_tests_properties(manual_builds_without_warning PROPERTIES FIXTURES_SETUP manual)
else()
  br3_add_skipped_test(manual_builds_without_warning "no doxygen was found")
endif()
if(DOXYGEN_FOUND AND Python3_FOUND)
  add_test(NAME manual_has_no_dead_link COMMAND Python3::Interpreter
           ${br3_package_tests}/check_manual.py ${CMAKE_CURRENT_BINARY_DIR}/doc_output)
  set_tests_properties(manual_has_no_dead_link PROPERTIES FIXTURES_REQUIRED manual)
  add_test(NAME dead_links_are_found COMMAND Python3::Interpreter
           ${br3_package_tests}/check_manual.py --self-test ${CMAKE_CURRENT_BINARY_DIR}/manual_self_test)
else()
  br3_add_skipped_test(manual_has_no_dead_link "no doxygen or no python3 was found")
endif()
if(DOXYGEN_FOUND AND BR3_MATHJAX_DIR)
  add_test(NAME formulas_need_no_network COMMAND ${CMAKE_COMMAND}
           -DPAGES=${CMAKE_CURRENT_BINARY_DIR}/doc_output -P ${br3_package_tests}/check_formulas.cmake)
  set_tests_properties(formulas_need_no_network PROPERTIES FIXTURES_REQUIRED manual)
else()
  br3_add_skipped_test(formulas_need_no_network "no doxygen or no MathJax was found")
endif()
