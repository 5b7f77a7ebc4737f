# SPDX-License-Identifier: Apache-2.0
# bash completion for roomcast: commands, options and an option's values are those that the program's own help lists.
_roomcast() {
  local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD - 1]} help subcommands values
  local -a commands=()
  ((COMP_CWORD < 2)) || commands=("${COMP_WORDS[1]}")
  # `bench` and the like have commands of their own.
  if ((COMP_CWORD > 2)) && [[ ${COMP_WORDS[2]} != -* ]] && _roomcast_subcommands "$(_roomcast_help "${commands[@]}")" | grep -qxF -- "${COMP_WORDS[2]}"; then
    commands+=("${COMP_WORDS[2]}")
  fi
  help=$(_roomcast_help "${commands[@]}")
  if [[ $word == -* ]]; then
    mapfile -t COMPREPLY < <(compgen -W "$(grep -oE -- '--[a-z][a-z-]*' <<<"$help" | sort -u)" -- "$word")
    return
  fi
  subcommands=$(_roomcast_subcommands "$help")
  values=$([[ $before != --* ]] || _roomcast_values "$before" "$help")
  if ((COMP_CWORD == ${#commands[@]} + 1)) && [[ -n $subcommands ]]; then
    mapfile -t COMPREPLY < <(compgen -W "$subcommands" -- "$word")
  elif [[ -n $values ]]; then
    mapfile -t COMPREPLY < <(compgen -W "$values" -- "$word")
  else
    mapfile -t COMPREPLY < <(compgen -f -- "$word")
    compopt -o filenames 2>/dev/null
  fi
}

_roomcast_help() {
  roomcast "$@" --help 2>/dev/null
}

_roomcast_subcommands() {
  awk '/^Subcommands:/ {inside = 1; next} !NF {inside = 0} inside && /^  [a-z]/ {print $1}' <<<"$1"
}

# The values of an option that help names: `--format TEXT:{ply,pcd}=ply` or `--mode points|mesh`.
_roomcast_values() {
  awk -v option="$1" '$1 ~ "^(.*,)?" option "(,|$)" {print $2; exit}' <<<"$2" |
    sed -nE -e 's/.*\{(.*)\}.*/\1/p' -e '/^[a-z]+\|/p' | tr ',|' '  '
}

complete -F _roomcast roomcast
