"""Translations: graph → LLL, LLL → graph, LLL → three-address code → image; and the check of a program's names."""
