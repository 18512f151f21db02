"""How KitRobot says what is wrong."""
