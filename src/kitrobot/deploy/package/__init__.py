"""What is put onto a board: drivers and their settings, the interpreter, the program file, the start."""
