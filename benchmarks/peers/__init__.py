"""This package's meshes and those of other meshers, side by side and judged alike.

    python -m benchmarks.peers                  # every table on stdout, as Markdown
    python -m benchmarks.peers --quick          # a few small polygons, in less than a minute
    python -m benchmarks.peers --write          # tables, plots and the picture, into the repository

`cases` has the polygons, `meshers` the list of meshers and `with_*` how each is called, `child` and
`runs` give each its own process with a cap on time and memory, `judging` measures a mesh exactly,
`targets` and `tables` say how they compare, `plots` and `picture` draw.
"""
