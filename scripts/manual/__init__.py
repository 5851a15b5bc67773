"""From help texts to a manual page and the completion of shells: what scripts/make_manual is made of."""
