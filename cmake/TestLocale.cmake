# A German locale for tests, compiled into the build folder: nothing of the system is changed.
#
# asperity_test_locale(<variable>): makes the build compile de_DE.UTF-8, whose decimal point is a comma, and
# sets the variable to the folder that holds it. A test sees it with LOCPATH=<folder> and LC_ALL=de_DE.UTF-8
# in its environment. Needs the sources of locales (Debian's package locales).
function(asperity_test_locale variable)
  set(folder "${CMAKE_BINARY_DIR}/locale")
  if(NOT TARGET asperity_test_locale)
    find_program(ASPERITY_LOCALEDEF localedef REQUIRED)
    add_custom_command(
      OUTPUT "${folder}/de_DE.UTF-8/LC_NUMERIC"
      COMMAND "${CMAKE_COMMAND}" -E make_directory "${folder}"
      COMMAND "${ASPERITY_LOCALEDEF}" -i de_DE -f UTF-8 "${folder}/de_DE.UTF-8"
      COMMENT "Compiling the locale de_DE.UTF-8 for tests"
      VERBATIM)
    add_custom_target(asperity_test_locale ALL DEPENDS "${folder}/de_DE.UTF-8/LC_NUMERIC")
  endif()
  set(${variable} "${folder}" PARENT_SCOPE)
endfunction()
