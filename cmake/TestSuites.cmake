# Registers the suites of one test program with ctest; read by ctest, when it starts, for every program that
# asperity_add_tests has made. Reads of its caller:
#
#   folder    what the names begin with: <folder>.<Suite>
#   program   the program's path
#   launcher  what starts it, in words; may be empty
#   alone     patterns of suites whose tests get a process each: <folder>.<Suite>.<Test>
#   first     patterns of suites that take longest, with which ctest begins
#   labels, timeout_s (of one test), cost, working_directory

if(NOT EXISTS "${program}")
  add_test("${folder}.IsNotBuilt" "${program}")
  set_tests_properties("${folder}.IsNotBuilt" PROPERTIES LABELS "${labels}")
  return()
endif()

# The list of a program's tests is stored next to it: starting every program again takes longer than many tests.
set(list_file "${program}.tests")
if("${program}" IS_NEWER_THAN "${list_file}")
  execute_process(COMMAND ${launcher} "${program}" --gtest_list_tests
    OUTPUT_VARIABLE listing RESULT_VARIABLE result ERROR_VARIABLE complaint TIMEOUT 120)
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "${program} --gtest_list_tests ended with \"${result}\": ${complaint}")
  elseif(NOT listing MATCHES "\n  ")
    message(FATAL_ERROR "${program} holds no test.")
  endif()
  # A parameter behind "#" may hold what a list of CMake cannot.
  string(REGEX REPLACE " +#[^\n]*" "" listing "${listing}")
  # Renamed in one piece: another ctest may read it now.
  string(RANDOM LENGTH 8 unique)
  file(WRITE "${list_file}.${unique}" "${listing}")
  file(RENAME "${list_file}.${unique}" "${list_file}")
endif()

# asperity_register(<name> <filter> <tests in it>): a test that hangs ends its suite, and what GoogleTest has reported by then
# is in the output; so a suite has the time of one test and a little for each other.
function(asperity_register name filter count)
  add_test("${name}" ${launcher} "${program}" "--gtest_filter=${filter}")
  math(EXPR begins_early "${cost} + ${count}")
  if(suite MATCHES "${first_pattern}")
    math(EXPR begins_early "${begins_early} + 1000")
  endif()
  math(EXPR longest_s "${timeout_s} + 3 * (${count} - 1)")
  set_tests_properties("${name}" PROPERTIES
    LABELS "${labels}" TIMEOUT ${longest_s} COST ${begins_early} WORKING_DIRECTORY "${working_directory}")
endfunction()

foreach(kind IN ITEMS alone first)
  string(REPLACE ";" "|" ${kind}_pattern "${${kind}}")
  set(${kind}_pattern "^(${${kind}_pattern})\\.$")
endforeach()

# Lines without a blank at their beginning are suites ("Suite."), others their tests.
file(STRINGS "${list_file}" lines)
set(suite "")
set(count 0)
set(suites "")
foreach(line IN LISTS lines ITEMS "end.")
  if(line MATCHES "^  ([^ ]+)")
    set(test "${CMAKE_MATCH_1}")
    math(EXPR count "${count} + 1")
    if(suite MATCHES "${alone_pattern}")
      asperity_register("${folder}.${suite}${test}" "${suite}${test}" 1)
      # Reported by ctest itself; in a suite that has other tests only its output names a skipped one.
      set_tests_properties("${folder}.${suite}${test}" PROPERTIES SKIP_REGULAR_EXPRESSION "\\[  SKIPPED \\]")
    endif()
  elseif(line MATCHES "^[^ ]+\\.$")
    if(count GREATER 0 AND NOT suite MATCHES "${alone_pattern}")
      string(REGEX REPLACE "\\.$" "" name "${folder}.${suite}")
      asperity_register("${name}" "${suite}*" ${count})
    endif()
    set(suite "${line}")  # with its full stop
    set(count 0)
    list(APPEND suites "${suite}")
  endif()
endforeach()
foreach(pattern IN LISTS alone first)
  if(NOT "${suites}" MATCHES "(^|;)${pattern}\\.(;|$)")
    message(FATAL_ERROR "No suite of ${program} matches ${pattern}, which its CMakeLists.txt names under ALONE or FIRST.")
  endif()
endforeach()
