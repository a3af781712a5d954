"""Tuning: small adapters for the packaged model, and everything they are made from.

The data are made by program, from rooms, dialogues and phrasings that no shipped episode has; the
recipe is `python -m reibench train`.
"""
