"""Pictures of a percuss run: what scripts/render is made of."""
