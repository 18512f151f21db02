"""LLL → graph: drawn anew, with the ids of what stayed, and edits of a text."""
