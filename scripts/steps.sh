# SPDX-License-Identifier: Apache-2.0
# shellcheck shell=bash
# Progress reports for scripts. Sourced by scripts/setup, demo, test and format.
#
#   plan 3                               three steps will follow
#   step "Build the hub" make hub        runs the command, logs its output, prints one line with name and duration
#   begin_step "Build the page" npm ...  the same beside the steps that follow; end_step (await_step) waits for it
#   fail "One sentence."                 ends the script with that sentence
#
# A step that fails ends the script with one sentence, the path of its log and the log's last lines.

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
logs=$root/build/logs
script_name=scripts/$(basename "$0")
step_count=0
step_number=0

readonly quiet_seconds=20    # without a terminal: interval of the lines that show that the step is running
readonly shown_log_lines=25  # of a step that failed

plan() {
  step_count=$1
  mkdir -p "$logs"
}

fail() {
  printf '%s: %s\n' "$script_name" "$*" >&2
  exit 1
}

say() { printf '      %s\n' "$*"; }

# Prints the elapsed time repeatedly until it is killed or the script has ended. `read -t` on a pipe without data waits
# without a child process.
show_elapsed() {
  local title=$1 log=$2 pause=$quiet_seconds silent
  [[ -t 1 ]] && pause=1
  exec {silent}<> <(:)
  until read -r -t "$pause" -u "$silent" || ! kill -0 $$ 2>/dev/null; do
    if [[ -t 1 ]]; then
      printf '\r%s %d s' "$title" $((SECONDS - started))
    else
      say "$((SECONDS - started)) s: $(tail -n 1 "$log" | cut -c 1-100)"
    fi
  done
}

# run_step NAME COMMAND...: leaves the command's status in $step_status and the path of its log in $step_log.
# The command may be a function; it runs in a subshell under `set -e`. (Returning the status instead
# would require a call in an `if`, where bash ignores `set -e` in all nested commands.)
run_step() {
  local name=$1 started=$SECONDS ticker title
  shift
  step_number=$((step_number + 1))
  title="[$step_number/$step_count] $name ..."
  step_log=$logs/$(basename "$script_name")-$step_number.log
  : >"$step_log"
  if [[ -t 1 ]]; then printf '%s' "$title"; else printf '%s\n' "$title"; fi
  show_elapsed "$title" "$step_log" &
  ticker=$!
  set +e
  (set -e; "$@") >"$step_log" 2>&1
  step_status=$?
  kill "$ticker" 2>/dev/null
  wait "$ticker" 2>/dev/null
  set -e
  if [[ -t 1 ]]; then printf '\r%s ' "$title"; else printf '      '; fi
  if ((step_status == 0)); then printf 'done'; else printf 'failed'; fi
  printf ', %d s\n' $((SECONDS - started))
}

show_end_of_log() {
  tail -n "$shown_log_lines" "$step_log" | sed 's/^/  | /' >&2
}

# step NAME COMMAND...: as run_step, and a failure ends the script.
step() {
  run_step "$@"
  ((step_status == 0)) && return
  show_end_of_log
  fail "\"$1\" failed; the lines above are the end of ${step_log#"$root"/}."
}

# begin_step NAME COMMAND...: starts a step whose command runs beside the next ones. One at a time.
# Its processes are a group of their own, which ends with the script.
begin_step() {
  background_name=$1 background_started=$SECONDS
  shift
  step_number=$((step_number + 1))
  background_number=$step_number
  background_log=$logs/$(basename "$script_name")-$step_number.log
  printf '[%d/%d] %s, beside the next steps ...\n' "$step_number" "$step_count" "$background_name"
  set -m
  (set -e; "$@") >"$background_log" 2>&1 &
  background_group=$!
  set +m
  trap 'kill -- "-$background_group" 2>/dev/null' EXIT
}

# Waits for the command of begin_step; leaves its status in $step_status and the path of its log in $step_log.
await_step() {
  local verdict=done
  step_status=0
  wait "$background_group" || step_status=$?
  trap - EXIT
  step_log=$background_log
  ((step_status == 0)) || verdict=failed
  printf '[%d/%d] %s %s, %d s\n' "$background_number" "$step_count" "$background_name" "$verdict" \
    $((SECONDS - background_started))
}

# Waits for the command of begin_step; its failure ends the script.
end_step() {
  await_step
  ((step_status == 0)) && return
  show_end_of_log
  fail "\"$background_name\" failed; the lines above are the end of ${step_log#"$root"/}."
}
