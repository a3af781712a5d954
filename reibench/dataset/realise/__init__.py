"""The realiser: dialogues of any level without end, recombined from marked parts and the lexicon.

Plainer than the written set, and always marked `realised`. It makes scripts, so that all nine
levels derive as they do from written ones.
"""

ORIGIN = "realised"
"""The mark that every realised script and episode bears."""
