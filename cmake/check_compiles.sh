#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Compiles, without making code and with warnings as errors, what the test build does not.
#
#   cmake/check_compiles.sh headers      every header alone, and the benchmarks
#   cmake/check_compiles.sh compilers    the umbrella, the JSON and ROS headers, the README's program
#                                        and the exact checker with g++ and clang 19 beside the headers of
#                                        Boost 1.81; every algorithm (the registries) with clang 19
set -euo pipefail
cd "$(dirname "$0")/.."
out=build/compiles
mkdir -p $out
flags=(-std=c++20 -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror -Iinclude
  -isystem /usr/include/eigen3)

# Runs a command for each line of standard input, in place of {}, on all cores; says what failed.
for_each() { xargs -P "$(nproc)" -I{} bash -c "$1 || { echo 'check_compiles.sh: {} does not compile' >&2; exit 1; }"; }

case ${1:-} in
  headers)
    git ls-files 'include/*.hpp' | sed 's|^include/||' |
      for_each "echo '#include \"{}\"' | clang++ ${flags[*]} -x c++ -fsyntax-only -"
    git ls-files 'benchmarks/*.cpp' ':!benchmarks/reproduce' |
      for_each "clang++ ${flags[*]} -Itests -DTUTAVIA_TEST_DATA='\"\"' -fsyntax-only {}"
    ;;
  compilers)
    if [ ! -e $out/boost/usr/include/boost/version.hpp ]; then
      (cd $out && apt-get download -qq libboost1.81-dev && dpkg -x libboost1.81-dev_*.deb boost)
    fi
    sed -n '/^#include <cstdio>/,/^```/p' README.md | grep -v '^```' >$out/readme.cpp
    {
      echo '#include "tutavia/tutavia.hpp"'
      echo '#include "tutavia/registry.hpp"'
      git ls-files 'include/*_json.hpp' 'include/*_yaml.hpp' 'include/*_stb.hpp' | sed 's|^include/\(.*\)|#include "\1"|'
    } >$out/umbrella.cpp
    {
      ls $out/*.cpp tests/certify/exact_test.cpp | sed 's/.*/g++ &\nclang++-19 &/'
      ls examples/plan/registry_*.cpp | sed 's/.*/clang++-19 &/'
    } |
      for_each "set -- {}; \$1 ${flags[*]} -Itests -isystem $out/boost/usr/include -fsyntax-only \$2"
    ;;
  *) echo "usage: cmake/check_compiles.sh headers|compilers" >&2; exit 2 ;;
esac
echo "check_compiles.sh: $1 compile without a warning"
