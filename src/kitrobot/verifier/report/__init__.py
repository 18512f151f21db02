"""Counterexamples for people: as text, as a storyboard, and replayed in the simulator."""
