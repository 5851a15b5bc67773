"""What a run has written: its files, history, frames and deck, and what follows from them."""
