# FLEXKEY_PREVIEW: turned off where the libraries that draw and write pictures are not all installed. OpenSubdiv's
# own CMake package names a static library that Debian does not ship, OpenImageIO's is fatal without its command-line
# tools and names folders that Debian lacks: hence the search.
option(FLEXKEY_PREVIEW "Draw previews, with OpenSubdiv, Embree and OpenImageIO" ON)
if(NOT FLEXKEY_PREVIEW)
  return()
endif()
find_path(OPENSUBDIV_INCLUDE_DIR opensubdiv/far/topologyRefiner.h)
find_library(OPENSUBDIV_CPU_LIBRARY osdCPU)
find_package(embree 3.13 QUIET CONFIG)
find_path(OIIO_INCLUDE_DIR OpenImageIO/imagebufalgo.h)
find_library(OIIO_LIBRARY OpenImageIO)
find_library(OIIO_UTIL_LIBRARY OpenImageIO_Util)
find_path(GIF_INCLUDE_DIR gif_lib.h)
find_library(GIF_LIBRARY gif)
find_path(WEBP_INCLUDE_DIR webp/mux.h)
find_library(WEBP_MUX_LIBRARY webpmux)
find_package(Freetype QUIET)
set(preview_libraries OPENSUBDIV_INCLUDE_DIR OPENSUBDIV_CPU_LIBRARY OIIO_INCLUDE_DIR OIIO_LIBRARY OIIO_UTIL_LIBRARY
  GIF_INCLUDE_DIR GIF_LIBRARY WEBP_INCLUDE_DIR WEBP_MUX_LIBRARY)
mark_as_advanced(${preview_libraries})
foreach(found IN LISTS preview_libraries ITEMS embree_FOUND Freetype_FOUND)
  if(NOT ${found})
    message(STATUS "flexkey is built without previews (${found}): they need libosd-dev, libembree-dev, "
      "libopenimageio-dev, libgif-dev, libwebp-dev and libfreetype-dev")
    set(FLEXKEY_PREVIEW OFF)
    return()
  endif()
endforeach()
