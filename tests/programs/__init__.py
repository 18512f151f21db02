"""Small LLL files that say on the guilty line what is wrong with it, or on each line when it runs."""
