"""What elements may begin with: tables of start.fields refuse the rest."""

from .model import Block, Model

# Laws whose stress grows in increments, unless they have an equation of state.
GROWING = {
    "elastic", "j2_plasticity", "power_law_plasticity", "voce_plasticity", "tabulated_plasticity", "rate_table_plasticity",
    "combined_hardening", "johnson_cook",
}  # fmt: skip
YIELDING = (GROWING - {"elastic"}) | {"soil_and_foam", "honeycomb"}  # laws with an equivalent plastic strain


def takes_stress(model: Model, block: Block) -> bool:
    law = model.materials.get(block.keys.get("material", ""), {})
    return not block.keys.get("rigid") and law.get("model") in GROWING and "equation_of_state" not in law


def takes_plastic_strain(model: Model, block: Block) -> bool:
    law = model.materials.get(block.keys.get("material", ""), {})
    return not block.keys.get("rigid") and law.get("model") in YIELDING
