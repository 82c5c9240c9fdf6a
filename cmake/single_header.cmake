# SPDX-License-Identifier: MIT
# The target single-header writes the umbrella and all that it includes as one file:
#
#   cmake --build build/release --target single-header    build/release/single/tutavia_single.hpp
find_package(Python3 COMPONENTS Interpreter QUIET)
if(Python3_FOUND)
  set(TUTAVIA_SINGLE_HEADER_DIR ${CMAKE_CURRENT_BINARY_DIR}/single)
  file(MAKE_DIRECTORY ${TUTAVIA_SINGLE_HEADER_DIR})
  add_custom_command(OUTPUT ${TUTAVIA_SINGLE_HEADER_DIR}/tutavia_single.hpp
    COMMAND Python3::Interpreter ${CMAKE_CURRENT_LIST_DIR}/single_header.py
      ${TUTAVIA_SINGLE_HEADER_DIR}/tutavia_single.hpp
    DEPENDS ${CMAKE_CURRENT_LIST_DIR}/single_header.py LICENSE ${tutavia_headers}
    COMMENT "Writing tutavia_single.hpp" VERBATIM)
  add_custom_target(single-header DEPENDS ${TUTAVIA_SINGLE_HEADER_DIR}/tutavia_single.hpp)
else()
  message(STATUS "the target single-header is left out: it needs python3")
endif()
