"""The first table of the page: what a user asks about, and the errors of cases at stated meshes."""

# feature: what is compared and on which mesh, case, the quantity of the case whose error is shown. A text alone is shown as it is.
FEATURES = {
    "hexahedra": [
        ("patch test, distorted, over Young's modulus", "patch",
         "assumed strain: stress, largest error over Young's modulus"),
        ("bending frequency, 2 elements through", "free_bar", "assumed strain, 2 through, cubes: frequency"),
        ("plastic bending, 2 through", "plastic_cantilever", "assumed strain, 2 through: deflection"),
        ("foot of a Taylor bar, 3840 elements", "taylor_bar", "3840 elements: foot radius on the axis"),
        ("full integration, rubber at three times its length", "rubber_stretch", "1 driven, 4 cells an edge: force"),
    ],
    "near-incompressible": [
        ("Cook's membrane, hexahedra 16 x 16", "cooks_membrane", "assumed strain, 16 x 16: against the limit"),
        ("wedges 16 x 16", "cooks_other_solids", "wedges, 16 cells a side: deflection"),
        ("pyramids 8 x 8", "cooks_other_solids", "pyramids, 8 cells a side: deflection"),
        ("tetrahedra 8 x 8", "cooks_other_solids", "tetrahedra, 8 cells a side: deflection"),
    ],
    "thick shells": [
        ("cantilever, elements 10 times as long as thick", "thick_strip",
         "deflection of the end over that of the plate"),
        ("Scordelis-Lo roof, 16 x 16", "thick_roof", "16 x 16: fall of the edge"),
        ("limit moment, two layers", "thick_yield", "2 layers, 5 points: moment over the limit"),
    ],
    "shells": [
        ("plate frequency, 16 x 16", "shell_plate", "16 x 16: frequency"),
        ("pinched hemisphere, 16 x 16", "shell_pinched", "16 x 16, P = 200: outward"),
        ("twisted beam, 12 x 2", "shell_twisted",
         "12 x 2, thickness 0.32, force along z: displacement of a force of 1"),
        ("cap that yields, 3072 elements a quarter", "shell_cap", "deflection of the middle at 0.25 ms"),
        ("dynamic relaxation of a skew plate, 16 x 16", "relaxed_shells", "skew plate: deflection of the middle"),
    ],
    "crash": [
        ("mean force of a tube of 60 x 60 x 1.5 mm, elements of 5 mm", "shell_crushed_tubes",
         "mean force, 1.5 mm, with a trigger"),
        "[strokes of a car against a post](verification/public_models.md) of 2424 shells: 0.96 to 1.08 of LS-DYNA's",
        "[an aluminium tube](verification/public_models.md): mean force 0.87 of that of Abaqus",
    ],
    "laminates, rolled sheets": [
        ("deflection of 0, 30, -45, 90", "laminate_theory", "0, 30, -45, 90: deflection of a corner"),
        ("stress at a hole, quasi-isotropic, 32 around the quarter", "open_hole",
         "45, 0, -45, 90, 32 around: stress at the hole"),
        ("r-value at 45 degrees, exponent 8", "rolled_sheet", "Barlat and Lian, 45 degrees: r-value"),
    ],
    "membranes, fabric": [
        ("Hencky's membrane, 8 elements along the radius", "membrane_circle",
         "elastic, 8 elements along the radius: deflection"),
        ("a ball that swings, 12 elements a quarter", "membrane_sphere", "displacement after half a period"),
        ("arc of a strip, 20 elements", "membrane_strip", "pressure 100: rise"),
        ("sheared cloth", "fabric_shear", "stress xx"),
        ("wrinkled sheet in bending, 16 x 10", "fabric_bending", "end turn 4e-3: curvature, E t H^2 k / (2 P)"),
        ("round bag, 12 along the radius", "fabric_bag", "12 elements along the radius: radius"),
    ],
    "beams": [
        ("torsion of a shaft, 10 elements", "shaft_torsion", "round, 10 elements: frequency"),
        ("torque as it is stopped, 200 elements", "shaft_torsion", "torque of the shaft that is stopped"),
    ],
    "rigid bodies": [
        ("inertia, one tetrahedral cell", "rigid_shapes", "moment of inertia, tetrahedra"),
        ("precession of a top", "rigid_shapes", "rate of precession of the top"),
        ("second rebound of a cube, e = 0.6, of 6.48 mm", "restitution", "kinematic, e = 0.6: top 2"),
    ],
    "contact": [
        ("impact of bars, 200 elements each", "two_bars", "kinematic, equal: stress"),
        ("Hertz, 36 elements across", "hertz_wall", "36 across: largest force"),
        ("ball on sharp edges, height [mm] of 22.4", "sharp_edges", "edges of blocks: height of the ball"),
        "[random scenes](stability.md#depth-in-random-scenes) with an edge inside: 13 of 100",
    ],
    "friction": [
        ("distance of a sliding block", "sliding_block", "wall: distance"),
        ("creep [m] in 1 s of a block that sticks on an incline", "incline",
         "stiffness damping, sticks: creep in a second"),
        ("belt on a drum of 360 faces, damped", "capstan", "friction 0.2: force of the held end over the pull"),
        "[without damping](verification/open_points.md) both flutter",
    ],
    "ties, welds, glue": [
        ("wave through a tie, 2 x 2 on 3 x 3, share that comes back", "tied_bars",
         "kinematic, 2 x 2 on 3 x 3: stress that comes back, over rho c v"),
        ("weld of solids, strength", "solid_weld", "largest shear of the weld"),
        ("lap joint, shells of 5 mm", "lap_weld", "shells of 5.0 mm: deflection"),
        ("crack that opens, 0.5 mm", "glued_beams", "0.5 mm, 4.5 ms: energy of the crack"),
        ("that slides, 0.67 mm", "split_beam", "0.67 mm, 7.25 ms: energy of the crack at 34 mm"),
        ("shells that peel, 1 mm", "glued_shells", "double cantilever, 1 mm, 7 ms: energy of the crack"),
        ("both, 1 mm", "mixed_bending", "48 % of sliding: largest force by 25.4 mm"),
    ],
    "failure": [
        ("spall, 100 elements, time", "spall", "100 elements: time"),
        ("energy of damage, a cube of 2 mm", "softening", "cube of 2 mm, energy: energy after the onset, by area"),
        ("neck on rows of 1, 2 and 4 mm, largest over smallest", "neck_size", "largest elongation over the smallest"),
        ("plug by a blunt projectile, 303.5 m/s", "plug", "303.5 m/s: speed behind the plate"),
        "[round and pointed noses, Kalthoff and Winkler's plate](verification/open_points.md): not judged",
    ],
    "metals": [
        ("Johnson-Cook foot of a Taylor bar, 3840 elements", "johnson_cook",
         "foot diameter, against the middle of the range"),
        ("table of rates at 10 / s", "rate_table", "hexahedra, 10 / s, logarithmic"),
        ("Chaboche, the tenth loop", "cyclic_metals", "Chaboche, hexahedra, hardens: largest stress of the tenth loop"),
        ("Gurson, void fraction", "cyclic_metals", "Gurson, hexahedra: void fraction"),
    ],
    "rubber": [
        ("Ogden, two directions to 3", "rubber_laws", "ogden: two directions to 3"),
        ("curve of a test, pure shear to 2.4", "rubber_laws", "tabulated_rubber: pure shear to 2.4"),
    ],
    "laws of users": [
        ("VUMAT against the built-in law, energy", "user_laws", "VUMAT: internal energy"),
        ("VUHARD, foot of a Taylor bar", "user_laws", "VUHARD: radius of the foot"),
        ("VUSDFLD, stress before the deletion", "user_laws", "VUSDFLD: stress before the deletion"),
        ("C++, Gent in tension to 5", "user_laws", "C++, Gent: tension to 5"),
    ],
    "waves, shocks": [
        ("front in a slender bar, 200 x 2 x 2", "bar_waves", "slender: speed of the front"),
        ("shock in copper, 1000 m/s, 200 elements a plate", "flyer_plates", "copper at 1000 m/s: speed of the shock"),
    ],
    "energy": [("balance of a brick wall, 8400 elements", "brick_wall", "energy balance, largest error")],
}


def find_error(result, quantity):
    """The error of a check; where it has a bound alone, the measured value."""
    for check in result["checks"] if result else []:
        if check["quantity"] == quantity:
            return check["error"] or f"{check['measured']:.3g}"
    return "not run" if result is None else "?"


def list_features(cases, results, make_link):
    """Rows of the table. A case that is no longer there is an error. make_link(case, text)."""
    known = {case.name: case for case in cases}

    def show(entry):
        if isinstance(entry, str):
            return entry
        what, name, quantity = entry
        return f"{make_link(known[name], what)}: {find_error(results.get(name), quantity)}"

    return [[feature, "; ".join(map(show, entries))] for feature, entries in FEATURES.items()]
