"""One file for each directive; each registers its code with @directive(TAG). ANTE and POST are phases of DO."""
