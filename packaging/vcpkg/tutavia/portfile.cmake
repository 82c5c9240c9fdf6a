# SPDX-License-Identifier: MIT
# The port installs the source tree that it is part of: there is no release to download.
cmake_path(SET SOURCE_PATH NORMALIZE "${CMAKE_CURRENT_LIST_DIR}/../../..")

set(VCPKG_BUILD_TYPE release) # headers only
vcpkg_check_features(OUT_FEATURE_OPTIONS feature_options
    INVERTED_FEATURES json CMAKE_DISABLE_FIND_PACKAGE_nlohmann_json)
vcpkg_cmake_configure(
    SOURCE_PATH "${SOURCE_PATH}"
    OPTIONS
        ${feature_options}
        # tutavia::ros needs stb_image as a library, and vcpkg has its header only.
        -DCMAKE_DISABLE_FIND_PACKAGE_yaml-cpp=ON
        -DTUTAVIA_BUILD_TESTS=OFF
        -DTUTAVIA_BUILD_EXAMPLES=OFF
        -DTUTAVIA_BUILD_BENCHMARKS=OFF
    MAYBE_UNUSED_VARIABLES
        CMAKE_DISABLE_FIND_PACKAGE_nlohmann_json
        CMAKE_DISABLE_FIND_PACKAGE_yaml-cpp
)
vcpkg_cmake_install()
vcpkg_cmake_config_fixup(CONFIG_PATH share/cmake/tutavia)
vcpkg_fixup_pkgconfig()

file(REMOVE_RECURSE "${CURRENT_PACKAGES_DIR}/share/doc")
file(INSTALL "${CURRENT_PORT_DIR}/usage" DESTINATION "${CURRENT_PACKAGES_DIR}/share/${PORT}")
vcpkg_install_copyright(FILE_LIST "${SOURCE_PATH}/LICENSE")
