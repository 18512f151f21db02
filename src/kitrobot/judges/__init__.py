"""One property, several judges: every order of events, one run, many runs, every failure, recordings."""
