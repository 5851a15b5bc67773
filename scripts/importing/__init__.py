"""Decks of other programs become decks of percuss: scripts/import."""

from libraries import find_readers

find_readers()  # the modules here share their files and words with the readers of python/percuss
