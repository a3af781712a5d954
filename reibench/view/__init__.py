"""Views: pure functions from dialogues, scenes, steps and records to HTML and SVG text."""
