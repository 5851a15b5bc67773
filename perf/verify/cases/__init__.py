"""All cases, in the order of the page."""
from cases import exact, rotation, waves, ties, impact, balls, closed, friction, plastic, bars, shocks, implosions, failure, shells, shell_collapse, bending, paper, hard  # noqa: F401
