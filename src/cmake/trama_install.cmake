# What `cmake --install` puts where: headers, library, tool, CMake package, pkg-config file.
include(CMakePackageConfigHelpers)

set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/trama)
set(pc_dir ${CMAKE_INSTALL_LIBDIR}/pkgconfig)

install(TARGETS trama EXPORT trama_targets
        LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}
        ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
        RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR}
        INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(DIRECTORY ${PROJECT_SOURCE_DIR}/include/trama DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}
        FILES_MATCHING PATTERN "*.hpp")

if(TRAMA_BUILD_TOOL)
    # The tool of a shared build finds its library beside it, wherever the prefix is moved.
    file(RELATIVE_PATH from_bin ${CMAKE_INSTALL_FULL_BINDIR} ${CMAKE_INSTALL_FULL_LIBDIR})
    set_target_properties(trama_tool PROPERTIES INSTALL_RPATH "\$ORIGIN/${from_bin}")
    install(TARGETS trama_tool RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
endif()

install(EXPORT trama_targets NAMESPACE trama:: DESTINATION ${package_dir} FILE trama-targets.cmake)
configure_package_config_file(
    ${CMAKE_CURRENT_LIST_DIR}/trama-config.cmake.in ${PROJECT_BINARY_DIR}/trama-config.cmake
    INSTALL_DESTINATION ${package_dir})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/trama-config-version.cmake
    COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/trama-config.cmake ${PROJECT_BINARY_DIR}/trama-config-version.cmake
        DESTINATION ${package_dir})

# Relative to the .pc file, so that an installed copy can be moved as a whole.
file(RELATIVE_PATH prefix_from_pc ${CMAKE_INSTALL_PREFIX}/${pc_dir} ${CMAKE_INSTALL_PREFIX})
string(REGEX REPLACE "/$" "" prefix_from_pc "${prefix_from_pc}")
# But for /usr: only when spelled so does pkg-config leave out the system's own folder, which -isystem would spoil.
if(IS_ABSOLUTE "${CMAKE_INSTALL_LIBDIR}" OR IS_ABSOLUTE "${CMAKE_INSTALL_INCLUDEDIR}" OR CMAKE_INSTALL_PREFIX STREQUAL "/usr")
    set(pc_prefix ${CMAKE_INSTALL_PREFIX})
    set(pc_libdir ${CMAKE_INSTALL_FULL_LIBDIR})
    set(pc_includedir ${CMAKE_INSTALL_FULL_INCLUDEDIR})
else()
    set(pc_prefix "\${pcfiledir}/${prefix_from_pc}")
    set(pc_libdir "\${prefix}/${CMAKE_INSTALL_LIBDIR}")
    set(pc_includedir "\${prefix}/${CMAKE_INSTALL_INCLUDEDIR}")
endif()
configure_file(${CMAKE_CURRENT_LIST_DIR}/trama.pc.in ${PROJECT_BINARY_DIR}/trama.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/trama.pc DESTINATION ${pc_dir})
