"""A program is the same in all its forms: text, graph, image, listing."""
