"""How fast we are, each subject beside a named peer in the same run.

    python -m benchmarks                  everything, as a table (`make bench`)
    python -m benchmarks parsing images   some of it
    python -m benchmarks --no-peers       without npm's peers and PyPI's
    python -m benchmarks --json           the same as JSON

A subject is a file in `benchmarks/subjects`, a peer one in `benchmarks/peers`; what the numbers mean and how they came
out is in docs/benchmarks.md, and each measurement with its day in benchmarks/diary.md. Nothing here decides a test.
"""
