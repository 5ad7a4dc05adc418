# Bash completion for wheelwright, wheelwrightd, roomba-sim and serial-faults. Source it, or install it as
# /usr/share/bash-completion/completions/wheelwright.
#
# What can be completed is what --help lists: the programs are asked, so this file knows no list of its own.

# Subcommands of a help text, one per line.
_wheelwright_commands() { awk '/^Subcommands:/ { found = 1; next } /^[^ ]/ { found = 0 } found && /^  [a-z]/ { print $1 }'; }

# Long options of a help text, one per line.
_wheelwright_options() { grep -oE -- '(^|[ ,])--[a-z][a-z-]*' | tr -d ' ,' | sort -u; }

# Words that an option takes, where its help names them: {one,two}.
_wheelwright_choices() {
  grep -E -- "(^|[ ,])$1[ ,]" | grep -oE '\{[a-z_0-9,>-]+\}' | head -n 1 | tr -d '{}' | tr ',' '\n' | sed 's/->.*//'
}

_wheelwright() {
  local program=${COMP_WORDS[0]} word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD - 1]} command='' i
  local text words
  for ((i = 1; i < COMP_CWORD; ++i)); do
    [[ ${COMP_WORDS[i]} == -* ]] && break
    [[ ${program##*/} == wheelwright ]] || break
    command+=" ${COMP_WORDS[i]}"
    [[ ${COMP_WORDS[1]} == import ]] || break
  done
  # shellcheck disable=SC2086  # the words of the command are words here
  text=$("$program" $command --help 2>/dev/null) || text=''
  COMPREPLY=()
  if [[ $before == --* ]]; then
    words=$(_wheelwright_choices "$before" <<<"$text")
    if [[ -n $words ]]; then
      mapfile -t COMPREPLY < <(compgen -W "$words" -- "$word")
      return
    fi
  fi
  if [[ $word == -* ]]; then
    mapfile -t COMPREPLY < <(compgen -W "$(_wheelwright_options <<<"$text")" -- "$word")
    return
  fi
  words=$(_wheelwright_commands <<<"$text")
  if [[ $command == ' effects' ]]; then
    words+=" $("$program" effects 2>/dev/null | awk 'NR > 1 && /^  [a-z_]+ / { print $1 }')"
  fi
  if [[ -n ${words// /} ]]; then
    mapfile -t COMPREPLY < <(compgen -W "$words" -- "$word")
    return
  fi
  mapfile -t COMPREPLY < <(compgen -f -- "$word")
}

complete -o filenames -F _wheelwright wheelwright wheelwrightd roomba-sim serial-faults
