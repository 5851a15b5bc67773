"""Values that the importer chooses where the other program has none: percuss check would warn of them,
and the user cannot mend them."""

from .model import Block, Model

UNLIMITED = 1e3  # a share of added mass beyond any that is meant as a limit
UNREACHED = 1e14  # a specific heat of what does not heat
LEAST_POINTS = 4  # of shells that yield


def list_silenced(model: Model) -> list[str]:
    """Rules of percuss check that would speak of such values alone."""
    scaled = [block.keys["mass_scaling"].get("max_added", 0.0)
              for block in model.blocks if "mass_scaling" in block.keys]
    heats = [law["specific_heat"] for law in model.materials.values() if "specific_heat" in law]
    thin = [block for block in model.blocks if block.shells and has_few_points(block)]
    rules = {"mass_scaling": scaled and min(scaled) >= UNLIMITED, "specific_heat": heats and min(heats) >= UNREACHED,
             "shell_points": thin and all(block.is_plane for block in thin)}  # fmt: skip
    return [rule for rule, is_own in rules.items() if is_own]


def has_few_points(block: Block) -> bool:
    """Whether shells that bend have few points; rigid ones have no stress."""
    return not block.keys.get("rigid") and block.keys.get("points", LEAST_POINTS) < LEAST_POINTS
