"""What people read: the table of claims, verdicts and facts, exact values shortened."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

from gmpy2 import mpq
from rich.box import SIMPLE_HEAD
from rich.console import Console
from rich.table import Table
from rich.text import Text

from bern_exact.certificate import Certificate
from bern_exact.checkers.findings import Finding
from bern_exact.facts import Facts
from bern_exact.figures import degrees, digits_of, root, shortened
from bern_exact.oracle.verdict import Verdict, distance_words

if TYPE_CHECKING:  # which brings every theorem with it
    from bern_exact.comparison import Row

ANGLE_WORDS = ("up to 60", "90", "120", "135", "150", "above")
"""The classes of a verdict's triangles by their largest angle, in order."""

LONGEST_LINE = 10_000
"""Characters of a line where the output is no terminal."""

SHORTEST_SENTENCE = 24
"""Claims are put in words only where so many characters of a line are left."""


def print_claims(claims: Sequence[Finding]) -> None:
    """Print the table of claims to standard error: claim, cases, measured, bound, holds.

    A terminal gets lines that fit; a file or a pipe gets every line whole.
    """
    out = Console(stderr=True, highlight=False)
    if out.is_terminal:
        out.print(claims_table(claims, out.width))
        return
    table = claims_table(claims, None)
    width = out.measure(table, options=out.options.update(width=LONGEST_LINE)).maximum
    Console(stderr=True, highlight=False, width=width).print(table)


def claims_table(claims: Sequence[Finding], width: int | None) -> Table:
    """The table of claims, a line each, in so many columns of characters or in all it takes."""
    headings = ("claim", "cases", "measured", "bound", "holds")
    rows = [
        (
            Text(claim.claim),
            Text(f"{claim.cases:,}"),
            Text(shortened(claim.measured)),
            Text(shortened(claim.bound)),
            _holds(claim),
        )
        for claim in claims
    ]
    table = Table(title="Claims, each checked exactly", title_justify="left", box=SIMPLE_HEAD)
    left = LONGEST_LINE if width is None else width - 4
    for i, heading in enumerate(headings):
        across = max(len(heading), *(len(row[i]) for row in rows))
        table.add_column(
            heading, min_width=across, no_wrap=True, justify="right" if 0 < i < 4 else "left"
        )
        left -= across + 2
    if left < SHORTEST_SENTENCE:
        for row in rows:
            table.add_row(*row)
        return table
    # What is left of the line is for the claim in words, cut off where the line ends.
    table.add_column("what is claimed", max_width=left, no_wrap=True)
    for row, claim in zip(rows, claims, strict=True):
        table.add_row(*row, Text(claim.statement[:left]))
    return table


def _holds(claim: Finding) -> Text:
    """Yes, no, or how an unproved or refuted sentence came out."""
    if claim.role == "as-printed":
        return Text("yes (as printed)" if claim.holds else "no (as printed)", style="yellow")
    return Text("yes", style="green") if claim.holds else Text("NO", style="bold red")


def certificate_lines(certificate: Certificate) -> list[str]:
    """A few lines that say what was made."""
    kept = sum(claim.holds for claim in certificate.claims if claim.role == "guarantee")
    guarantees = sum(claim.role == "guarantee" for claim in certificate.claims)
    per_vertex = digits_of(mpq(certificate.triangles, certificate.n), 3)
    holes = f"{certificate.holes:,} hole{'' if certificate.holes == 1 else 's'}"
    return [
        f"Theorem {certificate.theorem}: {certificate.n:,} vertices, {holes},"
        f" {certificate.triangles:,} triangles ({per_vertex} a vertex)",
        f"least height {root(certificate.min_height_squared)},"
        f" {root(certificate.height_ratio_squared)} of the feature size"
        f" {root(certificate.feature_size_squared)}",
        f"largest angle {degrees(certificate.max_angle)} degrees",
        f"{kept} of {guarantees} guarantees checked and kept" if guarantees else "nothing checked",
    ]


def verdict_lines(verdict: Verdict) -> list[str]:
    """What a judge found, a line each: the verdict, the figures, the defects."""
    lines = [f"{verdict.state}: {verdict.triangles:,} triangles, {verdict.vertices:,} vertices"]
    if verdict.triangles_per_vertex is not None:
        per_vertex = digits_of(verdict.triangles_per_vertex, 3)
        lines[0] += f", {per_vertex} triangles a vertex of the polygon"
    lines += _figure_lines(verdict)
    if verdict.off_edge is not None:
        lines.append(_off_edge_line(verdict.off_edge))
    return lines + [defect.sentence for defect in verdict.defects]


def _figure_lines(verdict: Verdict) -> list[str]:
    """Angles and heights, if any triangle has them."""
    if verdict.max_angle is None or verdict.min_height_squared is None:
        return []
    angle = f"largest angle {degrees(verdict.max_angle)} degrees"
    height = f"least height {root(verdict.min_height_squared)}"
    lines = [
        f"{angle}, triangle {verdict.max_angle_triangle}",
        f"{height}, triangle {verdict.min_height_triangle}",
    ]
    if verdict.feature_size_squared is not None and verdict.height_ratio_squared is not None:
        size = root(verdict.feature_size_squared)
        lines[-1] += f", {root(verdict.height_ratio_squared)} of the polygon's feature size {size}"
    named = zip(ANGLE_WORDS, verdict.angle_classes.values(), strict=True)
    return [*lines, "largest angles " + ", ".join(f"{word}: {k:,}" for word, k in named)]


def _off_edge_line(off_edge: Mapping[str, Any]) -> str:
    """How many boundary vertices are not where they belong, and how far the furthest is."""
    count = off_edge["vertices"]
    are = "vertex is" if count == 1 else "vertices are"
    return (
        f"{count:,} boundary {are} off the polygon, by at most {distance_words(off_edge)}:"
        f" vertex {off_edge['vertex']}"
    )


def comparison_lines(rows: Sequence[Row]) -> list[str]:
    """Meshes side by side, a line each under a heading; nothing if there are none."""
    if not rows:
        return []
    table = [("mesh", "triangles", "a vertex", "largest angle", "least height")]
    for row in rows:
        angle, height = row.max_angle, row.min_height_squared
        figures = "-" if angle is None else degrees(angle), "-" if height is None else root(height)
        per_vertex = digits_of(row.triangles_per_vertex, 3)
        table.append((row.mesh, f"{row.triangles:,}", per_vertex, *figures))
    widths = [max(map(len, column)) for column in zip(*table, strict=True)]
    lines = []
    for first, *others in table:
        cells = [text.rjust(width) for text, width in zip(others, widths[1:], strict=True)]
        lines.append("  ".join([first.ljust(widths[0]), *cells]))
    return ["", *lines]


def facts_lines(facts: Facts) -> list[str]:
    """The facts of a polygon, a line each."""
    record = facts.to_json()
    at = record["feature_size_at"]
    where = f"edge {at['edge']}"
    if "vertex" in at:
        where = f"vertex {at['vertex']} and {where}"
    acute = record["acute_vertices"]
    listed = " ".join(map(str, acute[:10])) + (" ..." if len(acute) > 10 else "")
    return [
        f"vertices           {facts.polygon.n:,}",
        f"holes              {facts.polygon.holes:,}",
        f"area               {shortened(record['area'])}",
        f"feature size       {root(facts.feature.squared)}",
        f"  squared          {shortened(record['feature_size_squared'])}",
        f"  attained at      {where}",
        f"diameter           {root(facts.diameter_squared)}",
        f"acute vertices     {len(acute):,}  {listed}".rstrip(),
        f"convex             {'yes' if facts.convex else 'no'}",
        "no triangulation has a least height above the feature size",
    ]
