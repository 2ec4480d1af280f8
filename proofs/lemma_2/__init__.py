"""Lemma 2's block half: "Neighbor and occupied squares can be triangulated with maximum angle at
most 135 degrees as well", for which the paper shows 12 cases of "tedious, but straightforward"
case analysis (Figure 2).  Here it is done completely, with the repaired choice of corner.

**The statement that is computed.**  For every v in the unit square, on no grid line, and any two
rays e and f from it with an interior angle (from e counter-clockwise to f) of at least 90 and
less than 360 degrees, neither axis-parallel nor diagonal nor through a grid vertex, some corner
of the square can be taken by v so that after both warps every face of the block has a
triangulation by its own vertices with all angles below 132 degrees: dot + (9/10) cross > 0 at
every corner.  (The bound is 180 degrees - arccot(9/10) = 131.987 degrees.  As kappa >= 3/5 >
cot 60, a triangle with all three tests positive is counter-clockwise and not flat: otherwise its
three angles, taken without sign, would be below arccot kappa < 60 degrees each, or one would be
180, or two corners would coincide.)

**How.**  The parameters are x, y in [0, 1] and the slopes m_e, m_f in [-1, 1], each in the frame
in which its ray goes up (`rays`).  What the rules make of the block depends on finitely many
types of rays (`rays.RayType`), which are sections of grid lines as in the paper: `block` runs the
rules. A certificate (`tree`) halves the box of all parameters again and again; at each leaf
`replay` finds the types that occur in it, and shows for all of them that some corner is good over
the whole leaf, by affine forms in integers (`forms`, `points`).  Whatever cannot be decided over
a leaf is taken both ways, so that nothing can be forgotten.  `search` found the trees, and is not
trusted.

**On paper: from a polygon P' to these parameters.**  In grid units (b = 1) s' >= 8.

1. *The sheet is the block and the wedge.*  A point of the block is at most 2 sqrt 2 < s' from v;
   a shortest segment from v to an edge not at v, within P', is at least s' long: so inside the
   wedge nothing of the boundary comes into the block but the two edges at v (`proofs.section_2`).
   The same holds for the block enlarged by tau: (2 + tau) sqrt 2 < 3.01.  Proved.
2. *Rays reach beyond.*  Both edges at v are at least s' >= 8 long, and leave the enlarged block
   after at most 3.01: they are rays as far as the block can see.  Proved.
3. *Lines.*  Every piece of the eight lines within block and wedge is kept, whatever else is;
   other grid lines do not enter the block.  So the faces of the block are the cells, cut by the
   rays; the first grid vertex inwards and the next one outwards from a crossing within the block
   are the ends of its unit segment (for anchors: all eight lines are in use); an interval whose
   unit segment the other ray cuts first has no inner neighbour.  Proved.
4. *Choosers.*  What chooses an interior grid vertex g of the block is within tau of it, along a
   grid line inside P': by 1 it lies on e or f.  What chooses an instance (e, c) lies on e. A ray
   with |m| <= 1 that crosses a column within tau of a grid vertex crosses the row through it no
   further away: of a ray's two q-vertices the row's is the nearer, and a column's beyond the
   block never wins, since no corner of v's square is on a rim row, so that rim crossings always
   choose freely. The row crossing just beyond a corner of the block is kept if its inner
   neighbour is that corner.  If it lies outwards, the line may or may not be kept for another
   vertex: both are tried.  If it is kept, the crossing stays in place when it chooses the corner:
   its inner neighbour cannot move onto the ray, whose next column is at least 1 - tau above.
   Proved.
5. *Blocks do not interact.*  The corner that another vertex w takes is within sqrt 2 of w, and
   the nodes of v's block are within 2 sqrt 2 of v; |vw| >= 8 > 3 sqrt 2 on the sheet and along an
   edge. So in substep 1 only v moves nodes of its block, or keeps their choosers from choosing.
   Proved.
6. *Ties.*  A crossing at exactly tau counts for both sections; the nearer of two rays' q-vertices
   at one grid vertex is not computed but tried both ways.  A tie between row and column of one
   ray needs |m| = 1, which the frame refuses, as it refuses axis-parallel edges, vertices on grid
   lines and edges through grid vertices on kept lines.  Proved.
7. *Symmetry.*  The rules commute with quarter turns: so e goes up.  A reflection exchanges e and
   f, and the rules do not tell them apart, nor (but for ties, 6) rows from columns: so x <= 1/2
   for f up, x + y <= 1 for f left, y <= 1/2 for f down, x <= y for f right.  Proved for the rules
   as written; tests compare the block program with the package's on random and threshold inputs.

**The shipped rule.**  A second certificate shows that what `bern_exact.boundary.corners` demands
can always be had: a corner with all angles of at most 135 degrees, all heights of at least
tau/sqrt 2 and all sides of faces at least tau long.  So the rule, which takes the nearest such
corner, always finds one, and never falls back.  All three bounds are attained: at a q-vertex that
is tau from a grid vertex, on a ray of 45 degrees.  No closed box could show them; but sections do,
exactly, at every place where they are attained (`sections`), and what is left over is strict.
Diagonals of faces are not asked about: as sides of triangles they are longer than the heights.

A third certificate shows how bad the closest corner can be.  Faces whose vertices are all grid
vertices are left out: squares of side 1, or halves.

**Smaller thresholds** (`--max-angle`).  For all tau from `thresholds.LEAST` to 1/8 at once some
corner leaves faces with triangulations within 135 degrees (`thresholds`; why a leaf can be good for
an interval of tau is said in `replay`).  Steps 1 to 7 hold for every tau <= 1/8: what they compare
is 1/8 at most.  Where no corner kept heights and sides too, the package would take such a corner.

**What is not claimed.**  All is for blocks of 3 x 3 squares.  Below `thresholds.LEAST` nothing is
claimed, and below 1/8 nothing of heights, of sides, and of how many q-vertices choose one grid
vertex: what the package asserts of them the checkers would report.
"""

from collections.abc import Iterator

from proofs.lemma_2.statements import CHAPTER
from proofs.lemma_2.statements import statements as _for_an_eighth
from proofs.lemma_2.thresholds import statements as _below_an_eighth
from proofs.statement import Statement

__all__ = ["CHAPTER", "statements"]


def statements(full: bool = False) -> Iterator[Statement]:
    """The chapter, the certificates for tau = 1/8, and those for smaller thresholds."""
    yield from _for_an_eighth(full)
    yield from _below_an_eighth(full)
