"""Measurements: ratios within one run, and growth exponents."""
