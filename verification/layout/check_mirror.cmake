# cmake -D root=FOLDER -P check_mirror.cmake: verification/ mirrors solver/, so that whoever reads a
# method finds its claims, and whoever reads a claim finds its method, by the name of the file.
cmake_minimum_required(VERSION 3.25)

# "file: why nothing in it can be wrong by itself, or which file shows that it is right".
set(solver_files_without_claims
    "foundation/types.h: names for types"
    "foundation/errors.h: one exception type, whose messages verification/reports/bad_input_test.cpp reads"
    "approximation/samples.h: a view without code"
    "fluid/pair_gradients.h: memory of dfsph.h, whose claims read it"
    "fluid/pair_records.h: memory of weakly_compressible_rates.h, whose claims read it"
    "fluid/pressure_projection.h: the solve of dfsph.h, whose claims and tests run it"
    "approximation/shape_row.h: views without code"
    "particles/quantities.h: names for arrays"
    "scene/composed.h: a scene behind simulation.h, which checkpoint.cpp and guarded_run_test.cpp step"
    "scene/delta_sph_simulation.h: a list of passes, stepped by checkpoint.cpp"
    "scene/dfsph_simulation.h: a list of passes, stepped by checkpoint.cpp"
    "scene/grid_passes.h: passes of find_neighbours.h, compiled once"
    "scene/simulation.h: an interface"
    "scene/sph_simulation.h: a list of passes, stepped by checkpoint.cpp"
    "scene/terms.h: the choices of scene_file.h as passes"
    "scene/toml_section.h: the messages that scene_file_test.cpp reads")
# "file: why no single file of the solver stands behind it".
set(verification_files_without_method
    "approximation/convergence_studies.cpp: compares all methods"
    "approximation/lattice_floor.cpp: sph_interpolation.h between the points of a lattice, by Poisson's sum"
    "approximation/mls_derivatives.cpp: mls_shape.h, Eqs. 30-34, which one file cannot hold"
    "approximation/mls_stability.cpp: mls_shape.h, Sec. 3.3, which one file cannot hold"
    "kernels/kernel_claims.cpp: what every kernel has to fulfil, called by the file of each"
    "fluid/lattice_instabilities.cpp: pressure_force.h with every kernel, by theory alone"
    "fluid/stability_limits.cpp: compares forces and integrators with the theory of the lattice")

function(check_exceptions folder entries)
    foreach(entry ${${entries}})
        string(REGEX REPLACE ": .*" "" file "${entry}")
        if(NOT EXISTS ${root}/${folder}/${file})
            message(SEND_ERROR "${folder}/${file} is an exception in check_mirror.cmake, but does not exist")
        endif()
    endforeach()
endfunction()
if(NOT without_exceptions)
    check_exceptions(solver solver_files_without_claims)
    check_exceptions(verification verification_files_without_method)
endif()

foreach(layer foundation particles neighbours kernels approximation fluid elasticity lattice surface
        shape motion scene io)
    file(GLOB_RECURSE headers RELATIVE ${root}/solver ${root}/solver/${layer}/*.h)
    foreach(header ${headers})
        string(REGEX REPLACE "\\.h$" "" stem ${header})
        if(NOT EXISTS ${root}/verification/${stem}.cpp AND NOT EXISTS ${root}/verification/${stem}_test.cpp
           AND NOT "${solver_files_without_claims}" MATCHES "(^|;)${header}: ")
            message(SEND_ERROR "solver/${header} has neither verification/${stem}.cpp nor ${stem}_test.cpp")
        endif()
    endforeach()
    file(GLOB_RECURSE claims RELATIVE ${root}/verification ${root}/verification/${layer}/*.cpp)
    foreach(claim ${claims})
        string(REGEX REPLACE "(_test)?\\.cpp$" "" stem ${claim})
        if(NOT EXISTS ${root}/solver/${stem}.h
           AND NOT "${verification_files_without_method}" MATCHES "(^|;)${claim}: ")
            message(SEND_ERROR "verification/${claim} verifies nothing: there is no solver/${stem}.h")
        endif()
    endforeach()
endforeach()
