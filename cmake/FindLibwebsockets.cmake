# Finds libwebsockets; the configuration that Debian ships with it brings in the paths of its own build. Target:
# Libwebsockets::libwebsockets.
include(FindPackageHandleStandardArgs)
find_path(Libwebsockets_INCLUDE_DIR libwebsockets.h)
find_library(Libwebsockets_LIBRARY websockets)
find_package_handle_standard_args(Libwebsockets REQUIRED_VARS Libwebsockets_LIBRARY Libwebsockets_INCLUDE_DIR)
if(Libwebsockets_FOUND AND NOT TARGET Libwebsockets::libwebsockets)
  add_library(Libwebsockets::libwebsockets UNKNOWN IMPORTED)
  set_target_properties(Libwebsockets::libwebsockets PROPERTIES
    IMPORTED_LOCATION "${Libwebsockets_LIBRARY}" INTERFACE_INCLUDE_DIRECTORIES "${Libwebsockets_INCLUDE_DIR}")
endif()
