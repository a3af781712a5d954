"""REI-Bench: can robot planners, and people, follow vague instructions?"""
