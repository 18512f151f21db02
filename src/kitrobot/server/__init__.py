"""The studio's server: a thin door to the workspace for the page in the browser."""
