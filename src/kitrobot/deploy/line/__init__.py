"""The line to a board: bytes, the raw REPL, files through the receiver, and the link with a running robot."""
