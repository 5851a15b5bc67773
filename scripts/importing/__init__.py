"""Decks of other programs become decks of percuss: scripts/import."""
