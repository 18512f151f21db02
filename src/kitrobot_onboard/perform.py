# Python's `exec` by another name: where the word itself stands, no name can be made shorter for a small board.

perform = exec
