"""Images: their file, their listing, their verification, the machine."""
