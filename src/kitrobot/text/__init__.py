"""What every reader of a text needs: lines and columns, words that were meant, values as sentences repeat them."""
