"""Statistics of numbers: intervals, comparisons and rules that say when runs are enough. Nothing here runs anything."""
