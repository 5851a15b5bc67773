"""Fields of a run in the formats of other programs: what scripts/export is made of."""
