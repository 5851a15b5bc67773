"""All cases, in the order of the page."""
from cases import exact, rotation, waves, guided_waves, ties, impact, balls, bounces, rebounds, zener, closed, friction, dry_friction, partial_slip, oblique, blocks, rolling, plastic, bars, shocks, implosions, failure, perforation, cracks, shells, laminates, sheets, shell_collapse, impulsive, bending, closed_forms, at_rest, paper, hard  # noqa: F401
