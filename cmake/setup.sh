#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Installs what is missing (Debian and Ubuntu, through apt), then builds and runs.
#
#   cmake/setup.sh demo        plans the built-in maze, prints a table and writes maze.svg
#   cmake/setup.sh test        builds the examples and tests, and runs the whole test suite
#   cmake/setup.sh playground  builds the web page (build/wasm/playground/index.html) and tests it
#   cmake/setup.sh python      builds the Python package and tutavia-batch, and runs their tests
#   cmake/setup.sh tools       only installs what the sanitizer, format and lint checks need
set -euo pipefail
mode=${1:-}
case $mode in
  demo | test | playground | python | tools) ;;
  *) echo "usage: cmake/setup.sh demo|test|playground|python|tools" >&2; exit 2 ;;
esac
here=$PWD
cd "$(dirname "$0")/.."

has_header() { for dir in /usr/include /usr/local/include; do [ -e "$dir/$1" ] && return 0; done; return 1; }
missing=()
need_command() { command -v "$1" >/dev/null || missing+=("$2"); }
need_module() { /usr/bin/python3 -c "import $1" 2>/dev/null || missing+=("$2"); }
need_header() { has_header "$1" || missing+=("$2"); }

need_command g++ g++
need_command cmake cmake
need_command ninja ninja-build
need_header eigen3/Eigen/Core libeigen3-dev
need_header CLI/CLI.hpp libcli11-dev
need_header nlohmann/json.hpp nlohmann-json3-dev
need_header yaml-cpp/yaml.h libyaml-cpp-dev
need_header stb/stb_image.h libstb-dev
if [ "$mode" = python ]; then
  need_header pybind11/pybind11.h pybind11-dev
  compgen -G "/usr/include/python3.*/Python.h" >/dev/null || missing+=(python3-dev)
  need_module numpy python3-numpy
  need_module pytest python3-pytest
  need_module shapely python3-shapely
  need_module matplotlib python3-matplotlib
  need_module distributed python3-distributed
fi
if [ "$mode" = test ] || [ "$mode" = tools ]; then
  need_header boost/multiprecision/cpp_int.hpp libboost-dev
  has_header catch2/catch.hpp || need_header catch2/catch_all.hpp catch2
fi
if [ "$mode" = tools ]; then
  need_command clang++ clang
  need_command clang++-19 clang-19
  need_command clang-format clang-format
  need_command clang-tidy clang-tidy
  need_command python3 python3
  need_command doxygen doxygen
  [ -e /usr/share/doxygen-awesome-css ] || missing+=(doxygen-awesome-css)
  # clang's sanitizer runtime is a package of its own in some releases
  if command -v clang++ >/dev/null &&
     ! echo 'int main(){}' | clang++ -x c++ -fsanitize=address,fuzzer-no-link - -o /dev/null 2>/dev/null; then
    missing+=("libclang-rt-$(clang++ -dumpversion | cut -d. -f1)-dev")
  fi
fi

if [ "$mode" = playground ]; then
  need_command em++ emscripten
  need_command npm npm
  # Ubuntu has Chromium as a snap alone; without a browser the tests of the page are skipped.
  if grep -q '^ID=debian' /etc/os-release 2>/dev/null; then need_command chromium chromium; fi
fi

if [ ${#missing[@]} -gt 0 ]; then
  as_root=()
  if [ "$(id -u)" -ne 0 ]; then
    if command -v sudo >/dev/null && sudo -n true 2>/dev/null; then
      as_root=(sudo)
    else
      echo "setup.sh: missing packages: ${missing[*]} (install them as root: apt-get install ${missing[*]})" >&2
      exit 1
    fi
  fi
  if ! command -v apt-get >/dev/null; then
    echo "setup.sh: missing packages: ${missing[*]} (no apt-get here: install them by other means)" >&2
    exit 1
  fi
  export DEBIAN_FRONTEND=noninteractive
  "${as_root[@]}" apt-get update -qq
  "${as_root[@]}" apt-get install -y -qq --no-install-recommends "${missing[@]}" </dev/null >/dev/null
  # A compiler that has just arrived may want its sanitizer runtime.
  if [ "$mode" = tools ]; then exec cmake/setup.sh tools; fi
fi

case $mode in
  demo)
    cmake --preset demo >/dev/null
    cmake --build --preset demo
    cd "$here"
    exec "$OLDPWD/build/demo/examples/tutavia-plan"
    ;;
  test)
    cmake --preset test
    cmake --build --preset test
    exec ctest --preset test
    ;;
  playground)
    node -e 'const [a, b] = process.versions.node.split("."); process.exit(100 * a + +b < 2019 ? 1 : 0)' || {
      echo "setup.sh: the page needs Node 20.19 or later, found $(node --version 2>&1)" >&2
      exit 1
    }
    cmake --preset wasm "${@:2}"
    cmake --build --preset wasm
    ctest --preset wasm
    echo "the playground: $PWD/build/wasm/playground/index.html"
    ;;
  python)
    # The packages above are those of Debian's own Python.
    cmake --preset python -DPython3_EXECUTABLE=/usr/bin/python3 "${@:2}"
    cmake --build --preset python
    ctest --preset python
    echo "To use it: export PYTHONPATH=$PWD/build/python/python"
    echo "or install it: cmake --install build/python --component python"
    ;;
esac
