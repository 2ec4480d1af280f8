"""A picture of a planar straight-line graph."""

from __future__ import annotations

from gmpy2 import mpq

from bern_exact.exact.points import coordinates, hpoint
from bern_exact.plane.plane_graph import PlaneGraph
from bern_exact.view.canvas import Plane, Window, path_data
from bern_exact.view.page import Page

SIZE = (880, 820)
"""The largest width and height on the page, in pixels."""


def draw_graph(graph: PlaneGraph, *, stretch: int | mpq = 1) -> str:
    """An SVG of a graph.

    Parameters
    ----------
    graph : PlaneGraph
        What to draw.
    stretch : int or mpq
        Heights are multiplied by this: the paper's graphs are too thin to be seen as they are.

    Returns
    -------
    str
        The file's text; the same for the same graph, on any machine.

    >>> graph = PlaneGraph("edge", (hpoint(0, 0), hpoint(3, 1)), ((0, 1),))
    >>> 'class="outline"' in draw_graph(graph, stretch=4)
    True
    """
    places = [coordinates(p) for p in graph.points]
    points = [hpoint(x, y * stretch) for x, y in places]
    plane = Plane.around(points)
    at = plane.all(points)
    window = Window.fitting(plane, *SIZE)
    page = Page(window, (), 0)
    note = f"{len(points)} vertices, {len(graph.edges)} edges"
    page.heading(graph.name, note if stretch == 1 else f"{note}; heights times {stretch}")
    lines = [(at[a], at[b]) for a, b in graph.edges]
    page.whole([("outline", path_data(window, lines, closed=False))])
    return page.text()
