"""Stress below the surfaces of a solved contact."""
