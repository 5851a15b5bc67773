"""Completion of bash and of zsh: commands, options, and what they take (decks, folders, files, few words)."""

DECKS, FOLDERS, FILES, NOTHING = "decks", "folders", "files", "nothing"
KINDS = {"DECK": DECKS, "DIR": FOLDERS, "FOLDER": FOLDERS, "FILE": FILES, "FILE|DIR": FILES}
WORDS = ("help", "version")  # besides the commands


def kind_of(option):
    """What the value of an option, or a positional, is."""
    value = option.value.split()[0].strip("[]") if option.value else ""
    return KINDS.get(value, FOLDERS if value.startswith("DIR") else NOTHING)


def write_bash(program, commands):
    names = " ".join([command.name for command in commands] + list(WORDS))
    lines = [_BASH_HEAD, "_percuss() {",
             '  local current=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD - 1]}',
             "  local command='' word options='' values=nothing", "  COMPREPLY=()",
             '  for word in "${COMP_WORDS[@]:1:COMP_CWORD-1}"; do',
             '    if [[ $word != -* ]]; then command=$word; break; fi', "  done", "  case $command in"]
    lines += ["    '')",
              f"      _percuss_words {_quote(names + ' ' + _all_names(program))}", "      return ;;", "    help)",
              f"      _percuss_words {_quote(' '.join(command.name for command in commands))}", "      return ;;"]
    for command in commands:
        kind = kind_of(command.positionals[0]) if command.positionals else NOTHING
        lines += [f"    {command.name})",
                  f"      options={_quote(_all_names(command))} values={kind}", "      case $before in"]
        for option in command.options:
            if not option.value:
                continue
            action = (f"_percuss_words {_quote(' '.join(option.choices))}" if option.choices
                      else f"_percuss_{kind_of(option)}")
            lines.append(f"        {'|'.join(option.names)}) {action}; return ;;")
        lines += ["      esac ;;"]
    lines += ["  esac", "  if [[ $current == -* ]]; then", '    _percuss_words "$options"', "  else",
              '    "_percuss_$values"', "  fi", "}", "complete -F _percuss percuss"]
    return "\n".join(lines) + "\n"


def _all_names(command):
    return " ".join(name for option in command.options for name in option.names if name.startswith("--"))


def _quote(text):
    return "'" + text.replace("'", "'\\''") + "'"


_BASH_HEAD = """\
# Completion of percuss for bash. Made by scripts/make_manual from the help texts.

_percuss_words() {
  mapfile -t COMPREPLY < <(compgen -W "$1" -- "$current")
}
_percuss_names() { # what compgen prints are names of files
  compopt -o filenames 2>/dev/null
  mapfile -t COMPREPLY < <(sort -u)
}
_percuss_decks() {
  _percuss_names < <(compgen -f -X '!*.yaml' -- "$current"; compgen -f -X '!*.yml' -- "$current"; compgen -d -- "$current")
}
_percuss_folders() { _percuss_names < <(compgen -d -- "$current"); }
_percuss_files() { _percuss_names < <(compgen -f -- "$current"); }
_percuss_nothing() { :; }
"""

_ZSH_ACTIONS = {DECKS: '_files -g "*.(yaml|yml)"', FOLDERS: "_files -/", FILES: "_files", NOTHING: " "}


def write_zsh(program, commands):
    lines = ["#compdef percuss",
             "# Completion of percuss for zsh. Made by scripts/make_manual from the help texts.", "", "_percuss() {",
             "  local context state state_descr line", "  typeset -A opt_args", "  local -a commands", "  commands=("]
    lines += [f"    {_quote(command.name + ':' + _plain(command.summary))}" for command in commands]
    lines += ["    'help:Explain a command'", "    'version:Print the version'", "  )", "  _arguments -C \\"]
    lines += [f"    {spec} \\" for option in program.options for spec in _zsh_specs(option)]
    lines += ["    '1: :->command' \\", "    '*:: :->rest'", "  case $state in",
              "    command) _describe command commands ;;", "    rest)", "      case $words[1] in",
              "        help) _describe command commands ;;"]
    for command in commands:
        lines.append(f"        {command.name})")
        specs = [spec for option in command.options for spec in _zsh_specs(option)]
        for number, option in enumerate(command.positionals, 1):
            place = "*" if "..." in option.value or "|" in option.value or option.value == "DIR" else number
            specs.append(_quote(f"{place}:{_plain(option.value)}:{_ZSH_ACTIONS[kind_of(option)]}"))
        lines.append("          _arguments " + " \\\n            ".join(specs) + " ;;")
    lines += ["      esac ;;", "  esac", "}", "", '_percuss "$@"']
    return "\n".join(lines) + "\n"


def _plain(text):
    return text.replace("[", "(").replace("]", ")").replace(":", "\\:")


def _zsh_specs(option):
    action = f"({' '.join(option.choices)})" if option.choices else _ZSH_ACTIONS[kind_of(option)]
    value = f":{_plain(option.value)}:{action}" if option.value else ""
    return [_quote(f"*{name}[{_plain(option.text)}]{value}") for name in option.names]
