"""What a run begins with: settings and limits of a mission, checked, and its tables filled."""
