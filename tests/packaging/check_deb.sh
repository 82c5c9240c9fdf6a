#!/bin/sh
# SPDX-License-Identifier: MIT
# Packs libtutavia-dev and compares its files with those of `cmake --install`.
#
#   check_deb.sh CPACK CPACK_CONFIG INSTALLED_PREFIX
set -eu
cpack=$1 config=$2 installed=$3
rm -rf deb
umask 077  # must not reach the package
"$cpack" -G DEB --config "$config" -B deb
package=$(echo deb/libtutavia-dev_*_all.deb)

fail() { echo "check_deb.sh: $1" >&2; exit 1; }
field() { dpkg-deb -f "$package" "$1"; }
[ "$(field Architecture)" = all ] || fail "Architecture is $(field Architecture)"
[ "$(field Section)" = libdevel ] || fail "Section is $(field Section)"
case $(field Depends) in libeigen3-dev*) ;; *) fail "Depends is $(field Depends)" ;; esac

dpkg-deb -x "$package" deb/unpacked
# The licence has the package's name in Debian; all else is the same.
mkdir -p deb/expected
cp -r "$installed/include" "$installed/share" deb/expected
mkdir deb/expected/share/doc/libtutavia-dev
mv deb/expected/share/doc/tutavia/LICENSE deb/expected/share/doc/libtutavia-dev/copyright
rmdir deb/expected/share/doc/tutavia
diff -r deb/expected deb/unpacked/usr || fail "the package's files are not those installed"
[ "$(ls deb/unpacked)" = usr ] || fail "files outside of /usr"
[ "$(ls "$installed")" = "$(ls deb/unpacked/usr)" ] || fail "something is installed elsewhere"
[ -z "$(find deb/unpacked/usr -type d ! -perm 755)" ] || fail "some folder has not mode 755"
echo "check_deb.sh: $package has the $(find deb/unpacked -type f | wc -l) files that are installed"
