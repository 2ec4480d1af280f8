"""The interior without large angles: matching subdivided rectangles (Lemmas 6, 7, 8)."""
