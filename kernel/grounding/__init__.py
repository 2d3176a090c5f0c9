"""One file for each ability of the body; each registers its functions with @grounding_function(name, verbs=...)."""
