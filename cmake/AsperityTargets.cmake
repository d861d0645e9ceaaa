# What every target of the tree has in common, as functions on targets: nothing is set globally but the compiler launcher.

if(ASPERITY_USE_CCACHE)
  set(CMAKE_CXX_COMPILER_LAUNCHER "${CMAKE_SOURCE_DIR}/cmake/compile_through_ccache")
endif()

include(GNUInstallDirs)
# Below a folder of the package's own: in lib/asperity CPack would take a module for a library that the linker must know.
set(ASPERITY_MODULE_FOLDER "${CMAKE_INSTALL_LIBDIR}/asperity/modules")

# mold links everything in a twentieth of the time of Debian's usual linker. The sanitizers want the usual one.
include(CheckLinkerFlag)
set(ASPERITY_LINKER "")
if(NOT "${CMAKE_CXX_FLAGS} ${CMAKE_CXX_FLAGS_DEBUG}" MATCHES "-fsanitize=")
  check_linker_flag(CXX -fuse-ld=mold ASPERITY_HAS_MOLD)
  if(ASPERITY_HAS_MOLD)
    set(ASPERITY_LINKER -fuse-ld=mold)
  endif()
endif()

add_custom_target(asperity_modules)

# asperity_current_folder(VARIABLE): the folder that is being configured, relative to the source tree.
function(asperity_current_folder variable)
  cmake_path(RELATIVE_PATH CMAKE_CURRENT_SOURCE_DIR BASE_DIRECTORY "${CMAKE_SOURCE_DIR}" OUTPUT_VARIABLE folder)
  set(${variable} "${folder}" PARENT_SCOPE)
endfunction()

# Language, warnings, floating-point rules and linking.
function(asperity_configure target)
  set_target_properties(${target} PROPERTIES CXX_STANDARD 20 CXX_STANDARD_REQUIRED ON CXX_EXTENSIONS OFF)
  target_compile_options(${target} PRIVATE
    -Wall -Wextra -Wpedantic -Wconversion -Wshadow
    # A formula has to mean the same arithmetic on every target.
    -ffp-contract=off)
  # What runs in a tick lies in these folders (but for the force of a device test, a few operations).
  asperity_current_folder(folder)
  if(NOT folder MATCHES "^(analysis|stimuli|device|renderers|bench)(/|$)")
    asperity_optimise_lightly(${target})
  endif()
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
    target_compile_options(${target} PRIVATE
      -Wno-restrict  # false alarms
      # Wrong code at -O2: of (double)(float)x on two neighbouring values the rounding is dropped. What
      # is recorded and what is replayed would differ (tests/app/recording_columns_test.cpp).
      -fno-tree-slp-vectorize)
  endif()
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    # A tenth of a build's time: the compiler tidies its own memory, over and over, from 128 MiB on.
    target_compile_options(${target} PRIVATE "SHELL:--param ggc-min-heapsize=1000000" "SHELL:--param ggc-min-expand=200")
  endif()
  if(ASPERITY_WARNINGS_AS_ERRORS)
    target_compile_options(${target} PRIVATE -Werror)
  endif()
  get_target_property(type ${target} TYPE)
  if(type STREQUAL EXECUTABLE)
    set_target_properties(${target} PROPERTIES
      BUILD_RPATH "$ORIGIN/../lib" INSTALL_RPATH "$ORIGIN/../${ASPERITY_MODULE_FOLDER}")
    # Behind the programs' own sources: they need modules only when they run.
    add_dependencies(${target} asperity_modules)
  endif()
  # A program loads only what it calls.
  target_link_options(${target} PRIVATE LINKER:--as-needed ${ASPERITY_LINKER})
endfunction()

# asperity_add_sources(<target> [<file>…] [GROUP <file>…]…): the sources of a target. Those of a group are compiled at a time,
# so that what is costly in the headers of others is paid for once a group; for the compiler they are one file, in which a name
# that two sources keep to themselves is an error. Sources before the first group are compiled alone.
function(asperity_add_sources target)
  set(largest 12)
  asperity_current_folder(folder)
  if(folder MATCHES "^tests")
    set(largest 24)  # not optimised, so that more of them fit into the memory and the time of a step
  endif()
  set(group 0)
  foreach(file IN LISTS ARGN)
    if(file STREQUAL "GROUP")
      math(EXPR group "${group} + 1")
      set(members 0)
      continue()
    endif()
    cmake_path(ABSOLUTE_PATH file BASE_DIRECTORY "${CMAKE_CURRENT_SOURCE_DIR}" NORMALIZE)
    target_sources(${target} PRIVATE "${file}")
    if(group GREATER 0 AND file MATCHES "\\.cpp$")
      math(EXPR members "${members} + 1")
      if(members GREATER largest)
        message(FATAL_ERROR "Group ${group} of ${target} in ${folder} has more than ${largest} sources: begin another with GROUP.")
      endif()
      string(MAKE_C_IDENTIFIER "${folder}_${group}" name)
      # A property of the source in its folder, whatever its target.
      get_source_file_property(known "${file}" TARGET_DIRECTORY ${target} UNITY_GROUP)
      if(known AND NOT known STREQUAL name)
        message(FATAL_ERROR "${file} is in group ${known} of another target and in ${name} of ${target}: use the same number.")
      endif()
      set_source_files_properties("${file}" TARGET_DIRECTORY ${target} PROPERTIES UNITY_GROUP ${name})
    endif()
  endforeach()
  if(group GREATER 0 AND ASPERITY_COMPILE_IN_GROUPS)
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
    # A class that a source defines from its header's name may hold what the source keeps to itself; a group
    # looks to gcc like a header that does so.
    target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage>)
  endif()
endfunction()

# asperity_add_library(<folder> SOURCES <file>… [GROUP <file>…]…): the one library of a folder, asperity_<folder>.
function(asperity_add_library folder)
  cmake_parse_arguments(ARG "" "" "SOURCES" ${ARGN})
  add_library(asperity_${folder} STATIC)
  asperity_add_sources(asperity_${folder} ${ARG_SOURCES})
  target_include_directories(asperity_${folder} PUBLIC "${CMAKE_SOURCE_DIR}")
  asperity_configure(asperity_${folder})
endfunction()

# asperity_add_component(<component> LIBRARIES <target>… SOURCES <file>… [GROUP <file>…]…): a folder of app/ as the library asperity_<component>.
# The headers that nearly all of its sources include and that are not part of this tree are compiled once, with the first.
function(asperity_add_component component)
  cmake_parse_arguments(ARG "" "" "SOURCES;LIBRARIES" ${ARGN})
  asperity_add_library(${component} SOURCES ${ARG_SOURCES})
  target_link_libraries(asperity_${component} PUBLIC ${ARG_LIBRARIES} PRIVATE nlohmann_json::nlohmann_json)
  if(component STREQUAL "words")
    target_precompile_headers(asperity_words PRIVATE
      <nlohmann/json.hpp> <glm/gtc/quaternion.hpp>
      <algorithm> <filesystem> <functional> <map> <optional> <set> <span> <stop_token> <string> <vector>)
  else()
    target_precompile_headers(asperity_${component} REUSE_FROM asperity_words)
  endif()
endfunction()

# asperity_add_module(<name> SOURCES <file>… LIBRARIES <target>…): <name>.so, which a program loads when it first needs it.
# Programs look for their modules in ../lib of a build folder, in the package's own folder once installed.
function(asperity_add_module name)
  cmake_parse_arguments(ARG "" "" "SOURCES;LIBRARIES" ${ARGN})
  add_library(${name} MODULE ${ARG_SOURCES})
  set_target_properties(${name} PROPERTIES PREFIX "" LIBRARY_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/lib")
  target_include_directories(${name} PRIVATE "${CMAKE_SOURCE_DIR}")
  target_link_libraries(${name} PRIVATE ${ARG_LIBRARIES})
  asperity_configure(${name})
  add_dependencies(asperity_modules ${name})
  install(TARGETS ${name} LIBRARY DESTINATION "${ASPERITY_MODULE_FOLDER}")
endfunction()

# asperity_optimise_lightly(<target>): for what waits for people and files. It compiles in three quarters of the time.
function(asperity_optimise_lightly target)
  target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O1>)
endfunction()

# asperity_share_headers(<name> HEADERS <header>… LIBRARIES <target>…): headers that test programs include again and
# again, compiled once for all that name them (asperity_add_tests(… HEADERS <name>)). A compiler takes them only if
# every macro of <name>'s command line is the same on its own, so <name> defines nothing but what its libraries do.
function(asperity_share_headers name)
  cmake_parse_arguments(ARG "" "" "HEADERS;LIBRARIES" ${ARGN})
  set(source "${CMAKE_CURRENT_BINARY_DIR}/${name}.cpp")
  file(CONFIGURE OUTPUT "${source}" CONTENT "// Nothing: CMake wants a source beside the headers.\n")
  add_library(${name} STATIC "${source}")
  asperity_configure(${name})
  asperity_compile_as_test(${name})
  target_link_libraries(${name} PRIVATE ${ARG_LIBRARIES})
  target_precompile_headers(${name} PRIVATE ${ARG_HEADERS})
endfunction()

# asperity_compile_as_test(<target>): a test's own code runs for moments; optimising it would take longer than it saves.
function(asperity_compile_as_test target)
  target_compile_options(${target} PRIVATE -O0)
endfunction()

# asperity_add_tests(<folder> SOURCES <file>… [GROUP <file>…]… LIBRARIES <target>… [LABELS <label>…] [LAUNCHER <word>…]
#   [HEADERS <name>] [COST <number>] [ALONE <pattern>…] [FIRST <pattern>…])
# The program asperity_<folder>_tests. To ctest each of its suites is a test, <folder>.<Suite>, run in one process: most of
# the processor time of short tests is spent on starting programs. Suites that change their process (its limits,
# signals, locale, current folder) or need one that nothing was done in match a pattern of ALONE: each of their tests is a
# test of ctest, <folder>.<Suite>.<Test>, and a process.
# Tests are discovered when ctest runs (TestSuites.cmake), so that building never runs a test program. The label "slow"
# leaves a program to scripts/test slow, "long" to scripts/test-long, which runs those that are also labelled fuzz,
# monte-carlo, realtime or window; these programs are built on request (targets slow_tests and long_tests).
# COST, about the seconds of its longest tests, has ctest begin with them, and FIRST names suites that come before all others:
# a test run ends with many short ones.
function(asperity_add_tests folder)
  cmake_parse_arguments(ARG "" "HEADERS;COST" "SOURCES;LIBRARIES;LABELS;LAUNCHER;ALONE;FIRST" ${ARGN})
  if(NOT ARG_HEADERS)
    set(ARG_HEADERS asperity_test_headers)
  endif()
  if(NOT ARG_COST)
    set(ARG_COST 0)
  endif()
  set(program asperity_${folder}_tests)
  add_executable(${program})
  asperity_add_sources(${program} ${ARG_SOURCES})
  asperity_configure(${program})
  target_include_directories(${program} PRIVATE "${CMAKE_SOURCE_DIR}")
  target_link_libraries(${program} PRIVATE ${ARG_LIBRARIES} GTest::gmock GTest::gtest_main)
  target_precompile_headers(${program} REUSE_FROM ${ARG_HEADERS})
  asperity_compile_as_test(${program})
  target_compile_definitions(${program} PRIVATE ASPERITY_SOURCE_DIR="${CMAKE_SOURCE_DIR}")
  # What scripts/test builds: everyday, slow, and of each the programs of a folder of tests/ and below it.
  asperity_current_folder(top)
  string(REGEX REPLACE "^tests/([^/]+).*" "\\1" top "${top}")
  set(kind everyday)
  foreach(label IN ITEMS slow long)
    if(label IN_LIST ARG_LABELS)
      set(kind ${label})
      set_target_properties(${program} PROPERTIES EXCLUDE_FROM_ALL ON)
    endif()
  endforeach()
  if(NOT TARGET ${kind}_tests)
    add_custom_target(${kind}_tests)
  endif()
  add_dependencies(${kind}_tests ${program})
  add_dependencies(${kind}_tests_of_${top} ${program})
  # Only what hangs takes so long, also next to other work; a wait that fails ends after the patience of tests/support.
  set(timeout_s 600)
  if("long" IN_LIST ARG_LABELS)
    set(timeout_s 3600)
  elseif("slow" IN_LIST ARG_LABELS OR CMAKE_CXX_FLAGS_DEBUG MATCHES "-fsanitize=")
    set(timeout_s 1800)  # computes for minutes, or is slowed down by the sanitizers
  endif()
  set(suites_file "${CMAKE_CURRENT_BINARY_DIR}/${program}_suites.cmake")
  file(CONFIGURE OUTPUT "${suites_file}" @ONLY CONTENT [[
set(folder "@folder@")
set(program "@CMAKE_RUNTIME_OUTPUT_DIRECTORY@/@program@")
set(launcher "@ARG_LAUNCHER@")
set(alone "@ARG_ALONE@")
set(first "@ARG_FIRST@")
set(labels "@top@;@ARG_LABELS@")
set(timeout_s @timeout_s@)
set(cost @ARG_COST@)
set(working_directory "@CMAKE_CURRENT_BINARY_DIR@")
include("@CMAKE_SOURCE_DIR@/cmake/TestSuites.cmake")
]])
  set_property(DIRECTORY APPEND PROPERTY TEST_INCLUDE_FILES "${suites_file}")
endfunction()
