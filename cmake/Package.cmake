# `cpack` in the build folder makes a Debian package of the program; what it needs is read from its files.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME flexkey)
set(CPACK_PACKAGE_CONTACT "The flexkey maintainers")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY ${PROJECT_DESCRIPTION})
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_COMPONENTS_ALL program)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME flexkey)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_PROGRAM_DESCRIPTION "animate a mesh without a rig
 flexkey turns a text timeline into an animated mesh: it says where handles go over time and how rigid or smooth
 the surface is, and the frames become a glTF morph-target animation, vertex caches or pictures.")
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
if(FLEXKEY_PREVIEW)  # whose texts are set in it
  set(CPACK_DEBIAN_PROGRAM_PACKAGE_DEPENDS fonts-dejavu-core)
endif()
include(CPack)
