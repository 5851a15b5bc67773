"""What the laws of percuss can do, as `percuss schema` prints it: laws.json has it, so that an import needs no program.

    percuss schema | python3 -m percuss.importing.laws    # writes laws.json anew
"""

import functools
import json
import os
import sys

from .model import Block, Deck, Model

TRAITS = "laws.json"
NOT_DAMPED = ("stiffness damping of elements other than hexahedra, shells and beams, "
              "or of a law whose elastic constants change")


@functools.cache
def read_traits() -> dict[str, list[str]]:
    """Traits by the name of a law."""
    with open(os.path.join(os.path.dirname(__file__), TRAITS), encoding="utf-8") as file:
        traits: dict[str, list[str]] = json.load(file)
    return traits


def write_traits(schema: str) -> str:
    """The text of the file, from what `percuss schema` prints."""
    laws = json.loads(schema)["x-laws"]
    lines = [f"{json.dumps(name)}: {json.dumps([trait for trait, is_so in laws[name].items() if is_so])}"
             for name in laws]
    return "{\n" + ",\n".join(lines) + "\n}\n"


def has(law: Deck, trait: str) -> bool:
    """Whether a law of a deck has a trait of `x-laws`."""
    return trait in read_traits().get(law.get("model", ""), [])


def grows_in_increments(law: Deck) -> bool:
    """Whether its stress may begin with any value and its elastic constants do not change:
    not with an equation of state."""
    return has(law, "grows_in_increments") and "equation_of_state" not in law


def hardens_isotropically(law: Deck) -> bool:
    """Whether it has constants or a table of isotropic hardening, and no other."""
    return (law["model"] in ("j2_plasticity", "tabulated_plasticity")
            or (law["model"] == "combined_hardening" and not law["kinematic_share"]))


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
    """Without its bulk modulus.
    percuss' law of this name takes no negative constants: the terms 2 and -2 of Ogden's law are the same energy."""
    if c10 > 0 and c01 >= 0:
        return {"model": "mooney_rivlin", "c10": c10, "c01": c01}
    return {"model": "ogden", "terms": [[alpha, mu] for alpha, mu in ((-2.0, -2 * c01), (2.0, 2 * c10)) if mu]}


def find_law(model: Model, block: Block) -> Deck:
    """Law of the elements of a part; empty where they are rigid, have none or several."""
    return ({} if block.keys.get("rigid") or "plies" in block.keys
            else model.materials.get(block.keys.get("material", ""), {}))


def takes_stress(model: Model, block: Block) -> bool:
    """Whether elements may begin with a stress: tables of start.fields refuse it for the others."""
    return grows_in_increments(find_law(model, block))


def takes_plastic_strain(model: Model, block: Block) -> bool:
    """Whether elements may begin with an equivalent plastic strain."""
    return has(find_law(model, block), "has_plastic_strain")


if __name__ == "__main__":
    with open(os.path.join(os.path.dirname(__file__), TRAITS), "w", encoding="utf-8") as written:
        written.write(write_traits(sys.stdin.read()))
