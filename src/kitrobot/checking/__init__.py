"""Verification as a use case: a mission's check, checks while somebody draws, checks beside other work, exercises."""
