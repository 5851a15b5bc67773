"""What the laws of percuss can do, as `percuss schema` prints it."""

import functools
import json
import subprocess

from percuss.errors import NotResults
from percuss.program import find_program
from percuss.terminal import clean

from .model import Block, Deck, Model

NOT_DAMPED = "stiffness damping of elements other than hexahedra, shells and beams, or of a law whose elastic constants change"


@functools.cache
def read_traits() -> dict[str, dict[str, bool]]:
    """By the name of a law."""
    program = find_program()
    done = subprocess.run([program, "schema"], capture_output=True, text=True, errors="replace", check=False)
    try:
        traits: dict[str, dict[str, bool]] = json.loads(done.stdout)["x-laws"]
    except (ValueError, LookupError, TypeError) as error:
        text = "which does not say what its laws can do: it is older than this tool, or no percuss"
        raise NotResults(f"{clean(program)} schema ends with exit code {done.returncode} ({text}): build percuss anew") from error
    return traits


def has(law: Deck, trait: str) -> bool:
    """Whether a law of a deck has a trait of `x-laws`."""
    return read_traits().get(law.get("model", ""), {}).get(trait, False)


def grows_in_increments(law: Deck) -> bool:
    """Whether its stress may begin with any value and its elastic constants do not change: not with an equation of state."""
    return has(law, "grows_in_increments") and "equation_of_state" not in law


def hardens_isotropically(law: Deck) -> bool:
    """Whether it has constants or a table of isotropic hardening, and no other."""
    return law["model"] in ("j2_plasticity", "tabulated_plasticity") or (law["model"] == "combined_hardening" and not law["kinematic_share"])


def has_axes(law: Deck) -> bool:
    """Whether it has directions of its own."""
    return has(law, "has_axes")


def takes_stiffness_damping(block: Block, law: Deck) -> bool:
    """Whether percuss knows it for these elements and this material."""
    is_known = all(len(set(corners)) == 8 for _, corners in block.solids)
    return is_known and grows_in_increments(law) and not block.layers


def takes_beams(law: Deck) -> bool:
    """Whether beams know the law."""
    return has(law, "is_of_beams") and "equation_of_state" not in law


def make_mooney_rivlin(c10: float, c01: float) -> Deck:
    """Without its bulk modulus. percuss' law of this name takes no negative constants: the terms 2 and -2 of Ogden's law are the same energy."""
    if c10 > 0 and c01 >= 0:
        return {"model": "mooney_rivlin", "c10": c10, "c01": c01}
    return {"model": "ogden", "terms": [[alpha, mu] for alpha, mu in ((-2.0, -2 * c01), (2.0, 2 * c10)) if mu]}


def find_law(model: Model, block: Block) -> Deck:
    """Of the elements of a part; empty where they are rigid, have none or several."""
    return {} if block.keys.get("rigid") or "plies" in block.keys else model.materials.get(block.keys.get("material", ""), {})


def takes_stress(model: Model, block: Block) -> bool:
    """Whether elements may begin with a stress: tables of start.fields refuse it for the others."""
    return grows_in_increments(find_law(model, block))


def takes_plastic_strain(model: Model, block: Block) -> bool:
    """Whether elements may begin with an equivalent plastic strain."""
    return has(find_law(model, block), "has_plastic_strain")
