"""The systems of units that fit the metals of a model. A hint: nothing is converted, nothing assumed."""

from .model import Model

# Density and Young's modulus of steel and aluminium in kg, m, s; factors of the systems.
METALS = ((7850.0, 2.05e11), (2700.0, 7.0e10))
SYSTEMS = {"m, kg, s": (1.0, 1.0), "mm, t, s": (1e-12, 1e-6), "mm, kg, ms": (1e-9, 1e-9), "mm, g, ms": (1e-6, 1e-6),
           "cm, g, us": (1e-3, 1e-11), "in, lbf s2/in, s": (9.3572e-8, 1.4504e-4)}  # fmt: skip


def list_fits(model: Model) -> list[str]:
    """Systems in which a material of the model is nearly steel or aluminium."""
    fits = []
    for name, (density_factor, modulus_factor) in SYSTEMS.items():
        for law in model.materials.values():
            modulus = law.get("youngs_modulus", 0.0) / modulus_factor
            density = law["density"] / density_factor
            if (
                any(abs(density / rho - 1) < 0.15 and abs(modulus / youngs - 1) < 0.25 for rho, youngs in METALS)
                and name not in fits
            ):
                fits.append(name)
    return fits


def describe(model: Model, units: str) -> str:
    if units:
        return f"units: {units}, as {'a blast says' if model.units else 'you say'}"
    fits = list_fits(model)
    hint = f"; its metals would fit {' or '.join(repr(fit) for fit in fits)}" if fits else ""
    return f"units: none are said, so results show none (--units){hint}"
