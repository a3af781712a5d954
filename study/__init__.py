"""The human study: who plays which episodes, what they see, what they answer.

It imports `reibench`, never the other way; a person's trial is a record like any planner's.
"""
