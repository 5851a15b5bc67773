"""Many runs of one deck: designs, their runs, and what is reported of each.

    from percuss.sweep import Study, make_designs
    study = Study("deck.yaml", "study")
    results = study.run(make_designs({"parts.wall.thickness": ["1e-3", "2e-3"]}))
    results[0].run.history["kinetic"]

percuss sweep is the command; inputs/calibration fits parameters to a curve."""

from .designs import BadDesign, Design, make_designs
from .study import Study

__all__ = ["BadDesign", "Design", "Study", "make_designs"]
