# Installs the library below FOLDER and builds and runs the example against it, found once by its CMake package and once by
# pkg-config. cmake -DBUILD=... -DSOURCE=... -DFOLDER=... -DLIBDIR=... -DFLAGS=... -P install_test.cmake
function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE failed OUTPUT_VARIABLE output ERROR_VARIABLE output)
  message("${output}")
  if(failed)
    message(FATAL_ERROR "failed: ${ARGN}")
  endif()
endfunction()

file(REMOVE_RECURSE ${FOLDER})
set(prefix ${FOLDER}/prefix)
run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${prefix} --component development)

# The example lies alone, as it would elsewhere: nothing of the source tree is found beside it.
file(COPY ${SOURCE}/examples/embed DESTINATION ${FOLDER})
set(common -S ${FOLDER}/embed -G Ninja -DCMAKE_BUILD_TYPE=Release "-DCMAKE_CXX_FLAGS=-Wall -Wextra -Wshadow -Werror ${FLAGS}")
run(${CMAKE_COMMAND} ${common} -B ${FOLDER}/by_package -DCMAKE_PREFIX_PATH=${prefix})
run(${CMAKE_COMMAND} --build ${FOLDER}/by_package)
run(${FOLDER}/by_package/embed)

set(ENV{PKG_CONFIG_PATH} ${prefix}/${LIBDIR}/pkgconfig)
run(${CMAKE_COMMAND} ${common} -B ${FOLDER}/by_pkg_config -DEMBED_PKG_CONFIG=ON)
run(${CMAKE_COMMAND} --build ${FOLDER}/by_pkg_config)
run(${FOLDER}/by_pkg_config/embed)

# Our flags are ours.
file(GLOB texts ${prefix}/${LIBDIR}/cmake/clearcut/*.cmake ${prefix}/${LIBDIR}/pkgconfig/*.pc)
foreach(text ${texts})
  file(READ ${text} content)
  if(content MATCHES "-Werror|-Wall|-ffp-contract|${SOURCE}")
    message(FATAL_ERROR "${text} says ${CMAKE_MATCH_0}, which users need not have")
  endif()
endforeach()
