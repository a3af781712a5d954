"""Speed and memory, measured here and now: of worlds, and of planners beside the published way."""
