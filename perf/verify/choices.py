"""The choices of elements and of contact enforcement that this percuss has, as decks name them."""

PROBE = """
time: {end: 1}
parts: {a: {box: {size: [1, 1, 1], cells: [1, 1, 1]}, material: m}}
materials: {m: {model: elastic, density: 1, youngs_modulus: 1, poissons_ratio: 0}}
$choice
"""

# Name in the tables; what `elements: {...}` says, the first form that is known.
ELEMENTS = {
    "assumed strain": ["hourglass: assumed_strain", "hourglass: {kind: assumed_strain}"],
    "stiffness": ["hourglass: stiffness", "hourglass: {kind: stiffness}"],
    "viscous": ["hourglass: viscous", "hourglass: {kind: viscous}"],
    "full": ["integration: full"],
}
ENFORCEMENTS = ["kinematic", "lagrange", "penalty"]


def list_elements(bench):
    """What `elements: {...}` says, by name, of every choice that is known."""
    known = {}
    for name, forms in ELEMENTS.items():
        for form in forms:
            if bench.accepts(PROBE, choice="elements: {" + form + "}"):
                known[name] = form
                break
    return known


def list_enforcements(bench):
    """What `contact: {...}` says besides, by name, of every choice that is known."""
    known = {name: f", enforcement: {name}" for name in ENFORCEMENTS
             if bench.accepts(PROBE, choice=f"contact: {{surfaces: all, enforcement: {name}}}")}
    return known or {"kinematic": ""}
