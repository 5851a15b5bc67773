"""What a machine with a network would make of measured work and counted messages.

A step on P ranks takes

    work x imbalance + messages x latency + bytes / bandwidth + hops x latency

with the mean work of a rank, each part with its own imbalance (or the work of the rank with most), point-to-point
messages and bytes of the rank that has most, and for every collective operation ceil(log2(its ranks)) latencies
("hops"). Nothing overlaps. Beyond the measured ranks, work, messages and bytes stay as they are at the most ranks
measured, but for the bisection, whose levels grow: its work goes on linearly in log2 P, and hops as a log2 P + b log2 P
(log2 P + 1) / 2, the second term being bisection (a cut of each level is a tree over half as many
ranks as the one before).
"""
import math


def solve_least_squares(rows, values):
    """x, y that fit values = x row[0] + y row[1] best, neither of them negative."""
    s00 = sum(r[0] * r[0] for r in rows)
    s01 = sum(r[0] * r[1] for r in rows)
    s11 = sum(r[1] * r[1] for r in rows)
    b0 = sum(r[0] * v for r, v in zip(rows, values))
    b1 = sum(r[1] * v for r, v in zip(rows, values))
    determinant = s00 * s11 - s01 * s01
    if determinant > 1e-12 * s00 * s11:
        x, y = (b0 * s11 - b1 * s01) / determinant, (b1 * s00 - b0 * s01) / determinant
        if x >= 0 and y >= 0:
            return x, y
    return max((b0 / s00, 0), (0, b1 / s11), key=lambda xy: -sum(
        (xy[0] * r[0] + xy[1] * r[1] - v)**2 for r, v in zip(rows, values)))


def count_levels(ranks):
    return math.ceil(math.log2(ranks))


def forecast(points, shares, growth, ranks, network):
    """Seconds of a step on `ranks` ranks, by part, and two efficiencies: the share of a rank in the work of one rank
    with the same mesh, over that, with the mean work of a rank and with that of the busiest in each part. points: of
    one scaled problem, ascending in ranks; shares: by ranks, in microseconds; growth: by ranks, what work is divided by
    because the machine alone made it grow; network: latency in seconds, bandwidth in bytes a second.
    """
    latency, bandwidth = network
    many = [p for p in points if p["ranks"] > 1]
    last = many[-1]
    near = next((p for p in many if p["ranks"] == ranks), last)
    levels = count_levels(ranks)

    def hop_terms(n):
        return n, n * (n + 1) / 2

    fit = solve_least_squares([hop_terms(count_levels(p["ranks"])) for p in many], [p["mpi_hops"] for p in many])
    hops = near["mpi_hops"] if near["ranks"] == ranks else sum(a * b for a, b in zip(fit, hop_terms(levels)))
    rcb = near["contact_rcb_us"]
    if near["ranks"] != ranks:
        rcb *= levels / count_levels(last["ranks"])
    contact = near["contact_us_mean"] - near["contact_rcb_us"] + rcb
    second = 1e-6 / growth[near["ranks"]]
    parts = {"fe": second * near["fe_us_mean"] * near["element_imbalance"],
             "contact": second * contact * near["contact_imbalance"],
             "messages": near["mpi_messages"] * latency + near["mpi_bytes"] / bandwidth,
             "collectives": hops * latency}
    share, step = 1e-6 * sum(shares[near["ranks"]]), sum(parts.values())
    busiest = step - parts["fe"] - parts["contact"] + second * (near["fe_us_max"] + near["contact_us_max"] + contact -
                                                                near["contact_us_mean"])
    return parts, share / step, share / busiest
