# cmake -D scratch=FOLDER -P checks_can_fail.cmake: each check of the layout, on a tree of one file
# that is wrong on purpose, must fail and name the fault; on a sound tree it must pass.
cmake_minimum_required(VERSION 3.25)

function(run_check check)
    execute_process(COMMAND ${CMAKE_COMMAND} -D root=${scratch} -D without_exceptions=ON
                            -P ${CMAKE_CURRENT_LIST_DIR}/check_${check}.cmake
                    RESULT_VARIABLE status ERROR_VARIABLE messages)
    string(REGEX REPLACE "[ \n]+" " " messages "${messages}")
    set(status ${status} PARENT_SCOPE)
    set(messages ${messages} PARENT_SCOPE)
endfunction()

function(caught check file content expected)
    file(REMOVE_RECURSE ${scratch})
    file(WRITE ${scratch}/${file} "${content}")
    run_check(${check})
    string(FIND "${messages}" "${expected}" at)
    if(status EQUAL 0 OR at EQUAL -1)
        message(SEND_ERROR "check_${check} on a wrong ${file}: expected \"${expected}\", found \"${messages}\"")
    endif()
endfunction()

function(passed check)
    file(REMOVE_RECURSE ${scratch})
    file(WRITE ${scratch}/solver/kernels/k.h "#pragma once\n#include \"solver/foundation/types.h\"\n")
    file(WRITE ${scratch}/verification/kernels/k.cpp "#include \"solver/kernels/k.h\"\n")
    run_check(${check})
    if(NOT status EQUAL 0)
        message(SEND_ERROR "check_${check} on a sound tree: ${messages}")
    endif()
endfunction()

passed(layers)
caught(layers solver/kernels/k.h "#include \"solver/approximation/a.h\"" "is not below solver/kernels/")
caught(layers solver/kernels/k.h "#include \"solver/neighbours/n.h\"" "is not below solver/kernels/")
caught(layers solver/kernels/k.h "#include \"verification/v.h\"" "stands above solver/")
caught(layers verification/v.cpp "#include \"benchmarks/b.h\"" "stands above verification/")
caught(layers benchmarks/b.cpp "#include \"reports/r.h\"" "stands above benchmarks/")
caught(layers solver/kernels/k.h "#include \"k.h\"" "expected a path from the root of the tree")
caught(layers solver/approximation/a.h "#include <gsl/gsl_math.h>" "no GPL library in its headers")
caught(layers solver/particles/p.h "#include <CGAL/Kernel.h>" "no GPL library in its headers")
caught(layers solver/kernels/k.h "#include <omp.h>" "only solver/foundation/parallel.h does")
caught(layers solver/magic/m.h "#include \"solver/foundation/types.h\"" "solver/magic has no rank")

passed(mirror)
caught(mirror solver/kernels/k.h "" "solver/kernels/k.h has neither verification/kernels/k.cpp nor")
caught(mirror verification/kernels/k.cpp "" "there is no solver/kernels/k.h")

passed(files)
caught(files solver/kernels/k.h "" "does not begin with #pragma once")
caught(files README.md "see /${empty}home/somebody" "README.md names /${empty}home/somebody")
string(REPEAT "\n" 401 long)
caught(files reports/r.cpp "${long}" "reports/r.cpp has 401 lines")

file(REMOVE_RECURSE ${scratch})
