"""The interior: rectilinear polygons with the matching condition (Definition 2, Lemma 3)."""
