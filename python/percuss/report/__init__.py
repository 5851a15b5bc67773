"""One page about a run, or a comparison of runs: what percuss report is made of."""
