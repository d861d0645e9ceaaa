# What `cmake --install` puts where, and the Debian package of the same. The program carries its schemas,
# library protocols, demonstration stimuli and translations within itself; those that people want to read
# are also installed as files, and its modules in the folder where it looks for them (asperity_add_module).

install(TARGETS asperity RUNTIME DESTINATION "${CMAKE_INSTALL_BINDIR}")
# The man page lists the subcommands that the installed program has.
install(CODE "execute_process(COMMAND \"${CMAKE_COMMAND}\" -D \"PROGRAM=$<TARGET_FILE:asperity>\"
  -D \"TEMPLATE=${CMAKE_SOURCE_DIR}/app/desktop/asperity.1.in\" -D \"OUTPUT=${CMAKE_BINARY_DIR}/asperity.1\"
  -P \"${CMAKE_SOURCE_DIR}/cmake/man_page.cmake\" COMMAND_ERROR_IS_FATAL ANY)")
install(FILES "${CMAKE_BINARY_DIR}/asperity.1.gz" DESTINATION "${CMAKE_INSTALL_MANDIR}/man1")
install(DIRECTORY "${CMAKE_SOURCE_DIR}/docs/" DESTINATION "${CMAKE_INSTALL_DOCDIR}")
install(FILES "${CMAKE_SOURCE_DIR}/app/desktop/copyright" DESTINATION "${CMAKE_INSTALL_DOCDIR}")
install(DIRECTORY "${CMAKE_SOURCE_DIR}/protocols/library/" DESTINATION "${CMAKE_INSTALL_DATADIR}/asperity/protocols"
  FILES_MATCHING PATTERN "*.json")
install(FILES "${CMAKE_BINARY_DIR}/protocol-1.schema.json" DESTINATION "${CMAKE_INSTALL_DATADIR}/asperity")
if(ASPERITY_BUILD_GUI)
  install(FILES "${CMAKE_SOURCE_DIR}/app/desktop/asperity.desktop" DESTINATION "${CMAKE_INSTALL_DATADIR}/applications")
  install(FILES "${CMAKE_SOURCE_DIR}/app/desktop/asperity.svg"
    DESTINATION "${CMAKE_INSTALL_DATADIR}/icons/hicolor/scalable/apps")
endif()

# The interface of plug-ins, the only code that is installed: two headers and a target for find_package(asperity).
install(TARGETS asperity_plugin_interface EXPORT asperityTargets COMPONENT plugin_interface)
install(FILES "${CMAKE_SOURCE_DIR}/renderers/plugin/asperity_plugin.h" "${CMAKE_SOURCE_DIR}/renderers/plugin/asperity_plugin.hpp"
  DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/asperity" COMPONENT plugin_interface)
include(CMakePackageConfigHelpers)
write_basic_package_version_file("${CMAKE_BINARY_DIR}/asperityConfigVersion.cmake"
  COMPATIBILITY SameMinorVersion ARCH_INDEPENDENT)
install(EXPORT asperityTargets FILE asperityConfig.cmake NAMESPACE asperity::
  DESTINATION "${CMAKE_INSTALL_LIBDIR}/cmake/asperity" COMPONENT plugin_interface)
install(FILES "${CMAKE_BINARY_DIR}/asperityConfigVersion.cmake"
  DESTINATION "${CMAKE_INSTALL_LIBDIR}/cmake/asperity" COMPONENT plugin_interface)
install(DIRECTORY "${CMAKE_SOURCE_DIR}/renderers/plugin/example/" DESTINATION "${CMAKE_INSTALL_DOCDIR}/plugin-example"
  COMPONENT plugin_interface)

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME asperity)
set(CPACK_PACKAGE_CONTACT "The Asperity developers <asperity@example.org>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "psychophysics experiments on haptic texture")
set(CPACK_PACKAGE_DESCRIPTION "Asperity runs experiments in which participants feel textured surfaces on a
force-feedback device: paired comparison, rating, matching, recognition,
discrimination and magnitude estimation, written as JSON protocols. Force
models are compared, every trial is stored in SQLite, and responses are
analysed, reported and exported.")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_PRE_BUILD_SCRIPTS "${CMAKE_SOURCE_DIR}/cmake/debian_changelogs.cmake")
set(CPACK_ASPERITY_SOURCE_DIR "${CMAKE_SOURCE_DIR}")
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
# The libraries of one release are not those of the next: a package names the release it was made on, in the manner of
# Debian's own, and that of the later release is the newer version.
cmake_host_system_information(RESULT ASPERITY_SYSTEM QUERY DISTRIB_INFO)
if(ASPERITY_SYSTEM_ID STREQUAL "debian" AND DEFINED ASPERITY_SYSTEM_VERSION_ID)
  set(CPACK_DEBIAN_PACKAGE_RELEASE "1~deb${ASPERITY_SYSTEM_VERSION_ID}u1")
  set(CPACK_ASPERITY_DISTRIBUTION "${ASPERITY_SYSTEM_VERSION_CODENAME}")
endif()
# Legible letters on a machine that has none yet.
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "fonts-dejavu-core")
include(CPack)
