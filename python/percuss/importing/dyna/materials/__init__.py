"""*MAT_ and *EOS_ as laws of percuss."""
