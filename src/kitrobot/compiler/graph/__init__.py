"""Graph → LLL: templates filled, names and wires, and own parts made of a selection."""
