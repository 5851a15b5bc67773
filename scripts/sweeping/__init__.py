"""The page of a sweep: what scripts/sweep adds to percuss.sweep."""
