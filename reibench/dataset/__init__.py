"""Episodes on disk: reading, checking and choosing them."""
