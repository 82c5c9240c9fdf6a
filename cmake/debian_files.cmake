# SPDX-License-Identifier: MIT
# cpack runs this on the files that it has installed, before it packs them.
if(CPACK_GENERATOR STREQUAL "DEB")
  # Debian has a package's licence under the package's name.
  set(prefix ${CPACK_TEMPORARY_INSTALL_DIRECTORY}${CPACK_PACKAGING_INSTALL_PREFIX})
  set(doc ${prefix}/share/doc)
  file(MAKE_DIRECTORY ${doc}/${CPACK_DEBIAN_PACKAGE_NAME})
  file(RENAME ${doc}/${CPACK_PACKAGE_NAME}/LICENSE ${doc}/${CPACK_DEBIAN_PACKAGE_NAME}/copyright)
  file(REMOVE_RECURSE ${doc}/${CPACK_PACKAGE_NAME})
  # Everybody may read the folders, also where the umask of this build is strict.
  file(CHMOD_RECURSE ${prefix} DIRECTORY_PERMISSIONS
    OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
endif()
