"""Section 2 of the paper near the boundary: lop, dice, warp, faces (Lemmas 1 and 2)."""
