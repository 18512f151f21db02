"""The use cases that the command line, the studio and Python share: open, check, convert, execute, lay out, run."""
