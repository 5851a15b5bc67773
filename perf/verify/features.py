"""The first table of the page: what a user asks about, and the error of a case at a stated mesh."""

# feature, what is compared and on which mesh, case, the quantity of the case whose error is shown
FEATURES = [
    ("solids: patch test", "stress of distorted meshes, over Young's modulus", "patch", "assumed strain: stress, largest error over Young's modulus"),
    ("solids: bending", "frequency, 2 elements through", "free_bar", "assumed strain, 2 through, cubes: frequency"),
    ("solids: plastic bending", "deflection, 2 elements through", "plastic_cantilever", "assumed strain, 2 through: deflection"),
    ("solids: large plastic flow", "foot radius of a Taylor bar, 3840 elements", "taylor_bar", "3840 elements: foot radius on the axis"),
    ("near-incompressible", "Cook's membrane, 16 x 16", "cooks_membrane", "assumed strain, 16 x 16: against the limit"),
    ("tetrahedra", "Cook's membrane, 8 x 8", "cooks_other_solids", "tetrahedra, 8 cells a side: deflection"),
    ("wedges", "Cook's membrane, 8 x 8", "cooks_other_solids", "wedges, 8 cells a side: deflection"),
    ("rubber", "force at three times the length, 4 elements an edge", "rubber_stretch", "1 driven, 4 cells an edge: force"),
    ("shells: bending", "frequency of a plate, 16 x 16", "shell_plate", "16 x 16: frequency"),
    ("shells: curved, large rotation", "pinched hemisphere, 16 x 16", "shell_pinched", "16 x 16, P = 200: outward"),
    ("shells: warped", "twisted beam, 12 x 2", "shell_twisted", "12 x 2, thickness 0.32, force along z: displacement of a force of 1"),
    ("shells: plastic flow", "deflection of a cap, 3072 elements a quarter", "shell_cap", "deflection of the middle at 0.25 ms"),
    ("shells: crushing", "mean force of a tube of 60 x 60 x 1.5 mm, elements of 5 mm", "shell_crushed_tubes", "mean force, 1.5 mm, with a trigger"),
    ("laminates", "deflection under a force in the plane, 0, 30, -45, 90", "laminate_theory", "0, 30, -45, 90: deflection of a corner"),
    ("rolled sheets", "r-value at 45 degrees, exponent 8, one shell", "rolled_sheet", "Barlat and Lian, 45 degrees: r-value"),
    ("beams", "frequency of a shaft in torsion, 10 elements", "shaft_torsion", "round, 10 elements: frequency"),
    ("rigid bodies", "precession of a top", "rigid_shapes", "rate of precession of the top"),
    ("contact: impact of bars", "stress, equal bars of 200 elements", "two_bars", "kinematic, equal: stress"),
    ("contact: curved bodies", "Hertz, largest force, 36 elements across", "hertz_wall", "36 across: largest force"),
    ("friction: sliding", "distance of a block on a wall", "sliding_block", "wall: distance"),
    ("friction: belt", "force of the held end, mu = 0.2, drum of 360 faces", "capstan", "friction 0.2: force of the held end over the pull"),
    ("ties", "reflected share of a wave, 2 x 2 on 3 x 3", "tied_bars", "kinematic, 2 x 2 on 3 x 3: stress that comes back, over rho c v"),
    ("welds", "deflection of a lap joint, shells of 5 mm", "lap_weld", "shells of 5.0 mm: deflection"),
    ("failure: spall", "time of failure, 100 elements", "spall", "100 elements: time"),
    ("failure: damage that evolves", "energy by area, a cube of 2 mm", "softening", "cube of 2 mm, energy: energy after the onset, by area"),
    ("glue", "energy of a crack, elements of 0.5 mm", "glued_beams", "0.5 mm, 4.5 ms: energy of the crack"),
    ("failure: perforation", "speed behind the plate, 303.5 m/s before", "plug", "303.5 m/s: speed behind the plate"),
    ("materials: Johnson-Cook", "foot diameter of a Taylor bar, 3840 elements", "johnson_cook", "foot diameter, against the middle of the range"),
    ("materials: strain rates", "stress at 10 / s, between two curves, one element", "rate_table", "hexahedra, 10 / s, logarithmic"),
    ("waves", "speed of the front in a slender bar, 200 x 2 x 2", "bar_waves", "slender: speed of the front"),
    ("shocks", "speed of the shock in copper, 1000 m/s, 200 elements a plate", "flyer_plates", "copper at 1000 m/s: speed of the shock"),
    ("relaxation", "deflection of a skew plate, 16 x 16 shells", "relaxed_shells", "skew plate: deflection of the middle"),
    ("momentum and energy", "energy balance of a brick wall, 8400 elements", "brick_wall", "energy balance, largest error"),
]


def find_error(result, quantity):
    """The error of a check; where it has a bound alone, the measured value."""
    for check in result["checks"] if result else []:
        if check["quantity"] == quantity:
            return check["error"] or f"{check['measured']:.2g}"
    return "not run" if result is None else "?"


def list_features(cases, results, make_link):
    """Rows of the table. A case that is no longer there is an error."""
    known = {case.name: case for case in cases}
    return [[feature, what, find_error(results.get(name), quantity), make_link(known[name])] for feature, what, name, quantity in FEATURES]
