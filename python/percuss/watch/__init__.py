"""A run in the terminal: what percuss watch is made of. Python alone, so that it works on any machine of a cluster."""
