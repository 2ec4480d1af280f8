"""Theorem 4: convex polygons without obtuse angles (Section 5, Lemmas 9 to 12)."""
