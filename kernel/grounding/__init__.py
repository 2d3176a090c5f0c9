"""See the module docstrings; files here register themselves."""
