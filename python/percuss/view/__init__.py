"""The surface of a run to turn with the mouse over time: what percuss view is made of; reports embed it, too."""
