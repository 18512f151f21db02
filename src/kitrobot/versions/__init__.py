"""Versions of a mission or a kit held against each other: what is different, in words, and three-way merges."""
