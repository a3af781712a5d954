"""Building scripts with a language model, in the paper's three steps (section 3.2, appendix B).

    seed instruction ─generation→ explicit dialogue ─processing→ its noise and its gaps
                                  explicit dialogue ─replacement→ its unnamed mentions
                                  all of them ─alignment, counting rule, our checks→ script or drop

Whatever the model says is aligned with the explicit dialogue, so that all nine levels derive from
one script by program; what cannot be aligned is dropped, and the report says at which step and why.
"""
