#!/bin/bash
# SPDX-License-Identifier: Apache-2.0
# Man pages from the program's own help: roomcast.1 and one for each command.  man_pages.sh PROGRAM FOLDER
set -euo pipefail
program=$1
folder=$2
mkdir -p "$folder"
version=$("$program" --version | cut -d " " -f 2)

# roff takes a backslash, a leading dot or apostrophe, and a bare minus otherwise than they are meant.
as_roff() { sed -e 's/\\/\\e/g' -e 's/-/\\-/g' -e "s/^\([.']\)/\\\\\&\1/"; }

# page NAME SUMMARY COMMAND...
page() {
  local name=$1 summary=$2
  shift 2
  {
    printf '.TH %s 1 "" "roomcast %s" "User Commands"\n' "${name^^}" "$version"
    printf '.SH NAME\n%s \\- %s\n' "$name" "$(as_roff <<<"$summary")"
    printf '.SH SYNOPSIS\n.nf\n%s\n.fi\n.SH DESCRIPTION\n.nf\n' "$*"
    "$program" "${@:2}" --help | fold -s -w 100 | as_roff
    printf '.fi\n'
  } | gzip -9n >"$folder/$name.1.gz"
}

commands=$("$program" --help | awk '/^Subcommands:/ {inside = 1; next} !NF {inside = 0} inside {print $1}')
page roomcast "be in a room that is somewhere else" roomcast
for command in $commands; do
  summary=$("$program" --help | awk -v c="$command" '/^Subcommands:/ {inside = 1} inside && $1 == c {$1 = ""; print substr($0, 2); exit}')
  page "roomcast-$command" "$summary" roomcast "$command"
done
