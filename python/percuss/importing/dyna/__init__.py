"""LS-DYNA keyword decks."""
