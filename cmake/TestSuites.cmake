# Registers the suites of one test program with ctest; read by ctest, when it starts, for every program that
# asperity_add_tests has made. Reads of its caller:
#
#   folder    what the names begin with: <folder>.<Suite>
#   program   the program's path
#   launcher  what starts it, in words; may be empty
#   alone     patterns of suites whose tests get a process each: <folder>.<Suite>.<Test>
#   labels, timeout_s, cost, working_directory

if(NOT EXISTS "${program}")
  add_test("${folder}.IsNotBuilt" "${program}")
  return()
endif()

# What the program lists is kept beside it: asking forty programs again takes longer than many a test.
set(list_file "${program}.tests")
if("${program}" IS_NEWER_THAN "${list_file}")
  execute_process(COMMAND ${launcher} "${program}" --gtest_list_tests
    OUTPUT_VARIABLE listing RESULT_VARIABLE result ERROR_VARIABLE complaint TIMEOUT 120)
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "${program} --gtest_list_tests ended with \"${result}\": ${complaint}")
  endif()
  # A parameter behind "#" may hold what a list of CMake cannot.
  string(REGEX REPLACE " +#[^\n]*" "" listing "${listing}")
  file(WRITE "${list_file}" "${listing}")
endif()

# asperity_register(<name> <filter> <tests in it>)
function(asperity_register name filter count)
  add_test("${name}" ${launcher} "${program}" "--gtest_filter=${filter}")
  math(EXPR begins_early "${cost} + ${count}")
  set_tests_properties("${name}" PROPERTIES
    LABELS "${labels}" TIMEOUT ${timeout_s} COST ${begins_early} WORKING_DIRECTORY "${working_directory}")
endfunction()

string(REPLACE ";" "|" alone_pattern "${alone}")
set(alone_pattern "^(${alone_pattern})\\.$")

# Lines without a blank at their beginning are suites ("Suite."), others their tests.
file(STRINGS "${list_file}" lines)
set(suite "")
set(count 0)
foreach(line IN LISTS lines ITEMS "end.")
  if(line MATCHES "^  ([^ ]+)")
    set(test "${CMAKE_MATCH_1}")
    math(EXPR count "${count} + 1")
    if(suite MATCHES "${alone_pattern}")
      asperity_register("${folder}.${suite}${test}" "${suite}${test}" 1)
      # Said by ctest itself; in a suite that has other tests a skipped one is seen in its output only.
      set_tests_properties("${folder}.${suite}${test}" PROPERTIES SKIP_REGULAR_EXPRESSION "\\[  SKIPPED \\]")
    endif()
  elseif(line MATCHES "^[^ ]+\\.$")
    if(count GREATER 0 AND NOT suite MATCHES "${alone_pattern}")
      string(REGEX REPLACE "\\.$" "" name "${folder}.${suite}")
      asperity_register("${name}" "${suite}*" ${count})
    endif()
    set(suite "${line}")  # with its full stop
    set(count 0)
  endif()
endforeach()
