# SPDX-License-Identifier: Apache-2.0
# shellcheck shell=bash
# Runs test suites, adds up their reports, and prints a summary. Sourced after steps.sh.

passed=0
failed=0
skipped=0
skipped_tests=()
failed_tests=()
repeated_tests=()
readonly shown_failure_lines=100
readonly shown_failure_lines_of_test=40
readonly shown_name_characters=300  # of a failed test in the summary

# Each reader converts a suite's report to: passed failed skipped.
read_junit() {
  awk -F '"' '
    /^[ \t]*tests="/ {tests = $2} /^[ \t]*failures="/ {failures = $2}
    /^[ \t]*skipped="/ {skipped = $2} /^[ \t]*disabled="/ {disabled = $2}
    /<testcase / {exit}
    END {if (tests != "") print tests - failures - skipped - disabled, failures + 0, skipped + disabled}' "$1"
}

read_tap() {
  awk '
    /^# pass / {passed += $3; seen = 1} /^# (fail|cancelled) / {failed += $3}
    /^# (skipped|todo) / {skipped += $3}
    END {if (seen) print passed + 0, failed + 0, skipped + 0}' "$1"
}

# GoogleTest prints "file:line: Skipped" and the reason on the next line; CTest keeps both in its report.
skipped_in_junit() {
  awk '
    /<testcase / {split($0, part, "\""); name = part[2]}
    reason_follows {print name ": " $0; reason_follows = 0}
    /: Skipped$/ {reason_follows = 1}' "$1" | sed 's/&lt;/</g; s/&gt;/>/g; s/&quot;/"/g; s/&amp;/\&/g'
}

skipped_in_tap() {
  sed -n 's/^ *ok [0-9]* - \(.*\) # SKIP *\(.*\)$/\1: \2/p' "$1"
}

# The end of what each failed test printed, under its name.
failed_in_junit() {
  awk -v shown="$shown_failure_lines_of_test" '
    /<testcase / {split($0, part, "\""); name = part[2]; count = 0; fails = /status="fail"/; next}
    !fails {next}
    /<\/testcase>/ {
      print "not ok - " name
      for (i = count > shown ? count - shown : 0; i < count; ++i) print "  " line[i]
      fails = 0
    }
    !/^[ \t]*<\/?(failure|properties|property|system-err)/ && NF {line[count++] = $0}' "$1" |
    sed 's/<[/]*system-out>//; s/&lt;/</g; s/&gt;/>/g; s/&quot;/"/g; s/&amp;/\&/g'
}

names_of_failed_in_junit() {
  sed -n 's/^.*<testcase name="\([^"]*\)".* status="fail".*$/\1/p' "$1"
}

# The name of each failed test and the beginning of its message, without tests that failed because of nested ones.
names_of_failed_in_tap() {
  failed_in_tap "$1" | awk '
    /^ *not ok / {sub(/^ *not ok [0-9]* - /, ""); name = $0}
    /^ *error:/ {follows = /\|-$/; if (!follows) {sub(/^ *error: */, ""); print name ": " $0}; next}
    follows {sub(/^ */, ""); print name ": " $0; follows = 0}' | cut -c "1-$shown_name_characters"
}

# Each failed test with its message, except for those that failed only because of nested tests.
failed_in_tap() {
  awk '
    /^ *not ok / {block = ""; inside = 1}
    inside {block = block $0 "\n"}
    inside && /^ *\.\.\.$/ {inside = 0; if (block !~ /subtestsFailed/) printf "%s", block}' "$1"
}

# suite NAME KIND REPORT COMMAND...: KIND is junit or tap. An empty REPORT means that the suite prints its report.
suite() {
  local name=$1 kind=$2 report=$3
  shift 3
  run_step "$name" "$@"
  count_suite "$kind" "$report"
}

# The files that have a failed test, each once. Node names a test's place as file:line:column.
files_of_failed_in_tap() {
  awk '
    /^ *not ok / {inside = 1}
    inside && /^ *location: / {print}
    /^ *\.\.\.$/ {inside = 0}' "$1" | sed -E "s/^ *location: '(.*):[0-9]+:[0-9]+'$/\1/" | sort -u
}

# end_timed_suite NAME COMMAND...: the same for a TAP suite that was begun with begin_step, and whose tests measure times
# while the steps beside it keep the machine busy. COMMAND FILE... runs the files with a failed test once more, alone.
end_timed_suite() {
  await_step
  count_timed_suite "$@"
}

# timed_suite NAME COMMAND FILE...: the same for TAP tests that keep the machine busy themselves, as browsers do that draw
# without a graphics card. COMMAND FILE... runs files.
timed_suite() {
  run_step "$@"
  count_timed_suite "$1" "$2"
}

# count_timed_suite NAME COMMAND...: if tests of the suite that has just ended failed, COMMAND FILE... runs their files
# once more. That run counts, and the summary names the tests that passed only then.
count_timed_suite() {
  local name=$1 first=() second=() files=() lines=() all_skipped=()
  shift
  if ((step_status != 0)); then mapfile -t files < <(files_of_failed_in_tap "$step_log"); fi
  if ((${#files[@]} == 0)); then
    count_suite tap ""
    return
  fi
  read -r -a first < <(read_tap "$step_log")
  mapfile -t lines < <(skipped_in_tap "$step_log")
  all_skipped=("${skipped_tests[@]}" "${lines[@]}")  # those of the files that run again are among them
  mapfile -t lines < <(names_of_failed_in_tap "$step_log")
  say "${first[1]} failed on a busy machine; their files are run again"
  step_count=$((step_count + 1))
  run_step "$name alone" "$@" "${files[@]}"
  read -r -a second < <(read_tap "$step_log") || second=(0 0 0)
  # What ran twice counts as it did alone.
  passed=$((passed + first[0] + first[1] - second[0] - second[1]))
  skipped=$((skipped + first[2] - second[2]))
  if ((step_status == 0)); then repeated_tests+=("${lines[@]}"); fi
  count_suite tap ""
  skipped_tests=("${all_skipped[@]}")
}

# Adds up the report of the suite that has just ended.
# A suite that fails without a failed test of its own (it crashed, or never began) counts as one failure.
count_suite() {
  local kind=$1 report=${2:-$step_log} counts=() lines=() why
  if [[ -f $report ]]; then
    read -r -a counts < <("read_$kind" "$report") || true
    mapfile -t lines < <("skipped_in_$kind" "$report")
    skipped_tests+=("${lines[@]}")
  fi
  ((${#counts[@]} == 3)) || counts=(0 0 0)
  if ((step_status != 0 && counts[1] == 0)); then counts[1]=1; fi
  say "${counts[0]} passed, ${counts[1]} failed, ${counts[2]} skipped"
  if ((counts[1] > 0)); then
    why=$("failed_in_$kind" "$report" 2>/dev/null | head -n "$shown_failure_lines")
    if [[ -n $why ]]; then sed 's/^/  | /' <<<"$why" >&2; else show_end_of_log; fi
    say "the whole log: ${step_log#"$root"/}"
    mapfile -t lines < <("names_of_failed_in_$kind" "$report" 2>/dev/null)
    ((${#lines[@]} > 0)) || lines=("a whole suite: ${step_log#"$root"/}")
    failed_tests+=("${lines[@]}")
  fi
  passed=$((passed + counts[0]))
  failed=$((failed + counts[1]))
  skipped=$((skipped + counts[2]))
}

# What was skipped and what failed: right before the sum, for readers of a log of which only the end is kept.
list_tests() {
  if ((${#skipped_tests[@]} > 0)); then
    printf '\nskipped:\n'
    printf '  %s\n' "${skipped_tests[@]}"
  fi
  if ((${#repeated_tests[@]} > 0)); then
    printf '\npassed only when they ran alone:\n'
    printf '  %s\n' "${repeated_tests[@]}"
  fi
  if ((${#failed_tests[@]} > 0)); then
    printf '\nfailed:\n'
    printf '  %s\n' "${failed_tests[@]}"
  fi
}

# The last line is read by machines: "N passed, N failed, N skipped".
sum_up() {
  list_tests
  printf '\n%d passed, %d failed, %d skipped\n' "$passed" "$failed" "$skipped"
  ((passed > 0 && failed == 0))
}
