"""What each platform adds to the loop: its serial line, its clock, how it shows itself."""
