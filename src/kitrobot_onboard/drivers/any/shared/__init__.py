# What drivers of all kinds of boards share: what they do, without how a pin or a bus of a kind of board is asked.
