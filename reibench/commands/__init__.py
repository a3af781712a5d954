"""The command line's commands, one a file: each adds its parser and carries it out."""
