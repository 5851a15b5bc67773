"""All cases, in the order of the page."""
from cases import exact, rotation, waves, ties, impact, balls, closed, friction, plastic, shocks, implosions, failure, shells, bending, paper, hard  # noqa: F401
