# SPDX-License-Identifier: Apache-2.0
# bash completion for roomcast: commands and options are those that the program's own help lists.
_roomcast() {
  local word=${COMP_WORDS[COMP_CWORD]} command=${COMP_WORDS[1]}
  if ((COMP_CWORD == 1)); then
    local commands
    commands=$(roomcast --help 2>/dev/null | awk '/^Subcommands:/ {inside = 1; next} !NF {inside = 0} inside {print $1}')
    mapfile -t COMPREPLY < <(compgen -W "$commands --help --version" -- "$word")
  elif [[ $word == -* ]]; then
    local options
    options=$(roomcast "$command" --help 2>/dev/null | grep -oE -- '--[a-z][a-z-]*' | sort -u)
    mapfile -t COMPREPLY < <(compgen -W "$options" -- "$word")
  else
    mapfile -t COMPREPLY < <(compgen -f -- "$word")
    compopt -o filenames 2>/dev/null
  fi
}
complete -F _roomcast roomcast
