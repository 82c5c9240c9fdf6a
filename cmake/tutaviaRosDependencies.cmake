# SPDX-License-Identifier: MIT
# Finds what tutavia::ros needs: yaml-cpp 0.7 or later (libyaml-cpp-dev), and stb_image as a library
# (libstb-dev). Sets tutavia_ros_dependencies_FOUND, and defines tutavia::ros_dependencies.
find_package(yaml-cpp QUIET CONFIG)
find_path(TUTAVIA_STB_INCLUDE_DIR stb/stb_image.h)
find_library(TUTAVIA_STB_LIBRARY stb)
mark_as_advanced(TUTAVIA_STB_INCLUDE_DIR TUTAVIA_STB_LIBRARY)
set(tutavia_ros_dependencies_FOUND FALSE)
if(yaml-cpp_FOUND AND NOT yaml-cpp_VERSION VERSION_LESS 0.7
    AND TUTAVIA_STB_INCLUDE_DIR AND TUTAVIA_STB_LIBRARY)
  set(tutavia_ros_dependencies_FOUND TRUE)
  if(NOT TARGET tutavia::ros_dependencies)
    set(tutavia_yaml yaml-cpp)  # 0.7; later versions have a namespace
    if(TARGET yaml-cpp::yaml-cpp)
      set(tutavia_yaml yaml-cpp::yaml-cpp)
    endif()
    # Seen from every folder, also where tutavia is a subdirectory of another project.
    add_library(tutavia::ros_dependencies INTERFACE IMPORTED GLOBAL)
    set_property(TARGET tutavia::ros_dependencies PROPERTY INTERFACE_INCLUDE_DIRECTORIES
      ${TUTAVIA_STB_INCLUDE_DIR})
    get_target_property(tutavia_yaml_alias ${tutavia_yaml} ALIASED_TARGET)
    if(tutavia_yaml_alias)
      set(tutavia_yaml ${tutavia_yaml_alias})
    endif()
    get_target_property(tutavia_yaml_imported ${tutavia_yaml} IMPORTED)
    if(tutavia_yaml_imported)
      set_property(TARGET ${tutavia_yaml} PROPERTY IMPORTED_GLOBAL TRUE)
    endif()
    set_property(TARGET tutavia::ros_dependencies PROPERTY INTERFACE_LINK_LIBRARIES
      ${tutavia_yaml} ${TUTAVIA_STB_LIBRARY})
  endif()
endif()
