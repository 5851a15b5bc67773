"""Curves of history.csv: what scripts/plot is made of; scripts/report draws with it, too."""
