"""A class on the network: its server, who comes in, the requests and sockets of pupils and their teacher."""
