"""The largest share of the step bound at which scenes stay bounded, by bisection."""
from runs import search_scale
from scenes import CONTACT_SCENES, FREE_SCENES, OFF, fill, write_elements

LOW, HIGH, TOLERANCE = 0.9, 2.5, 0.02


def choose_contact(deck, contact):
    """The deck with other keys in its section `contact`; OFF: without contact and walls, to see the limit of the meshes alone."""
    if contact == OFF:
        return "".join(line for line in deck.splitlines(keepends=True) if not line.startswith(("contact:", "walls:")))
    return deck.replace("contact: {", f"contact: {{{contact}, ") if contact else deck


def measure_scene(tool, work, name, kind, contact=""):
    deck, noise = {**FREE_SCENES, **CONTACT_SCENES}[name]
    text = choose_contact(fill(deck) + write_elements(kind), contact)
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
