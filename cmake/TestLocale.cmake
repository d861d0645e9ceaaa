# Locales for tests, compiled into the build folder: nothing of the system is changed.
#
# asperity_test_locale(<variable>): makes the build compile de_DE, tr_TR, ar_EG and ja_JP in UTF-8, and sets the variable to
# the folder that holds them. The decimal point is a comma in the first two; in Turkish the capital of i is İ; Arabic has
# digits of its own and is written from right to left; Japanese has other dates. A test sees one with LOCPATH=<folder> and
# LC_ALL=de_DE.UTF-8 in its environment. Needs the sources of locales (Debian's package locales).
function(asperity_test_locale variable)
  set(folder "${CMAKE_BINARY_DIR}/locale")
  if(NOT TARGET asperity_test_locale)
    find_program(ASPERITY_LOCALEDEF localedef REQUIRED)
    set(compiled)
    foreach(locale de_DE tr_TR ar_EG ja_JP)
      add_custom_command(
        OUTPUT "${folder}/${locale}.UTF-8/LC_NUMERIC"
        COMMAND "${CMAKE_COMMAND}" -E make_directory "${folder}"
        COMMAND "${ASPERITY_LOCALEDEF}" -i ${locale} -f UTF-8 "${folder}/${locale}.UTF-8"
        COMMENT "Compiling the locale ${locale}.UTF-8 for tests"
        VERBATIM)
      list(APPEND compiled "${folder}/${locale}.UTF-8/LC_NUMERIC")
    endforeach()
    add_custom_target(asperity_test_locale ALL DEPENDS ${compiled})
  endif()
  set(${variable} "${folder}" PARENT_SCOPE)
endfunction()
