"""A team's program: what its robots do with it, in all."""
