"""Places where robots move: walls, coloured floor, roads, docks, storehouses; reading, writing, geometry."""
