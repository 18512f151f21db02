"""What LLL programs mean, tick by tick: each fact of the language's definition on a small program."""
