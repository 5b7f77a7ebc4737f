# SPDX-License-Identifier: Apache-2.0
# shellcheck shell=bash
# A minimal Debian 12 in a folder. Sourced after steps.sh and debian.sh.

readonly fresh_limit_seconds=900

# This system's own mirror, or Debian's.
debian_mirror() {
  local found
  found=$(cat /etc/apt/sources.list /etc/apt/sources.list.d/* 2>/dev/null |
    sed -n -e 's/^URIs: *\(http[^ ]*\/debian\) *$/\1/p' -e 's/^deb [^#]*\(http[^ ]*\/debian\) bookworm .*/\1/p') || true
  found=${found%%$'\n'*}
  printf '%s\n' "${found:-http://deb.debian.org/debian}"
}

# make_fresh_debian FOLDER
make_fresh_debian() {
  ((EUID == 0)) || fail "a fresh Debian needs root (debootstrap, chroot)."
  command -v debootstrap >/dev/null || fail "debootstrap is not installed."
  timeout "$fresh_limit_seconds" debootstrap --variant=minbase bookworm "$1" "$(debian_mirror)"
  mount -t proc proc "$1/proc"
  cp -r /etc/apt/apt.conf.d "$1/etc/apt/"
  cp /etc/resolv.conf /etc/hosts "$1/etc/"
}

remove_fresh_debian() {
  umount "$1/proc" 2>/dev/null || true
  rm -rf --one-file-system "$1"
}

# in_fresh COMMANDS: runs the commands in the Debian in $fresh.
in_fresh() {
  timeout "$fresh_limit_seconds" chroot "$fresh" /usr/bin/env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root \
    DEBIAN_FRONTEND=noninteractive LC_ALL=C bash -euo pipefail -c "$1"
}
