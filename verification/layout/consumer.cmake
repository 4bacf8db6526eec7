# find_package(plumbline) works for a program outside the tree, from a fresh prefix.
set(prefix ${CMAKE_CURRENT_BINARY_DIR}/installed)
set(consumer ${CMAKE_CURRENT_BINARY_DIR}/consumer)
add_test(NAME consumer.clean COMMAND ${CMAKE_COMMAND} -E rm -rf ${prefix} ${consumer})
add_test(NAME consumer.install COMMAND ${CMAKE_COMMAND} --install ${PROJECT_BINARY_DIR}
         --prefix ${prefix} --component solver)
add_test(NAME consumer.computes_a_density COMMAND ${CMAKE_CTEST_COMMAND}
         --build-and-test ${PROJECT_SOURCE_DIR}/verification/consumer ${consumer}
         --build-generator ${CMAKE_GENERATOR}
         --build-options -DCMAKE_PREFIX_PATH=${prefix} -DCMAKE_CXX_COMPILER=${CMAKE_CXX_COMPILER}
                         -DCMAKE_CXX_FLAGS=${CMAKE_CXX_FLAGS}
         --test-command density)
set_tests_properties(consumer.clean PROPERTIES FIXTURES_SETUP empty_prefix)
set_tests_properties(consumer.install PROPERTIES FIXTURES_SETUP prefix FIXTURES_REQUIRED empty_prefix)
set_tests_properties(consumer.computes_a_density PROPERTIES FIXTURES_REQUIRED prefix)
