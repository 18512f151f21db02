"""The studio as a static site, and as an entry of a desktop."""
