"""Cases: episodes with the runs of people and planners on them, to be found, compared and kept."""
