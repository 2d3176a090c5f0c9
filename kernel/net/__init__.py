"""Semantic nets: graphlets (patterns and descriptions), memory nodes, matching, notation."""
