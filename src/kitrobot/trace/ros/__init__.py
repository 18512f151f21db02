"""Recordings as the tools of ROS 2 read them: messages in CDR, in an MCAP file."""
