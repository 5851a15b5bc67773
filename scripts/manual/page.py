"""The manual page, in the language of man(7)."""

HEADINGS = {"Exit codes": "EXIT STATUS", "Environment": "ENVIRONMENT", "Examples": "EXAMPLES"}
DESCRIPTION = """\
A deck in YAML describes a scene. run computes it and writes its results into a folder; plot, report, watch and render show
them, stop ends an active run. The documentation lies in share/percuss/docs of the installation; README.md there names its pages."""


def write_page(version, program, commands):
    lines = [f'.TH PERCUSS 1 "" "percuss {version}" "User Commands"', ".nh", ".ad l", ".SH NAME",
             "percuss \\- explicit impact dynamics of solids and shells, with contact", ".SH SYNOPSIS"]
    for command in commands:
        words = "".join(f" \\fI{_escape(option.value)}\\fR" for option in command.positionals)
        lines += [f"\\fBpercuss {command.name}\\fR [\\fIoption\\fR ...]{words}", ".br"]
    lines += [".SH DESCRIPTION", *_fill(DESCRIPTION), ".SH OPTIONS", *_list(program.options), ".SH COMMANDS"]
    for command in commands:
        lines += [f".SS percuss {command.name}", _escape(command.summary) + "."]
        lines += _list(command.positionals) + _list(command.options)
        lines += _write_footer(command.footer, {}, without=(command.summary,))
    lines += _write_footer(program.footer.partition("\n\n")[2], HEADINGS)  # without what percuss is
    lines += [".SH SEE ALSO", "The pages in docs, of which deck.md describes every key of a deck."]
    return "\n".join(lines) + "\n"


def _escape(text):
    text = text.replace("\\", "\\e").replace("-", "\\-").replace("`", "\\(ga").replace("'", "\\(aq").replace("^",
                                                                                                             "\\(ha")
    return "\\&" + text if text.startswith(".") else text


def _fill(text):
    return [_escape(line.strip()) for line in text.splitlines()]


def _list(options):
    lines = []
    for option in options:
        value = "{" + ",".join(option.choices) + "}" if option.choices else option.value
        names = ", ".join(f"\\fB{_escape(name)}\\fR" for name in option.names)
        lines += [".TP",
                  f"{names} \\fI{_escape(value)}\\fR" if names and value else names or f"\\fI{_escape(value)}\\fR"]
        lines.append(_escape(option.text) or ".br")
    return lines


def _write_footer(text, headings, without=()):
    """Lines that are indented stay as they are; others are filled."""
    lines, is_kept = [], False
    for line in text.splitlines():
        if line.strip() in without:
            continue
        keeps = line.startswith(" ")
        if keeps != is_kept and line.strip():
            lines.append(".nf" if keeps else ".fi")
            is_kept = keeps
        heading = headings.get(line.rstrip(":")) if line.endswith(":") else None
        if heading:
            lines += [f".SH {heading}"]
        elif not line.strip():
            lines.append(".PP" if not is_kept else "")
        else:
            lines.append(_escape(line))
    return lines + [".fi"] * is_kept
