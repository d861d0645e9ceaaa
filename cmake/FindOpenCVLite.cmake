# Finds the OpenCV modules that are asked for, by header and library.
# Debian ships OpenCV's own CMake configuration only with the package that pulls in all of OpenCV (673 MB);
# the three modules used here come in small packages without it.
include(FindPackageHandleStandardArgs)

find_path(OpenCVLite_INCLUDE_DIR opencv2/core.hpp PATH_SUFFIXES opencv4)
if(OpenCVLite_INCLUDE_DIR)
  file(STRINGS "${OpenCVLite_INCLUDE_DIR}/opencv2/core/version.hpp" version_lines
    REGEX "^#define CV_VERSION_(MAJOR|MINOR|REVISION) +[0-9]+")
  string(REGEX REPLACE ".*MAJOR +([0-9]+).*MINOR +([0-9]+).*REVISION +([0-9]+).*" "\\1.\\2.\\3"
    OpenCVLite_VERSION "${version_lines}")
endif()

set(required_variables OpenCVLite_INCLUDE_DIR)
foreach(module IN LISTS OpenCVLite_FIND_COMPONENTS)
  find_library(OpenCVLite_${module}_LIBRARY opencv_${module})
  list(APPEND required_variables OpenCVLite_${module}_LIBRARY)
  if(OpenCVLite_${module}_LIBRARY AND NOT TARGET OpenCVLite::${module})
    add_library(OpenCVLite::${module} UNKNOWN IMPORTED)
    set_target_properties(OpenCVLite::${module} PROPERTIES
      IMPORTED_LOCATION "${OpenCVLite_${module}_LIBRARY}"
      INTERFACE_INCLUDE_DIRECTORIES "${OpenCVLite_INCLUDE_DIR}")
  endif()
endforeach()

find_package_handle_standard_args(OpenCVLite
  REQUIRED_VARS ${required_variables} VERSION_VAR OpenCVLite_VERSION)
