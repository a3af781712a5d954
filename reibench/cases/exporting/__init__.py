"""A case as something to keep or print: a page that opens offline, a figure, data."""
