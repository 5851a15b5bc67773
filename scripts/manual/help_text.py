"""Reads help texts: those of CLI11 (the program's commands) and of argparse (the tools)."""

import re
from dataclasses import dataclass, field

LISTS = {"options": "options", "optional arguments": "options", "positionals": "positionals",
         "positional arguments": "positionals"}
# Two spaces or more stand between an option and its text; an option that is long has its text in the next line.
ENTRY = re.compile(r"  (\S.*?)(?:\s{2,}(\S.*))?$")


@dataclass
class Option:
    """names: -o, --out; a positional has none. value: FILE, or empty; choices: what it may be, if there are few."""
    names: list
    value: str
    text: str
    choices: list = field(default_factory=list)


@dataclass
class Command:
    """name empty: the program itself. usage without 'usage:'; summary in a sentence; footer: what follows the lists."""
    name: str
    summary: str = ""
    usage: str = ""
    options: list = field(default_factory=list)
    positionals: list = field(default_factory=list)
    footer: str = ""
    commands: list = field(default_factory=list)  # (name, summary) of the program


def read_commands(general, ask_for):
    """The program and its commands. general: percuss --help; ask_for(name): the help of a command."""
    program = read_help("", general)
    commands = []
    for name, summary in program.commands:
        command = read_help(name, ask_for(name))
        command.summary = summary
        commands.append(command)
    return program, commands


def read_help(name, text):
    command = Command(name)
    state, last, rest, usage = "", None, [], []
    for line in text.splitlines():
        heading = LISTS.get(line.rstrip(":").lower()) if line.endswith(":") else None
        if heading:
            state, last = heading, None
        elif name == "" and line in ("Commands:", "Results:"):
            state, last = "commands", None
        elif line.lower().startswith("usage:"):
            state = "usage"
            usage.append(line[6:].strip())
        elif state == "usage" and line.startswith(" "):
            usage.append(line.strip())
        elif not line.strip():
            rest.append("")
            state, last = "", None
        elif state in ("options", "positionals", "commands") and line.startswith("  "):
            last = _read_entry(command, state, line, last)
        else:
            state = ""
            rest.append(line)
    command.usage = " ".join(usage)
    command.footer = "\n".join(rest).strip("\n")
    return command


def _read_entry(command, state, line, last):
    """An entry of a list, or the next line of the text of the last one, which it is given back."""
    entry = ENTRY.match(line) if not line.startswith("    ") else None
    if not entry:
        if last is not None:
            last.text = f"{last.text} {line.strip()}".strip()
        return last
    words, text = entry[1], entry[2] or ""
    if state == "commands":
        command.commands.append((words, text))
        return None
    option = _read_option(words, text) if state == "options" else Option([], words.replace(" REQUIRED", ""), text)
    getattr(command, state).append(option)
    return option


def _read_option(words, text):
    """'-o,--out DIR', '-s,--set KEY=VALUE ...', '--out FILE, -o FILE', '--edges {auto,on,off}'."""
    names = re.findall(r"(?<![\w-])--?[A-Za-z][\w-]*", words)
    rest = re.sub(r"(?<![\w-])--?[A-Za-z][\w-]*,?", " ", words)
    value = next((word.rstrip(", ") for word in rest.split() if word not in ("...", "REQUIRED")), "")
    choices = value[1:-1].split(",") if value.startswith("{") else []
    return Option(names, "WHICH" if choices else value, text, choices)
