# Finds libusb 1.0, for which Debian ships no CMake configuration. Target: LibUSB::LibUSB.
include(FindPackageHandleStandardArgs)
find_path(LibUSB_INCLUDE_DIR libusb.h PATH_SUFFIXES libusb-1.0)
find_library(LibUSB_LIBRARY usb-1.0)
find_package_handle_standard_args(LibUSB REQUIRED_VARS LibUSB_LIBRARY LibUSB_INCLUDE_DIR)
if(LibUSB_FOUND AND NOT TARGET LibUSB::LibUSB)
  add_library(LibUSB::LibUSB UNKNOWN IMPORTED)
  set_target_properties(LibUSB::LibUSB PROPERTIES
    IMPORTED_LOCATION "${LibUSB_LIBRARY}" INTERFACE_INCLUDE_DIRECTORIES "${LibUSB_INCLUDE_DIR}")
endif()
