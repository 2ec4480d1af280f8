"""Proofs of what the code takes for granted, their computable parts checked exactly."""
