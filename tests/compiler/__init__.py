"""Translations of programs, and what is wrong or odd about them."""
