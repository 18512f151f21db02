"""Studies of many runs: what varies, what is measured, the rows on the disk, and the processes that make them."""
