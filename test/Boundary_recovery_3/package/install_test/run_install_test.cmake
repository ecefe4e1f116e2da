# Installs the package into an empty folder, then configures, builds and runs a project that knows only that folder.
# cmake -DBUILD_DIR= -DSOURCE_DIR= -DSCRATCH_DIR= -DCGAL_DIR= -DCXX_COMPILER= -DVERSION= -P run_install_test.cmake

function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE result)
  if(NOT result EQUAL 0)
    string(JOIN " " command ${ARGN})
    message(FATAL_ERROR "failed (${result}): ${command}")
  endif()
endfunction()

set(prefix ${SCRATCH_DIR}/prefix)
set(consumer ${SCRATCH_DIR}/build)
file(REMOVE_RECURSE ${SCRATCH_DIR})
run(${CMAKE_COMMAND} --install ${BUILD_DIR} --prefix ${prefix})

file(GLOB_RECURSE expected RELATIVE ${SOURCE_DIR}/include ${SOURCE_DIR}/include/*.h)
file(GLOB_RECURSE installed RELATIVE ${prefix}/include ${prefix}/include/*)
if(NOT expected STREQUAL installed)
  message(FATAL_ERROR "installed headers: ${installed}\nexpected: ${expected}")
endif()

# The consumer lies outside the source tree, so that nothing can be found through a relative path.
file(COPY ${SOURCE_DIR}/test/Boundary_recovery_3/package/install_test/consumer DESTINATION ${SCRATCH_DIR})
run(${CMAKE_COMMAND} -S ${SCRATCH_DIR}/consumer -B ${consumer} -DCMAKE_BUILD_TYPE=None
    -DCMAKE_CXX_COMPILER=${CXX_COMPILER} -DCGAL_DIR=${CGAL_DIR} -DCMAKE_PREFIX_PATH=${prefix}
    -DREQUESTED_VERSION=${VERSION} -DEXPECTED_PREFIX=${prefix})
run(${CMAKE_COMMAND} --build ${consumer})
run(${consumer}/consumer)

# A version that is not there must be refused.
execute_process(COMMAND ${CMAKE_COMMAND} -S ${SCRATCH_DIR}/consumer -B ${SCRATCH_DIR}/build_of_wrong_version
    -DCMAKE_CXX_COMPILER=${CXX_COMPILER} -DCGAL_DIR=${CGAL_DIR} -DCMAKE_PREFIX_PATH=${prefix}
    -DREQUESTED_VERSION=99.0 -DEXPECTED_PREFIX=${prefix}
  RESULT_VARIABLE result OUTPUT_QUIET ERROR_VARIABLE messages)
if(result EQUAL 0 OR NOT messages MATCHES "compatible with requested version \"99.0\"")
  message(FATAL_ERROR "version 99.0 was not refused as such:\n${messages}")
endif()
