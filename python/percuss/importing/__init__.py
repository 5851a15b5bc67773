"""Decks of other programs become decks of percuss: percuss import."""
