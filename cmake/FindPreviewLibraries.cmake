# FLEXKEY_PREVIEW: ON where OpenSubdiv and Embree are installed, and OFF with a word about it where they are not.
# OpenSubdiv's own CMake package names a static library that Debian does not ship, hence the search.
find_path(OPENSUBDIV_INCLUDE_DIR opensubdiv/far/topologyRefiner.h)
find_library(OPENSUBDIV_CPU_LIBRARY osdCPU)
find_package(embree 3.13 QUIET CONFIG)
mark_as_advanced(OPENSUBDIV_INCLUDE_DIR OPENSUBDIV_CPU_LIBRARY)
if(OPENSUBDIV_INCLUDE_DIR AND OPENSUBDIV_CPU_LIBRARY AND embree_FOUND)
  set(FLEXKEY_PREVIEW ON)
else()
  set(FLEXKEY_PREVIEW OFF)
  message(STATUS "flexkey is built without previews: they need libosd-dev and libembree-dev")
endif()
