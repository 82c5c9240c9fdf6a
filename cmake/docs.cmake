# SPDX-License-Identifier: MIT
# The target docs writes pages about every header for users, the manual and the other documents:
#
#   cmake --build build/release --target docs    build/release/html/index.html
#
# It needs doxygen, and is styled if doxygen-awesome-css is installed. A warning is an error.
find_package(Doxygen 1.9.1 QUIET)
find_package(Python3 COMPONENTS Interpreter QUIET)
if(NOT DOXYGEN_FOUND OR NOT Python3_FOUND)
  message(STATUS "the target docs is left out: it needs doxygen 1.9.1 or later, and python3")
  return()
endif()

set(DOXYGEN_PROJECT_BRIEF "${PROJECT_DESCRIPTION}")
set(DOXYGEN_QUIET YES)
set(DOXYGEN_WARN_AS_ERROR FAIL_ON_WARNINGS)
set(DOXYGEN_WARN_IF_UNDOCUMENTED NO)
set(DOXYGEN_STRIP_FROM_PATH ${PROJECT_SOURCE_DIR}/include ${PROJECT_SOURCE_DIR})
set(DOXYGEN_STRIP_FROM_INC_PATH ${PROJECT_SOURCE_DIR}/include)
set(DOXYGEN_USE_MDFILE_AS_MAINPAGE ${PROJECT_SOURCE_DIR}/README.md)
# The interpreter itself: it starts for every file, and a script in front of it, such as pyenv's,
# would take most of the time.
execute_process(COMMAND ${Python3_EXECUTABLE} -c "import sys; print(sys.executable)"
  OUTPUT_VARIABLE python OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
set(DOXYGEN_INPUT_FILTER "${python} -IS ${PROJECT_SOURCE_DIR}/cmake/docs_filter.py")
set(DOXYGEN_EXAMPLE_PATH examples)
set(DOXYGEN_IMAGE_PATH docs/images docs/gallery docs/reproduction)

# What a user sees: no machinery, and a first sentence as summary.
set(DOXYGEN_EXCLUDE_PATTERNS */include/tutavia/*/*/*)
set(DOXYGEN_EXCLUDE_SYMBOLS *detail::* *::detail)
set(DOXYGEN_JAVADOC_AUTOBRIEF YES)
set(DOXYGEN_EXTRACT_ALL YES)
set(DOXYGEN_HIDE_SCOPE_NAMES YES)
set(DOXYGEN_SORT_MEMBER_DOCS NO)
set(DOXYGEN_MACRO_EXPANSION YES)
set(DOXYGEN_EXPAND_ONLY_PREDEF YES)
set(DOXYGEN_PREDEFINED TUTAVIA_ALWAYS_INLINE=)
set(DOXYGEN_SOURCE_BROWSER YES)
set(DOXYGEN_STRIP_CODE_COMMENTS NO)
set(DOXYGEN_REFERENCED_BY_RELATION NO)

set(DOXYGEN_GENERATE_TREEVIEW YES)
set(DOXYGEN_HAVE_DOT NO)
find_path(TUTAVIA_DOXYGEN_AWESOME_DIR doxygen-awesome.css PATH_SUFFIXES share/doxygen-awesome-css)
mark_as_advanced(TUTAVIA_DOXYGEN_AWESOME_DIR)
if(TUTAVIA_DOXYGEN_AWESOME_DIR)
  set(DOXYGEN_HTML_EXTRA_STYLESHEET ${TUTAVIA_DOXYGEN_AWESOME_DIR}/doxygen-awesome.css
    ${TUTAVIA_DOXYGEN_AWESOME_DIR}/doxygen-awesome-sidebar-only.css)
endif()

file(GLOB documents RELATIVE ${PROJECT_SOURCE_DIR} docs/*.md)
file(GLOB programs RELATIVE ${PROJECT_SOURCE_DIR} examples/*.cpp)
doxygen_add_docs(docs README.md docs/manual ${documents} docs/reproduction docs/decisions
  CONTRIBUTING.md CHANGELOG.md SECURITY.md packaging/README.md tests/README.md
  examples/playground/README.md include/tutavia ${programs} COMMENT "Writing html/index.html")
