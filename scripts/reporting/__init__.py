"""One page about a run, or a comparison of runs: what scripts/report is made of."""
