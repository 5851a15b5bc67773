"""The page about a scene before it runs: what percuss check --report is made of."""
