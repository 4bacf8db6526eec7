# Each header compiles alone. The build shows it for a header that its own .cpp, or the file in
# verification/ that mirrors it, includes first; the others get a translation unit of their own, in a
# target that only this test builds.
file(GLOB_RECURSE headers CONFIGURE_DEPENDS RELATIVE ${PROJECT_SOURCE_DIR}
     ${PROJECT_SOURCE_DIR}/solver/*.h ${PROJECT_SOURCE_DIR}/verification/*.h
     ${PROJECT_SOURCE_DIR}/benchmarks/*.h ${PROJECT_SOURCE_DIR}/reports/*.h)
set(units "")
foreach(header ${headers})
    string(REGEX REPLACE "\\.h$" "" own ${header})
    string(REGEX REPLACE "^solver/" "verification/" mirror ${own})
    set(included_first NO)
    foreach(file ${own}.cpp ${mirror}.cpp ${mirror}_test.cpp)
        if(EXISTS ${PROJECT_SOURCE_DIR}/${file})
            file(STRINGS ${PROJECT_SOURCE_DIR}/${file} includes REGEX "^#include")
            list(GET includes 0 first)
            if(first STREQUAL "#include \"${header}\"")
                set(included_first YES)
            endif()
        endif()
    endforeach()
    if(NOT included_first)
        set(unit ${PROJECT_BINARY_DIR}/headers/${header}.cpp)
        file(CONFIGURE OUTPUT ${unit} CONTENT "#include \"@header@\"\n" @ONLY)
        list(APPEND units ${unit})
    endif()
endforeach()
add_library(plumbline_headers OBJECT EXCLUDE_FROM_ALL ${units})
target_compile_options(plumbline_headers PRIVATE -O0)

set(unit ${PROJECT_BINARY_DIR}/headers/needs_another.cpp)
file(CONFIGURE OUTPUT ${unit} CONTENT "inline std::string text();\n")
add_library(plumbline_header_that_needs_another OBJECT EXCLUDE_FROM_ALL ${unit})

foreach(target plumbline_headers plumbline_header_that_needs_another)
    target_link_libraries(${target} PRIVATE plumbline_reports plumbline_options)
    set(build_${target} ${CMAKE_COMMAND} --build ${PROJECT_BINARY_DIR} --target ${target})
endforeach()
add_test(NAME layout.headers_compile_alone COMMAND ${build_plumbline_headers})
add_test(NAME layout.headers_compile_alone_can_fail
         COMMAND ${build_plumbline_header_that_needs_another})
set_tests_properties(layout.headers_compile_alone_can_fail PROPERTIES
                     PASS_REGULAR_EXPRESSION "does not name a type|undeclared identifier")
# One build at a time in one folder.
set_tests_properties(layout.headers_compile_alone layout.headers_compile_alone_can_fail PROPERTIES
                     RESOURCE_LOCK build_folder)
