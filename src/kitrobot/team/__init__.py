"""The protocol of a team, as pure state machines: time and events in, messages and changes out."""
