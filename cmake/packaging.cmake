# SPDX-License-Identifier: MIT
# The Debian package libtutavia-dev, of what `cmake --install` installs:
#
#   cpack -G DEB --config build/release/CPackConfig.cmake
#
# It holds tutavia::json and tutavia::ros where the configuration found their libraries. Whoever
# distributes it adds -D "CPACK_DEBIAN_PACKAGE_MAINTAINER=Name <address>".

# Nothing that is installed is built, so neither installing nor packing has to build the tests.
set(CMAKE_SKIP_INSTALL_ALL_DEPENDENCY ON)

set(CPACK_GENERATOR DEB)
set(CPACK_VERBATIM_VARIABLES ON)
set(CPACK_PACKAGE_NAME tutavia)
set(CPACK_PACKAGE_VENDOR "The tutavia authors")
set(CPACK_PACKAGE_CONTACT "The tutavia authors")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "safe, smooth, short paths for a robot (C++ headers)")

set(CPACK_DEBIAN_PACKAGE_NAME libtutavia-dev)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_PACKAGE_ARCHITECTURE all)
set(CPACK_DEBIAN_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_PACKAGE_DEPENDS "libeigen3-dev (>= 3.4)")
set(recommended)
if(nlohmann_json_FOUND)
  list(APPEND recommended "nlohmann-json3-dev (>= 3.9)")
endif()
if(tutavia_ros_dependencies_FOUND)
  list(APPEND recommended "libyaml-cpp-dev (>= 0.7)" libstb-dev)
endif()
list(JOIN recommended ", " CPACK_DEBIAN_PACKAGE_RECOMMENDS)
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "libboost-dev (>= 1.74)")  # geometry/boost_adapt.hpp
set(CPACK_DEBIAN_PACKAGE_DESCRIPTION
  "C++20 headers that plan safe, smooth, short paths for a disc-shaped robot or
a vehicle in the plane, among polygons and discs or on the cells of a grid map.
Every path comes with a proof that all of it keeps the safety radius.")
set(CPACK_PRE_BUILD_SCRIPTS ${CMAKE_CURRENT_LIST_DIR}/debian_files.cmake)

include(CPack)
