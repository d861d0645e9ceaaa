# Finds hidapi with its backend on libusb, for which Debian ships no CMake configuration. Target: Hidapi::libusb.
include(FindPackageHandleStandardArgs)
find_path(Hidapi_INCLUDE_DIR hidapi.h PATH_SUFFIXES hidapi)
find_library(Hidapi_LIBRARY hidapi-libusb)
find_package_handle_standard_args(Hidapi REQUIRED_VARS Hidapi_LIBRARY Hidapi_INCLUDE_DIR)
if(Hidapi_FOUND AND NOT TARGET Hidapi::libusb)
  add_library(Hidapi::libusb UNKNOWN IMPORTED)
  set_target_properties(Hidapi::libusb PROPERTIES
    IMPORTED_LOCATION "${Hidapi_LIBRARY}" INTERFACE_INCLUDE_DIRECTORIES "${Hidapi_INCLUDE_DIR}")
endif()
