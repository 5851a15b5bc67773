"""Curves of history.csv: what percuss plot is made of; percuss report draws with it, too."""
