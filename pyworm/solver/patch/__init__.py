"""Rough surfaces resolved node by node, moving through a point contact."""
