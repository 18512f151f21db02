"""The Low Level Language as text and tree: tokens, parser, printer."""
