"""What a studio's process has at a time: runs and who watches them, real robots, the team, recordings; without HTTP."""
