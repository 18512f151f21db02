"""What happened in a run, tick by tick: recorded, read, sought."""
