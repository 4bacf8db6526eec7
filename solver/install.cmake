# `cmake --install` gives find_package(plumbline) with plumbline::solver; the program goes along.
include(CMakePackageConfigHelpers)
include(GNUInstallDirs)
set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/plumbline)

install(TARGETS plumbline_solver EXPORT plumbline COMPONENT solver)
install(DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR} ${PROJECT_BINARY_DIR}/generated/solver
        DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/plumbline COMPONENT solver
        FILES_MATCHING PATTERN "*.h")
install(EXPORT plumbline NAMESPACE plumbline:: FILE plumbline-targets.cmake
        DESTINATION ${package_folder} COMPONENT solver)

configure_package_config_file(plumbline-config.cmake.in ${PROJECT_BINARY_DIR}/plumbline-config.cmake
                              INSTALL_DESTINATION ${package_folder})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/plumbline-config-version.cmake
                                 COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/plumbline-config.cmake
              ${PROJECT_BINARY_DIR}/plumbline-config-version.cmake
        DESTINATION ${package_folder} COMPONENT solver)
