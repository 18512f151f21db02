"""A class: pupils with a folder each, what they hand in, and what their teacher does with all of them; without HTTP."""
