"""The Low Level Language as text and tree."""
