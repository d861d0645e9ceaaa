# Adds the two changelogs that Debian requires to the files of the package: that of the program (CHANGELOG.md) and that of
# the package, dated by the last commit. Run by CPack before it packs; its variables are those of CPackConfig.cmake.
set(folder "${CPACK_TEMPORARY_DIRECTORY}${CPACK_PACKAGING_INSTALL_PREFIX}/share/doc/${CPACK_PACKAGE_NAME}")
set(distribution "unstable")
if(CPACK_ASPERITY_DISTRIBUTION)
  set(distribution "${CPACK_ASPERITY_DISTRIBUTION}")
endif()
set(version "${CPACK_PACKAGE_VERSION}")
if(CPACK_DEBIAN_PACKAGE_RELEASE)
  string(APPEND version "-${CPACK_DEBIAN_PACKAGE_RELEASE}")
endif()
if(NOT DEFINED ENV{SOURCE_DATE_EPOCH})
  execute_process(COMMAND git -C "${CPACK_ASPERITY_SOURCE_DIR}" log -1 --format=%ct
    OUTPUT_VARIABLE seconds OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET RESULT_VARIABLE failed)
  if(failed EQUAL 0)
    set(ENV{SOURCE_DATE_EPOCH} "${seconds}")  # the time of string(TIMESTAMP)
  endif()
endif()
string(TIMESTAMP date "%a, %d %b %Y %H:%M:%S +0000" UTC)
file(WRITE "${folder}/changelog.Debian" "${CPACK_PACKAGE_NAME} (${version}) ${distribution}; urgency=medium

  * Version ${CPACK_PACKAGE_VERSION}; changelog.gz lists its changes.

 -- ${CPACK_PACKAGE_CONTACT}  ${date}
")
configure_file("${CPACK_ASPERITY_SOURCE_DIR}/CHANGELOG.md" "${folder}/changelog" COPYONLY)
execute_process(COMMAND gzip -9 --no-name --force "${folder}/changelog.Debian" "${folder}/changelog"
  COMMAND_ERROR_IS_FATAL ANY)
# Whatever the permissions of the checkout and the user's mask are.
file(CHMOD "${folder}/changelog.Debian.gz" "${folder}/changelog.gz"
  PERMISSIONS OWNER_READ OWNER_WRITE GROUP_READ WORLD_READ)
