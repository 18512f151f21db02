"""Images: the compiled form of a program, its file, its listing, its verification, and the machine that runs it."""
