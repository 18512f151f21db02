"""XML files: reading them through tables of tags, with limits and places; writing them."""
