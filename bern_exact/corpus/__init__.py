"""Families of polygons, as functions of their parameters and a seed."""
