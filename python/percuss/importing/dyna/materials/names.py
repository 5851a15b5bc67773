"""Names of laws by their numbers."""

NUMBERS = {
    1: "ELASTIC", 3: "PLASTIC_KINEMATIC", 5: "SOIL_AND_FOAM", 6: "VISCOELASTIC", 7: "BLATZ-KO_RUBBER", 8: "HIGH_EXPLOSIVE_BURN",
    9: "NULL", 10: "ELASTIC_PLASTIC_HYDRO", 12: "ISOTROPIC_ELASTIC_PLASTIC", 13: "ISOTROPIC_ELASTIC_FAILURE",
    14: "SOIL_AND_FOAM_FAILURE", 15: "JOHNSON_COOK", 18: "POWER_LAW_PLASTICITY", 20: "RIGID", 24: "PIECEWISE_LINEAR_PLASTICITY",
    26: "HONEYCOMB", 27: "MOONEY-RIVLIN_RUBBER", 57: "LOW_DENSITY_FOAM", 63: "CRUSHABLE_FOAM", 127: "ARRUDA_BOYCE",
    81: "PLASTICITY_WITH_DAMAGE", 82: "PLASTICITY_WITH_DAMAGE_ORTHO", 98: "SIMPLIFIED_JOHNSON_COOK", 100: "SPOTWELD", 126: "MODIFIED_HONEYCOMB", 123: "MODIFIED_PIECEWISE_LINEAR_PLASTICITY",
}  # fmt: skip
SPRINGS = {"S01": "SPRING_ELASTIC", "S02": "DAMPER_VISCOUS", "S04": "SPRING_NONLINEAR_ELASTIC"}


def name_law(keyword: str) -> str:
    """ELASTIC of MAT_ELASTIC, MAT_001 and MAT_1."""
    name = keyword.removeprefix("MAT_")
    number = name.split("_")[0]
    if number.isdigit() and number.isascii() and int(number[:4]) in NUMBERS:
        return NUMBERS[int(number[:4])] + name[len(number) :]
    if name in SPRINGS:
        return SPRINGS[name]
    return name.replace("BLATZ_KO", "BLATZ-KO").replace("MOONEY_RIVLIN", "MOONEY-RIVLIN")
