#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Tries the library in a bare root of another release, as someone who has nothing installed would;
# by hand before a release, as root.
#
#   cmake/try_on.sh trixie [FOLDER [MODE...]]    Debian 13 in FOLDER (default: build/try_on/trixie),
#                                                kept for another try
#   cmake/try_on.sh noble [FOLDER [MODE...]]     Ubuntu 24.04; needs ubuntu-archive-keyring
#
# A mode is demo, test or python, a command of setup.sh; package: installs the Debian package with
# what apt gives it, and builds and runs the project of tests/consumer_install; wheel: installs the
# Python package by pip and scikit-build-core (not in Debian 12). The default is demo, test and
# package.
set -euo pipefail
release=${1:-}
[ -n "$release" ] || { echo "usage: cmake/try_on.sh RELEASE [FOLDER [MODE...]]" >&2; exit 2; }
cd "$(dirname "$0")/.."
[ "$(id -u)" -eq 0 ] || { echo "try_on.sh: has to be run as root" >&2; exit 1; }
command -v debootstrap >/dev/null ||
  { echo "try_on.sh: needs debootstrap (apt-get install debootstrap)" >&2; exit 1; }
root=${2:-build/try_on/$release}
modes=("${@:3}")
[ ${#modes[@]} -gt 0 ] || modes=(demo test package)

case $release in
  jammy | noble | plucky | questing) mirror=http://archive.ubuntu.com/ubuntu components=main,universe ;;
  *)
    # The package mirror, proxy and keys of this machine serve other releases of Debian as well.
    mirror=$(apt-get indextargets --format '$(SITE)' 'Created-By: Packages' | grep -v security | head -1)
    components=main
    ;;
esac
if [ ! -e "$root/etc/debian_version" ]; then
  mkdir -p "$root"
  debootstrap --variant=minbase --components="$components" "$release" "$root" "$mirror"
fi
cp -r /etc/apt/apt.conf.d/. "$root/etc/apt/apt.conf.d/"
cp /etc/resolv.conf /etc/hosts "$root/etc/"
mounts=(proc dev)
cleanup() { for name in "${mounts[@]}"; do umount -l "$root/$name" 2>/dev/null || true; done; }
trap cleanup EXIT
mount -t proc proc "$root/proc"
mount --bind /dev "$root/dev"

mkdir -p build
in_root() {
  chroot "$root" env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LC_ALL=C \
    DEBIAN_FRONTEND=noninteractive sh -ec "$1"
}

clone_into_root() {
  rm -rf "$root/tutavia"
  git clone -q . "$root/tutavia"
}

try_command() {
  clone_into_root
  in_root "cd /tutavia && cmake/setup.sh $1"
}

# The sources are not there: only the package and the project that uses it.
try_package() {
  rm -rf "$root/tutavia" "$root/package" build/try_on_package
  mkdir "$root/package"
  cmake -B build/try_on_package -DTUTAVIA_BUILD_TESTS=OFF -DTUTAVIA_BUILD_EXAMPLES=OFF \
    -DTUTAVIA_BUILD_BENCHMARKS=OFF
  cpack -G DEB --config build/try_on_package/CPackConfig.cmake -B build/try_on_package
  cp -r build/try_on_package/*.deb tests/consumer_install "$root/package"
  in_root "apt-get update -qq
    apt-get install -y -qq --no-install-recommends g++ cmake make pkg-config >/dev/null
    apt-get install -y -qq /package/*.deb >/dev/null
    dpkg -s libtutavia-dev
    cmake -S /package/consumer_install -B /package/build
    cmake --build /package/build
    /package/build/consumer && /package/build/ros_consumer && pkg-config --cflags tutavia
    apt-get remove -y -qq libtutavia-dev >/dev/null && test ! -e /usr/include/tutavia"
}

try_wheel() {
  clone_into_root
  in_root "apt-get update -qq
    apt-get install -y -qq --no-install-recommends g++ ninja-build cmake libeigen3-dev pybind11-dev \
      python3-dev python3-numpy python3-pip python3-scikit-build-core >/dev/null
    pip install --quiet --break-system-packages --no-build-isolation --no-deps /tutavia/python
    pip show tutavia
    python3 -c 'import tutavia
scene = tutavia.builtin_map(\"maze\")
print(tutavia.plan(tutavia.LatticeSpace(scene.workspace), scene.start, scene.goals[0]))'"
}

started=$SECONDS
for mode in "${modes[@]}"; do
  before=$SECONDS
  case $mode in
    demo | test | python) try_command "$mode" ;;
    package) try_package ;;
    wheel) try_wheel ;;
    *) echo "try_on.sh: no mode is named $mode" >&2; exit 2 ;;
  esac 2>&1 | tee "build/try_on_$release.$mode.log"
  echo "try_on.sh: $mode: $((SECONDS - before)) s"
done
if grep -H 'warning:' build/try_on_"$release".*.log; then
  echo "try_on.sh: there are warnings" >&2
  exit 1
fi
echo "try_on.sh: ${modes[*]} on $release without a warning, $((SECONDS - started)) s"
