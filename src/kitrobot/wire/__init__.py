"""What travels between the server and the page: one model for each shape, and how our own values become it.

The models are the authority: `tools/api_types.py` writes the page's TypeScript types from them, under the same names
without `Shape`. Every field is always sent. Left to others: reading requests, and what the values mean.
"""
