"""The largest share of the step bound at which scenes stay bounded, by bisection."""
from runs import search_scale
from scenes import CONTACT_SCENES, FREE_SCENES, KINDS, MESH_STEP, OFF, fill, write_elements

LOW, HIGH, TOLERANCE = 0.9, 2.5, 0.02


def choose_contact(deck, contact):
    """The deck with other keys in its section `contact`;
    OFF: without contact and walls, to see the limit of the meshes alone."""
    if contact == OFF:
        return "".join(line for line in deck.splitlines(keepends=True) if not line.startswith(("contact:", "walls:")))
    return deck.replace("contact: {", f"contact: {{{contact}, ") if contact else deck


def write_scene(name, kind, contact):
    """The deck with the steps of its elements, of which the limits are shares, or with those of the mesh."""
    deck, _ = {**FREE_SCENES, **CONTACT_SCENES}[name]
    estimate, kind = ("global", next(iter(KINDS))) if kind == MESH_STEP else ("element", kind)
    text = fill(deck).replace("time: {", f"time: {{step_estimate: {estimate}, ", 1)
    return choose_contact(text + write_elements(kind), contact)


def measure_scene(tool, work, name, kind, contact=""):
    text = write_scene(name, kind, contact)
    _, noise = {**FREE_SCENES, **CONTACT_SCENES}[name]
    trials = search_scale(tool, text, work, LOW, HIGH, TOLERANCE, noise)
    if not any(t["bounded"] for t in trials):  # not even the default: how far down is it stable?
        trials += search_scale(tool, text, work, 0.05, LOW, TOLERANCE, noise)
    bounded = [t for t in trials if t["bounded"]]
    unbounded = [t for t in trials if not t["bounded"]]
    row = {"scene": name, "kind": kind, "contact": contact, "largest": max((t["scale"] for t in bounded), default=0.0),
           "is_limit": bool(unbounded), "outcome": unbounded[-1]["outcome"] if unbounded else ""}
    row["energy_error"] = min(bounded, key=lambda t: abs(t["scale"] - LOW))["energy_error"] if bounded else None
    row["steps"] = max(t["steps"] for t in trials)
    return row


def measure_blow_ups(tool, work, scenes, kinds, contacts, report):
    rows = []
    for name in scenes:
        for kind in kinds:
            for contact in contacts if name in CONTACT_SCENES else [""]:
                row = measure_scene(tool, work, name, kind, contact)
                rows.append(row)
                report(f"blow-up, {name}, {kind}{', ' + contact if contact else ''}: "
                       f"{'' if row['is_limit'] else 'at least '}{row['largest']:.2f} ({row['outcome']})")
    return rows
