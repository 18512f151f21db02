"""A team as processes: an agent each, that meet over the network, and the world of simulated bodies."""
