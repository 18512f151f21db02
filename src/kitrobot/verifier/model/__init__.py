"""A mission as a discrete model: programs, abstraction, and the tables filled from them."""
