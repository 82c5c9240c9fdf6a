#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Runs the two commands of the README in a bare root of another release, as someone who has nothing
# installed would; by hand before a release, as root.
#
#   cmake/try_on.sh trixie [FOLDER]    Debian 13 in FOLDER (default: build/try_on/trixie), kept for
#                                      another try
set -euo pipefail
release=${1:-}
[ -n "$release" ] || { echo "usage: cmake/try_on.sh RELEASE [FOLDER]" >&2; exit 2; }
cd "$(dirname "$0")/.."
[ "$(id -u)" -eq 0 ] || { echo "try_on.sh: has to be run as root" >&2; exit 1; }
command -v debootstrap >/dev/null ||
  { echo "try_on.sh: needs debootstrap (apt-get install debootstrap)" >&2; exit 1; }
root=${2:-build/try_on/$release}

# The package mirror, proxy and keys of this machine serve the other release as well.
source_line=$(apt-get indextargets --format '$(SITE)' 'Created-By: Packages' | grep -v security | head -1)
if [ ! -e "$root/etc/debian_version" ]; then
  mkdir -p "$root"
  debootstrap --variant=minbase "$release" "$root" "$source_line"
fi
cp -r /etc/apt/apt.conf.d/. "$root/etc/apt/apt.conf.d/"
cp /etc/resolv.conf /etc/hosts "$root/etc/"
mounts=(proc dev)
cleanup() { for name in "${mounts[@]}"; do umount -l "$root/$name" 2>/dev/null || true; done; }
trap cleanup EXIT
mount -t proc proc "$root/proc"
mount --bind /dev "$root/dev"

rm -rf "$root/tutavia"
git clone -q . "$root/tutavia"
started=$SECONDS
for mode in demo test; do
  before=$SECONDS
  chroot "$root" env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LC_ALL=C \
    sh -c "cd /tutavia && cmake/setup.sh $mode" 2>&1 | tee "build/try_on_$release.$mode.log"
  echo "try_on.sh: cmake/setup.sh $mode: $((SECONDS - before)) s"
done
if grep -H 'warning:' build/try_on_"$release".*.log; then
  echo "try_on.sh: there are warnings" >&2
  exit 1
fi
echo "try_on.sh: both commands work on $release without a warning, $((SECONDS - started)) s"
