"""What researchers see: each file one page, as pure functions to HTML."""
