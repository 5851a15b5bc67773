"""Pictures of a percuss run: what percuss render is made of."""
