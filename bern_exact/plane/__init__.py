"""The plane: polygons and meshes, validation, and the feature size of Definition 1."""
