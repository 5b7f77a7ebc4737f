# SPDX-License-Identifier: Apache-2.0
# shellcheck shell=bash
# Installs missing packages of the list in scripts/packages with apt. Sourced after steps.sh.
# If no package is missing, no apt command runs, so a second run is fast and needs no root rights.

readonly oldest_node=18          # Debian 12's
readonly apt_lock_seconds=600    # another apt (for example unattended-upgrades) may be running

as_root() {
  if ((EUID == 0)); then "$@"; else sudo "$@"; fi
}

# packages_of GROUP...: the packages that scripts/packages lists for these groups.
packages_of() {
  local group package _
  while read -r group package _; do
    [[ " $* " == *" $group "* ]] && printf '%s\n' "$package"
  done < <(sed 's/#.*//' "$root/scripts/packages")
  return 0
}

is_installed() {
  [[ $(dpkg-query -W -f='${db:Status-Status}' "$1" 2>/dev/null) == installed ]]
}

node_major() {
  local version
  version=$(node --version 2>/dev/null) || version=v0
  version=${version#v}
  printf '%s\n' "${version%%.*}"
}

# Debian's nodejs is installed only if there is no node: a newer node is kept, an older one never replaced.
missing_node_packages() {
  command -v node >/dev/null || printf 'nodejs\n'
  command -v npm >/dev/null || printf 'npm\n'
}

missing_packages() {
  local package
  for package in $(packages_of "$@"); do
    is_installed "$package" || printf '%s\n' "$package"
  done
  missing_node_packages
}

require_debian() {
  local name=unknown
  # shellcheck disable=SC1091
  [[ -r /etc/os-release ]] && name=$(. /etc/os-release && printf '%s' "$PRETTY_NAME")
  command -v apt-get >/dev/null ||
    fail "these scripts install with apt and this system ($name) has none;" \
      "install the counterparts of scripts/packages and run again with ROOMCAST_SKIP_INSTALL=1."
  [[ $name == "Debian GNU/Linux 12"* ]] ||
    say "made for Debian 12; this is $name, where package names may differ."
}

require_root() {
  ((EUID == 0)) && return
  command -v sudo >/dev/null ||
    fail "packages have to be installed ($*): run this once as root, or install sudo."
  sudo -v || fail "packages have to be installed and sudo said no; run scripts/setup as root once."
}

# Waits for the lock, because apt-get update does not.
update_package_lists() {
  local waited=0 output
  until output=$(as_root apt-get -o Acquire::Retries=3 update 2>&1); do
    printf '%s\n' "$output"
    [[ $output == *"Could not get lock"* ]] && ((waited < apt_lock_seconds)) || return 1
    sleep 5
    waited=$((waited + 5))
  done
}

apt_install() {
  update_package_lists
  as_root env DEBIAN_FRONTEND=noninteractive apt-get install --yes --no-install-recommends --no-remove \
    -o DPkg::Lock::Timeout="$apt_lock_seconds" -o Acquire::Retries=3 "$@"
}

require_node() {
  (($(node_major) >= oldest_node)) ||
    fail "$(command -v node) is node $(node --version), roomcast needs $oldest_node or newer;" \
      "put a newer one first in PATH, or remove it and run again for Debian's."
}

# install_missing GROUP...: one step.
install_missing() {
  local missing=()
  if [[ -n ${ROOMCAST_SKIP_INSTALL:-} ]]; then
    step "Packages: not looked at (ROOMCAST_SKIP_INSTALL)" true
  else
    require_debian
    mapfile -t missing < <(missing_packages "$@")
    if ((${#missing[@]} == 0)); then
      step "Packages: all there" true
    else
      require_root "${missing[@]}"
      step "Install ${#missing[@]} packages with apt" apt_install "${missing[@]}"
    fi
  fi
  require_node
}
