"""Observes missions."""
