"""What scripts/export adds to percuss.export: files that need the surface of the bodies."""
