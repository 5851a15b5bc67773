"""Abaqus decks of explicit analyses."""
