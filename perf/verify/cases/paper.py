"""The scenes of the parallel-contact paper."""
import pathlib

from bench import case

INPUTS = pathlib.Path(__file__).resolve().parents[3] / "inputs"


def read_deck(scene, **settings):
    """A deck of inputs/ without its fields; settings replace texts."""
    text = (INPUTS / scene / "deck.yaml").read_text()
    lines = [line for line in text.splitlines() if "fields:" not in line]
    text = "\n".join(lines) + "\n"
    for old, new in settings.items():
        text = text.replace(old, new)
    return text.replace("$", "$$")


def run_scene(bench, scene, elements, end, closed, same_bits_steps):
    """A whole run on one rank, its first steps on one and on four."""
    text = read_deck(scene)
    run = bench.run(text if not bench.quick else text.replace("time: {", f"time: {{max_steps: {same_bits_steps}, "))
    h = run.history
    bench.equal("elements", run.summary["elements"], elements)
    if not bench.quick:
        bench.near("time reached", run.summary["time"], end, relative=1e-12, unit="s")
    bench.below("linear momentum that no outer impulse explains", run.summary["momentum"]["linear_error"], 1e-12)
    bench.below("angular momentum that no outer impulse explains", run.summary["momentum"]["angular_error"], 1e-12)
    bench.below("energy balance, largest error", h.largest("energy_error"), 0.01)
    bench.below("energy that contact gives over the kinetic energy", h["contact"].max() / h["kinetic"][0], 1e-6)
    bench.below("penetration that enforcement left, over an edge", h["residual"].max(), 1e-3)
    short = text.replace("time: {", f"time: {{max_steps: {same_bits_steps}, ")
    one, four = bench.run(short), bench.run(short, ranks=4)
    bench.above(f"interactions within {same_bits_steps} steps", one.history.largest("contacts"), 0)
    bench.equal(f"state_hash after {same_bits_steps} steps on 4 ranks and on 1", four.summary["state_hash"],
                one.summary["state_hash"])
    bench.equal("history.csv on 4 ranks, every byte",
                "same" if one.history_bytes == four.history_bytes else "other", "same")
    energy = run.summary["energy"]
    bench.table(["kinetic at the start", "kinetic", "internal", "hourglass", "viscous", "contact", "friction", "steps",
                 "loop on one core [s]"],
                [[f"{h.first('kinetic'):.4g}"] + [f"{energy[name]:.4g}" for name in ("kinetic", "internal", "hourglass",
                                                                                     "viscous", "contact", "friction")]
                 + [run.summary["steps"], f"{run.summary['loop_s']:.0f}"]], "Energies at the end [J]:")
    return run


@case("brick_wall", "paper", "Brick wall")
def brick_wall(bench):
    """The scene `inputs/brick_wall`: 140 loose bricks of 54 elements and a rod, 8400 elements in all, as in the paper
    (Attaway et al. 1996). There is no exact answer: momentum to round-off, energy within 1 %, the same bits on one and
    on four ranks."""
    run_scene(bench, "brick_wall", 8400, 5e-3, True, 150)


@case("can_crush", "paper", "Can crush")
def can_crush(bench):
    """The scene `inputs/can_crush`: half of a steel container three elements thick under an inclined plate, 7152 elements, as in the paper. As above."""
    run_scene(bench, "can_crush", 7152, 4e-3, False, 400)
