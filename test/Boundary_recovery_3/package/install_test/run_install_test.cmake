# Installs the headers, and the compiled library if there is one, into an empty folder, then configures, builds and runs a
# project that knows only that folder.
# cmake -DBUILD_DIR= -DSOURCE_DIR= -DSCRATCH_DIR= -DCGAL_DIR= -DCXX_COMPILER= -DVERSION= -DCOMPILED= -P run_install_test.cmake

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
run(${CMAKE_COMMAND} --install ${BUILD_DIR} --prefix ${prefix} --component headers)
if(COMPILED)
  run(${CMAKE_COMMAND} --install ${BUILD_DIR} --prefix ${prefix} --component library)
endif()

file(GLOB_RECURSE expected RELATIVE ${SOURCE_DIR}/include ${SOURCE_DIR}/include/*.h)
file(GLOB_RECURSE installed RELATIVE ${prefix}/include ${prefix}/include/*)
if(NOT expected STREQUAL installed)
  message(FATAL_ERROR "installed headers: ${installed}\nexpected: ${expected}")
endif()

# The consumer lies outside the source tree, so that nothing can be found through a relative path.
file(COPY ${SOURCE_DIR}/test/Boundary_recovery_3/package/install_test/consumer DESTINATION ${SCRATCH_DIR})
run(${CMAKE_COMMAND} -S ${SCRATCH_DIR}/consumer -B ${consumer} -DCMAKE_BUILD_TYPE=None
    -DCMAKE_CXX_COMPILER=${CXX_COMPILER} -DCGAL_DIR=${CGAL_DIR} -DCMAKE_PREFIX_PATH=${prefix}
    -DREQUESTED_VERSION=${VERSION} -DEXPECTED_PREFIX=${prefix} -DCOMPILED=${COMPILED})
run(${CMAKE_COMMAND} --build ${consumer})
run(${consumer}/consumer)

# What is not there must be refused: expect_refusal(NAME MESSAGE OPTION...)
function(expect_refusal name message)
  execute_process(COMMAND ${CMAKE_COMMAND} -S ${SCRATCH_DIR}/consumer -B ${SCRATCH_DIR}/build_of_wrong_${name}
      -DCMAKE_CXX_COMPILER=${CXX_COMPILER} -DCGAL_DIR=${CGAL_DIR} -DCMAKE_PREFIX_PATH=${prefix}
      -DEXPECTED_PREFIX=${prefix} ${ARGN}
    RESULT_VARIABLE result OUTPUT_QUIET ERROR_VARIABLE messages)
  if(result EQUAL 0 OR NOT messages MATCHES "${message}")
    message(FATAL_ERROR "the wrong ${name} was not refused as such:\n${messages}")
  endif()
endfunction()

expect_refusal(version "compatible with requested version \"99.0\"" -DREQUESTED_VERSION=99.0)
if(NOT COMPILED)
  expect_refusal(component "compiled is not installed" -DREQUESTED_VERSION=${VERSION} -DCOMPILED=ON)
endif()
