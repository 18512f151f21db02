"""The peers: what others offer for the same work, set up as kindly as we know."""
