"""Motion, contact, pushing and sight in the plane, over the tables."""
