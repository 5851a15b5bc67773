"""Values of keys, drawn from the schema of decks (percuss schema)."""

from .shapes import rounded

# Keys with a unit, by which a body of the scenes stays what it is.
VALUES = {
    "time.step_scale": [0.5, 0.9], "time.max_step": [1e-6, 2.5e-6], "elements.stiffness_damping": [1e-7, 1e-6],
    "elements.bulk_viscosity.linear": [0, 0.06, 0.3], "elements.bulk_viscosity.quadratic": [0, 1.2],
    "contact.friction": [0, 0.2, 0.5], "contact.penalty_scale": [0.2, 1], "contact.tolerance": [1e-6, 1e-3, 1e-2],
    "contact.ties.N.cohesive.exponent": [1, 2], "contact.ties.N.cohesive.shear_stiffness": [1e12],
    "start.relaxation.damping": [1e3, 1e5], "start.relaxation.ramp": [0, 5], "start.relaxation.max_steps": [1, 30, 80],
    "parts.NAME.stiffness_damping": [1e-7, 1e-6], "parts.NAME.points": [1, 3, 5],
}
# Drawn by the scene itself, names of other things, or without effect on a run.
LEFT_OUT = {
    "time.end", "time.max_steps", "time.until", "time.mass_scaling", "time.collapse_ratio", "contact.surfaces",
    "contact.ties", "start.relaxation.hold", "start.relaxation.unsettled", "start.relaxation.tolerance",
    "contact.friction.pairs", "contact.overlap", "elements.integration", "audit.max_energy_error",
    "audit.max_contact_gain",
}
OF_PARTS = ("hourglass", "bulk_viscosity", "stiffness_damping", "shell_hourglass", "points", "reference")


def find_node(schema, path):
    """The schema of what stands at a path as the documentation writes it, with NAME and N."""
    node = schema
    for word in path.split("."):
        node = _as_map(node) if word not in ("NAME", "N") else node
        if word == "NAME":
            node = next(iter(node["patternProperties"].values()))
        elif word == "N":
            node = _choose(node, "items")["items"]
        else:
            node = node["properties"][word]
    return node


def _choose(node, key):
    return node if key in node else next(one for one in node.get("anyOf", []) if key in one)


def _as_map(node):
    return _choose(node, "properties") if "patternProperties" not in node else node


def draw_keys(schema, path, random, share):
    """Some of the keys of a map that need no other, each with this chance."""
    drawn = {}
    for key, node in _as_map(find_node(schema, path))["properties"].items():
        full = f"{path}.{key}"
        wanted = random.random() < share
        if not wanted or full in LEFT_OUT or (path == "parts.NAME" and key not in OF_PARTS):
            continue
        value = draw_value(node, full, random)
        if value is not None:
            drawn[key] = value
    return drawn


def draw_value(node, path, random):
    """None: not one that can be drawn without knowing the scene."""
    if path in VALUES:
        return random.choice(VALUES[path])
    if "anyOf" in node:
        return draw_value(random.choice(node["anyOf"]), path, random)
    if "enum" in node:
        return random.choice(node["enum"])
    kind = node.get("type")
    if kind == "boolean":
        return random.random() < 0.5
    if kind in ("number", "integer"):
        return _draw_number(node, kind, random)
    if kind != "object" or "properties" not in node or "allOf" in node:
        return None
    drawn = {key: draw_value(inner, f"{path}.{key}", random) for key, inner in node["properties"].items()
             if key in node.get("required", []) or random.random() < 0.5}
    return None if not drawn or any(value is None for value in drawn.values()) else drawn


def _draw_number(node, kind, random):
    low, high = (next((node[key] for key in keys if key in node), None)
                 for keys in (("minimum", "exclusiveMinimum"), ("maximum", "exclusiveMaximum")))
    if low is None or high is None:
        return None
    inside = 0.01 * (high - low)
    return random.randint(low, high) if kind == "integer" else rounded(random.uniform(low + inside, high - inside))
