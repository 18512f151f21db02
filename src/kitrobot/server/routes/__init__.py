"""The requests and sockets of the API: each route reads its request, asks a use case, and answers."""
