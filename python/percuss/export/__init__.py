"""Fields of a run in the formats of other programs: what percuss export is made of."""
