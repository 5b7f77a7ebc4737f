# SPDX-License-Identifier: Apache-2.0
# shellcheck shell=bash
# Builds the three parts: native programs, the wasm modules, the page. Sourced after steps.sh.

readonly kib_per_job=$((1536 * 1024))  # memory that one compiler may need

# Number of parallel compilers: one per core, limited by memory.
job_count() {
  local cores available_kib jobs
  cores=$(nproc)
  available_kib=$(awk '/^MemAvailable:/ {print $2}' /proc/meminfo)
  jobs=$((available_kib / kib_per_job))
  ((jobs > cores)) && jobs=$cores
  ((jobs < 1)) && jobs=1
  printf '%d\n' "$jobs"
}

# build_preset NAME [TARGET...]: configure one preset of CMakePresets.json and build these targets of it (default: all).
build_preset() {
  local preset=$1
  shift
  if command -v ccache >/dev/null; then export CMAKE_CXX_COMPILER_LAUNCHER=ccache; fi
  cd "$root"
  cmake --preset "$preset"
  cmake --build --preset "$preset" --parallel "$(job_count)" ${1:+--target "$@"}
}

# npm ci empties node_modules first, so it runs only when the lock file (or node) has changed since its last run.
install_web_packages() {
  local stamp=node_modules/.roomcast-installed wanted
  cd "$root/web"
  wanted="$(sha256sum <package-lock.json) node $(node --version)"
  if [[ -f $stamp && $(<"$stamp") == "$wanted" ]]; then
    printf 'node_modules is up to date.\n'
    return
  fi
  npm ci --no-audit --no-fund
  printf '%s\n' "$wanted" >"$stamp"
}

# True if a source of the page is newer than the page. (Folders count: a deletion changes their time.)
page_is_up_to_date() {
  local page=$root/build/web/index.html newer
  [[ -f $page ]] || return 1
  newer=$(find "$root/web" "$root/roomcast/wire/control.proto" "$root"/build/wasm/*.wasm \
    -name node_modules -prune -o -newer "$page" -print -quit)
  [[ -z $newer ]] || return 1
}

build_web() {
  if page_is_up_to_date; then
    printf 'the page is up to date.\n'
    return
  fi
  cd "$root/web"
  npm run build
}

# The page with all that it needs: the wasm modules and the npm packages.
build_page() {
  build_preset wasm
  install_web_packages
  build_web
}
