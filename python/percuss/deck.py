"""The deck of a run: its text where it can be found, and its values as a tree of dictionaries and lists."""

import os


class Deck:
    """Attributes: text (empty where only values are known), values (a tree; empty where nothing is), source (a file, or
    how it was found)."""

    def __init__(self, text="", values=None, source=""):
        self.text, self.values, self.source = text, values or {}, source

    def __bool__(self):
        return bool(self.text or self.values)

    def get(self, path, default=None):
        """A value by its path, such as 'time.end' or 'initial.0.velocity'."""
        found = self.values
        for word in path.split("."):
            try:
                found = found[int(word)] if isinstance(found, list) else found[word]
            except (KeyError, IndexError, TypeError, ValueError):
                return default
        return found


def find_deck(folder, given=None):
    """The deck that is given; else DIR/run_deck.yaml, which a run leaves; else the values of the checkpoint, which leave
    out title, units and output."""
    if given:
        return read_deck(given)
    beside = os.path.join(folder, "run_deck.yaml")
    if os.path.exists(beside):
        return read_deck(beside, _read_settings(beside))
    return _read_checkpoint(os.path.join(folder, "checkpoint.h5"))


def _read_settings(path):
    """What --set changed: comments at the head of the file."""
    settings = []
    with open(path, encoding="utf-8", errors="replace") as file:
        for line in file:
            if not line.startswith("# "):
                break
            if line.startswith("# --set ") and "=" in line:
                settings.append(line[len("# --set "):].strip().split("=", 1))
    return settings


def read_deck(path, settings=()):
    """A deck with values changed as by --set. Without Python's yaml it has its text alone."""
    with open(path, encoding="utf-8", errors="replace") as file:
        text = file.read()
    try:
        import yaml
    except ImportError:
        return Deck(text, {}, path)
    try:
        values = yaml.load(text, _make_loader(yaml))
        for key, value in settings:
            _set_value(values, key.split("."), yaml.load(value, _make_loader(yaml)))
    except (yaml.YAMLError, LookupError, TypeError, ValueError):
        values = {}
    return Deck(text, values if isinstance(values, dict) else {}, path)


def _make_loader(yaml):
    """YAML's own loader takes 1e-3 for a text and 'on' for a truth; percuss does not."""
    import re

    class Loader(yaml.SafeLoader):
        pass

    kept = {first: [(tag, pattern) for tag, pattern in resolvers if tag.endswith(("null", "int", "merge"))]
            for first, resolvers in yaml.SafeLoader.yaml_implicit_resolvers.items()}
    Loader.yaml_implicit_resolvers = kept
    Loader.add_implicit_resolver("tag:yaml.org,2002:bool", re.compile("true|false"), list("tf"))
    Loader.add_implicit_resolver(
        "tag:yaml.org,2002:float", re.compile(r"[-+]?(\d+\.?\d*|\.\d+)([eE][-+]?\d+)?$"), list("-+.0123456789"))
    return Loader


def _set_value(values, path, value):
    for word in path[:-1]:
        values = values[int(word)] if isinstance(values, list) else values.setdefault(word, {})
    values[int(path[-1]) if isinstance(values, list) else path[-1]] = value


def _read_checkpoint(path):
    if not os.path.exists(path):
        return Deck()
    try:
        import h5py

        with h5py.File(path, "r") as file:
            text = bytes(file["percuss_checkpoint/deck"][:]).decode("utf-8", "replace")
    except (ImportError, OSError, KeyError):
        return Deck()
    tree = {}
    for line in text.splitlines():
        key, _, value = line.partition(" = ")
        place, words = tree, key.split(".")
        for word in words[:-1]:
            place = place.setdefault(word, {})
        place[words[-1]] = _read_scalar(value)
    return Deck("", _make_lists(tree), path + " (values only, without title, units, output and audit)")


def _read_scalar(text):
    for kind in (int, float):
        try:
            return kind(text)
        except ValueError:
            pass
    return {"true": True, "false": False}.get(text, text)


def _make_lists(tree):
    if not isinstance(tree, dict):
        return tree
    made = {key: _make_lists(value) for key, value in tree.items()}
    if made and all(key.isdigit() for key in made):
        return [made[key] for key in sorted(made, key=int)]
    return made
