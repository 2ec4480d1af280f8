"""Thinning: taking away every vertex that a mesh's guarantees can spare."""
