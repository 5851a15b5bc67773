"""Measured points as tables of Markdown."""
from forecast import forecast
from measure import CONTACT_PHASES, FE_PHASES

SCENE_NAMES = {"brick_wall": "Brick wall", "can_crush": "Can crush"}
MODE_NAMES = {"every_step": "search and rebalance in every step", "when_due": "search and rebalance when due"}
FORECAST_RANKS = [1, 2, 4, 8, 16, 32, 64, 128, 256, 512, 1024, 2048, 4096]


def make_table(heading, rows):
    lines = ["| " + " | ".join(heading) + " |", "|" + "---|" * len(heading)]
    lines += ["| " + " | ".join(row) + " |" for row in rows]
    return "\n".join(lines) + "\n"


def sum_of_work(point):
    return point["ranks"] * (point["fe_us_mean"] + point["contact_us_mean"])


def tabulate_work(points):
    """Work a rank and step; for problems of one size the sum over ranks, for scaled ones the work of a rank, against 1."""
    fixed = points[0]["kind"] == "fixed"
    heading = ["ranks", "elements", "FE: mean, max [us]", "contact: mean, max [us]",
               "sum of work / that of one rank" if fixed else "work of a rank / that of one: FE, contact, both",
               "imbalance: elements, contact"]
    rows = []
    for p in points:
        one = points[0]
        if fixed:
            ratio = f"{sum_of_work(p) / sum_of_work(one):.2f}"
        else:
            both = (p["fe_us_mean"] + p["contact_us_mean"]) / (one["fe_us_mean"] + one["contact_us_mean"])
            ratio = (f"{p['fe_us_mean'] / one['fe_us_mean']:.2f}, {p['contact_us_mean'] / one['contact_us_mean']:.2f}, "
                     f"{both:.2f}")
        rows.append([str(int(p["ranks"])), str(int(p["elements"])), f"{p['fe_us_mean']:.0f}, {p['fe_us_max']:.0f}",
                     f"{p['contact_us_mean']:.0f}, {p['contact_us_max']:.0f}", ratio,
                     f"{p['element_imbalance']:.3f}, {p['contact_imbalance']:.3f}"])
    return make_table(heading, rows)


def tabulate_phases(points):
    """Mean work of a rank and step by phase, and for the contact phases a point of the rank."""
    heading = ["ranks"] + [phase.replace("_", " ") for phase in FE_PHASES + CONTACT_PHASES]
    heading += ["contact points a rank", "contact work [ns] a point"]
    rows = []
    for p in points:
        own = p["contact_points"] / p["ranks"]
        rows.append([str(int(p["ranks"]))] + [f"{p[phase + '_us']:.0f}" for phase in FE_PHASES + CONTACT_PHASES] +
                    [f"{own:.0f}", f"{1e3 * p['contact_us_mean'] / own:.0f}"])
    return make_table(heading, rows)


def tabulate_messages(points):
    counted = "mpi_hops" in points[-1]
    heading = ["ranks", "halo: messages, kB", "contact: messages, kB", "ghost faces / faces", "searches a step",
               "rounds a cut"] + (["all messages, kB", "collectives, hops"] if counted else [])
    rows = []
    for p in points:
        row = [str(int(p["ranks"])), f"{p['halo_messages_mean']:.1f}, {1e-3 * p['halo_bytes_mean']:.1f}",
               f"{p['contact_messages_mean']:.1f}, {1e-3 * p['contact_bytes_mean']:.1f}", f"{p['ghost_faces']:.3f}",
               f"{p['searches']:.2f}", f"{p['rounds_per_cut']:.2f}"]
        if counted:
            row += [f"{p['mpi_messages']:.0f}, {1e-3 * p['mpi_bytes']:.1f}",
                    f"{p['mpi_collectives']:.0f}, {p['mpi_hops']:.0f}"]
        rows.append(row)
    return make_table(heading, rows)


def tabulate_forecast(points, latency, bandwidth):
    heading = ["ranks", "FE [us]", "contact [us]", "messages [us]", "collectives [us]", "efficiency"]
    most = points[-1]["ranks"]
    rows = []
    for ranks in FORECAST_RANKS[1:]:
        parts, efficiency = forecast(points, ranks, latency, bandwidth)
        rows.append([f"{ranks}" + ("" if ranks <= most else " (extrapolated)")] +
                    [f"{1e6 * parts[name]:.0f}" for name in ("fe", "contact", "messages", "collectives")] +
                    [f"{efficiency:.3f}"])
    return make_table(heading, rows)


def write_tables(points, latency, bandwidth):
    """All tables of all series, with headings."""
    text = ""
    series = dict.fromkeys((p["scene"], p["kind"], p["mode"]) for p in points)
    for scene, kind, mode in series:
        own = sorted((p for p in points if (p["scene"], p["kind"], p["mode"]) == (scene, kind, mode)),
                     key=lambda p: p["ranks"])
        text += f"### {SCENE_NAMES[scene]}, {kind} size, {MODE_NAMES[mode]}\n\n"
        text += tabulate_work(own) + "\n" + tabulate_phases(own) + "\n" + tabulate_messages(own) + "\n"
        if kind == "scaled" and len(own) > 1 and own[0]["ranks"] == 1 and "mpi_hops" in own[-1]:
            text += f"Forecast for {1e6 * latency:g} us a message or hop, {1e-9 * bandwidth:g} GB/s a rank:\n\n"
            text += tabulate_forecast(own, latency, bandwidth) + "\n"
    return text
