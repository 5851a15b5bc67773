"""Measured points as tables of Markdown."""
from forecast import forecast
from measure import CONTACT_PHASES, FE_PHASES
from scenes import CONTROL

SCENE_NAMES = {"brick_wall": "Brick wall", "can_crush": "Can crush"}
MODE_NAMES = {"every_step": "search and rebalance in every step", "when_due": "search and rebalance when due"}
FORECAST_RANKS = [1, 2, 4, 8, 16, 32, 64, 128, 256, 512, 1024, 2048, 4096]


def make_table(heading, rows):
    lines = ["| " + " | ".join(heading) + " |", "|" + "---|" * len(heading)]
    lines += ["| " + " | ".join(row) + " |" for row in rows]
    return "\n".join(lines) + "\n"


def sum_of_work(point):
    return point["ranks"] * (point["fe_us_mean"] + point["contact_us_mean"])


def find_growth(control, ranks):
    """How much the machine alone lets the work of a rank grow, by the control; 1 without one."""
    own = {p["ranks"]: p["fe_us_mean"] for p in control}
    return own[ranks] / own[1] if ranks in own and 1 in own else 1.0


def tabulate_control(points):
    rows = [[str(int(p["ranks"])), str(int(p["elements"])), f"{p['fe_us_mean']:.0f}, {p['fe_us_max']:.0f}",
             f"{find_growth(points, p['ranks']):.2f}"] for p in points]
    return make_table(["ranks", "elements", "FE: mean, max [us]", "work of a rank / that of one"], rows)


def find_shares(whole):
    """A rank's share of the FE and contact work of one rank with the same mesh, by number of ranks."""
    return {p["ranks"]: (p["fe_us_mean"] / p["ranks"], p["contact_us_mean"] / p["ranks"]) for p in whole}


def find_ratios(point, base):
    """FE, contact and both over those of a base (FE, contact)."""
    own = (point["fe_us_mean"], point["contact_us_mean"])
    return [own[0] / base[0], own[1] / base[1], sum(own) / sum(base)]


def format_ratios(ratios):
    return ", ".join(f"{ratio:.2f}" for ratio in ratios)


def tabulate_scaled_work(points, control, shares):
    """Work of a rank and step against one rank that holds as many elements, and against its share of the same mesh."""
    heading = ["ranks", "elements", "FE: mean, max [us]", "contact: mean, max [us]", "over one rank: FE, contact, both",
               "the same over the control", "over the share: FE, contact, both", "imbalance: elements, contact"]
    rows = []
    for p in points:
        ratios = find_ratios(p, (points[0]["fe_us_mean"], points[0]["contact_us_mean"]))
        share = format_ratios(find_ratios(p, shares[p["ranks"]])) if p["ranks"] in shares else ""
        growth = find_growth(control, p["ranks"])
        rows.append([str(int(p["ranks"])), str(int(p["elements"])), f"{p['fe_us_mean']:.0f}, {p['fe_us_max']:.0f}",
                     f"{p['contact_us_mean']:.0f}, {p['contact_us_max']:.0f}", format_ratios(ratios),
                     format_ratios([r / growth for r in ratios]), share,
                     f"{p['element_imbalance']:.3f}, {p['contact_imbalance']:.3f}"])
    return make_table(heading, rows)


def tabulate_fixed_work(points):
    """Work of a rank and step, and its sum over ranks against one rank."""
    heading = ["ranks", "elements", "FE: mean, max [us]", "contact: mean, max [us]", "sum of work / that of one rank",
               "imbalance: elements, contact"]
    rows = []
    for p in points:
        rows.append([str(int(p["ranks"])), str(int(p["elements"])), f"{p['fe_us_mean']:.0f}, {p['fe_us_max']:.0f}",
                     f"{p['contact_us_mean']:.0f}, {p['contact_us_max']:.0f}",
                     f"{sum_of_work(p) / sum_of_work(points[0]):.2f}",
                     f"{p['element_imbalance']:.3f}, {p['contact_imbalance']:.3f}"])
    return make_table(heading, rows)


def tabulate_phases(points):
    """Mean work of a rank and step by phase, and for the contact phases a point of the rank."""
    heading = ["ranks"] + [phase.replace("_", " ") for phase in FE_PHASES + CONTACT_PHASES]
    heading += ["contact points per rank", "contact work [ns] per point"]
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


def tabulate_forecast(points, control, shares, network):
    heading = ["ranks", "FE [us]", "contact [us]", "messages [us]", "collectives [us]", "efficiency",
               "efficiency, work over the control", "the same, busiest rank"]
    as_measured = {p["ranks"]: 1.0 for p in points}
    growth = {p["ranks"]: find_growth(control, p["ranks"]) for p in points}
    most = points[-1]["ranks"]
    rows = []
    for ranks in FORECAST_RANKS[1:]:
        if ranks < most and ranks not in growth:
            continue
        parts, efficiency, _ = forecast(points, shares, as_measured, ranks, network)
        _, corrected, busiest = forecast(points, shares, growth, ranks, network)
        rows.append([f"{ranks}" + ("" if ranks <= most else " (extrapolated)")] +
                    [f"{1e6 * parts[name]:.0f}" for name in ("fe", "contact", "messages", "collectives")] +
                    [f"{efficiency:.3f}", f"{corrected:.3f}", f"{busiest:.3f}"])
    return make_table(heading, rows)


def write_series(own, control, shares, network):
    """The tables of one scene, kind, mode and size."""
    kind = own[0]["kind"]
    text = tabulate_fixed_work(own) if kind == "fixed" else tabulate_scaled_work(own, control, shares)
    text += "\n" + tabulate_phases(own) + "\n" + tabulate_messages(own) + "\n"
    if kind == "scaled" and all(p["ranks"] in shares and "mpi_hops" in p for p in own) and len(own) > 1:
        text += f"Forecast for {1e6 * network[0]:g} us per message or hop, {1e-9 * network[1]:g} GB/s per rank:\n\n"
        text += tabulate_forecast(own, control, shares, network) + "\n"
    return text


def write_tables(points, network):
    """All tables of all series, with headings. network: latency [s] and bandwidth [bytes/s] of the forecast."""

    def select(*wanted):
        own = [p for p in points if (p["scene"], p["kind"], p["mode"], p["size"]) == wanted]
        return sorted(own, key=lambda p: p["ranks"])

    text = ""
    for scene, kind, mode, size in dict.fromkeys((p["scene"], p["kind"], p["mode"], p["size"]) for p in points):
        per_rank = f"{int(size):,}".replace(",", " ") + " elements a rank"
        own = select(scene, kind, mode, size)
        if scene == CONTROL:
            text += f"### Control: bodies apart, {per_rank}\n\n" + tabulate_control(own) + "\n"
        elif kind != "whole":
            heading = "fixed size" if kind == "fixed" else per_rank
            text += f"### {SCENE_NAMES[scene]}, {heading}, {MODE_NAMES[mode]}\n\n"
            control, whole = select(CONTROL, "scaled", "when_due", size), select(scene, "whole", mode, size)
            text += write_series(own, control, find_shares(whole), network)
    return text
