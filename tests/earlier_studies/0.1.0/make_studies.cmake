# Given to CMake as CMAKE_PROJECT_INCLUDE by `make`: adds make_studies.cpp to the build of a checkout of 0.1.0 without a
# change to its files, which every study would record as a changed program.
if(NOT COMMAND asperity_add_gui_tests)
  # Deferred to the end, where the functions of tests/gui exist; evaluated now, while this file has its name.
  cmake_language(EVAL CODE "cmake_language(DEFER CALL include [[${CMAKE_CURRENT_LIST_FILE}]])")
  return()
endif()

find_package(Qt6 6.4 REQUIRED COMPONENTS Test)
asperity_add_gui_tests(make_studies
  SOURCES
    "${CMAKE_SOURCE_DIR}/tests/gui/sessions/session_room.cpp"
    "${CMAKE_SOURCE_DIR}/tests/gui/study/quiet_home.cpp"
    "${CMAKE_SOURCE_DIR}/tests/journeys/program.cpp"
    "${CMAKE_CURRENT_LIST_DIR}/make_studies.cpp"
  LIBRARIES QCustomPlotQt6::QCustomPlotQt6)
target_compile_definitions(asperity_gui_make_studies_tests PRIVATE
  ASPERITY_PROGRAM="$<TARGET_FILE:asperity>" ASPERITY_STUDIES="${CMAKE_CURRENT_LIST_DIR}")
add_dependencies(asperity_gui_make_studies_tests asperity)
