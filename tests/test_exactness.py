"""No float decides anything: what a look at the source can tell.

It sees float and complex literals, `float`, `complex`, `round`, the modules
`math`, `cmath`, `decimal`, `random` and numpy, a `/` between int literals or
with `len()`, `int()` and the like on either side, `assert`, bare `except:`
and bare exceptions.  It lets `1 / q` pass, which is exact for an mpq, and
cannot see that a name is bound to an int.  There the types help in part:
`typings/gmpy2` knows no `/` between mpz, so mypy refuses it.
"""

from __future__ import annotations

import ast
from collections.abc import Callable, Iterable, Iterator

import pytest

from tests.source import Module, found, modules

# Path -> why numbers may be rounded there.  Everything here is shown to people and decides nothing.
DISPLAY: dict[str, str] = {}

# Path -> the proved bound by which a float there may decide, and what decides beyond it.
FILTERS: dict[str, str] = {
    "plane/array_mesh.py": "doubles next to exact coordinates, within 2^-52 of them",
    "plane/text_points.py": "the same, of numbers that are still text",
    "oracle/filters.py": "balls that hold the exact value: proofs/float_filter.py; then integers",
    "oracle/estimates.py": "the same balls, of triangles",
}

# Path -> the modules named below that it may import, with the reason.
MODULES_ALLOWED: dict[str, dict[str, str]] = {
    "corpus/bad.py": {"random": "integers from a seed"},
    "corpus/convex.py": {"random": "integers from a seed"},
    "oracle/defects/__init__.py": {"random": "integers from a seed"},
    "oracle/defects/sound.py": {"random": "integers from a seed"},
    "corpus/convex_families.py": {"random": "integers from a seed"},
    "corpus/draws.py": {"random": "integers from a seed"},
    "corpus/extreme.py": {"random": "integers from a seed"},
    "corpus/families.py": {"random": "integers from a seed"},
    "corpus/family.py": {"random": "integers from a seed"},
    "corpus/holes.py": {"random": "integers from a seed"},
    "corpus/near_misses.py": {"random": "integers from a seed"},
    "corpus/over_the_grid.py": {"random": "integers from a seed"},
    "corpus/random_polygons.py": {"random": "integers from a seed"},
    "corpus/shapes.py": {"random": "integers from a seed"},
    "corpus/slender.py": {"random": "integers from a seed"},
    "corpus/special.py": {"random": "integers from a seed"},
    "plane/array_mesh.py": {"numpy": "doubles that filter, indices"},
    "oracle/arguments.py": {
        "numpy": "arrays as users have them",
        "decimal": "decimals as users have them",
    },
    "oracle/boundary_rings.py": {"numpy": "indices"},
    "formats/token_text.py": {"numpy": "words of large files; doubles nearest to decimals"},
    "formats/triangle_mesh.py": {"numpy": "rows of words, indices"},
    "formats/triangle_poly.py": {"numpy": "indices"},
    "formats/off.py": {"numpy": "rows of words, indices"},
    "formats/cursor.py": {"numpy": "words, by number"},
    "formats/msh.py": {"numpy": "rows of words, indices"},
    "formats/vtk.py": {"numpy": "indices"},
    "formats/vtk_cells.py": {"numpy": "indices"},
    "formats/vtu.py": {"numpy": "words, by number"},
    "formats/meshio_files.py": {"numpy": "meshio's arrays of doubles, each exactly"},
    "formats/obj.py": {"numpy": "rows of words, indices"},
    "plane/text_points.py": {"numpy": "doubles that filter"},
    "formats/mesh_json.py": {"numpy": "indices"},
    "oracle/filters.py": {"numpy": "doubles that filter"},
    "oracle/estimates.py": {"numpy": "doubles that filter"},
    "oracle/incidence.py": {"numpy": "sorting"},
    "oracle/lazy_points.py": {"numpy": "sorting"},
    "oracle/filtered.py": {"numpy": "doubles compared with bounds, on the safe side"},
}

# Path -> how long it may be, for files that are longer than others.
LONG = {"oracle/judge.py": 442}  # the trusted file must stand alone, reading and all

INEXACT_MODULES = {"math", "cmath", "decimal", "random", "numpy", "statistics"}
INEXACT_CALLS = {"float", "complex", "round"}
INT_CALLS = {"len", "int", "bit_length", "ord"}
MOST_LINES = 400

MODULES = modules()


def line(node: ast.AST) -> str:
    return f"line {getattr(node, 'lineno', '?')}: {ast.unparse(node)}"


def called(node: ast.AST) -> str | None:
    """The name of what a call calls, the last part of a dotted one."""
    if not isinstance(node, ast.Call):
        return None
    match node.func:
        case ast.Name(name) | ast.Attribute(attr=name):
            return name
    return None


def is_plainly_int(node: ast.expr) -> bool:
    """Is this an int whatever the names in it are bound to?"""
    match node:
        case ast.Constant(value):
            return isinstance(value, int)
        case ast.UnaryOp(operand=operand):
            return is_plainly_int(operand)
        case ast.BinOp(left, _, right):
            return is_plainly_int(left) and is_plainly_int(right)
    return called(node) in INT_CALLS


def is_exact_division(node: ast.BinOp) -> bool:
    """Can this `/` be one of rationals?  An int literal on one side needs an mpq on the other."""
    if {called(node.left), called(node.right)} & INT_CALLS:
        return False
    return not (is_plainly_int(node.left) and is_plainly_int(node.right))


def inexact(module: Module) -> Iterator[str]:
    """Everything in a module that makes or handles a float."""
    for node in ast.walk(module.tree):
        if isinstance(node, ast.Constant) and isinstance(node.value, float | complex):
            yield line(node)
        elif isinstance(node, ast.Call) and isinstance(node.func, ast.Name):
            if node.func.id in INEXACT_CALLS:
                yield line(node)
        elif (
            isinstance(node, ast.BinOp)
            and isinstance(node.op, ast.Div)
            and not is_exact_division(node)
        ):
            yield line(node)


def imported_roots(tree: ast.AST) -> Iterator[str]:
    for node in ast.walk(tree):
        if isinstance(node, ast.Import):
            yield from (alias.name.split(".")[0] for alias in node.names)
        elif isinstance(node, ast.ImportFrom) and not node.level:
            yield (node.module or "").split(".")[0]


def inexact_imports(module: Module) -> set[str]:
    """The modules that make floats, or may, and are not allowed here."""
    return set(imported_roots(module.tree)) & INEXACT_MODULES - set(
        MODULES_ALLOWED.get(module.path, {})
    )


def assertions(module: Module) -> Iterator[str]:
    """Every `assert`."""
    return (line(node) for node in ast.walk(module.tree) if isinstance(node, ast.Assert))


def nameless_exceptions(module: Module) -> Iterator[str]:
    """Every bare `except:`, and every `raise Exception`."""
    for node in ast.walk(module.tree):
        if isinstance(node, ast.ExceptHandler) and node.type is None:
            yield f"bare except, {line(node)}"
        elif isinstance(node, ast.Raise) and node.exc is not None:
            raised = node.exc.func if isinstance(node.exc, ast.Call) else node.exc
            if ast.unparse(raised) in {"Exception", "BaseException"}:
                yield line(node)


def excess(module: Module) -> list[str]:
    """The length of a file that is too long."""
    lines = module.text.count("\n")
    return [f"{lines} lines"] if lines > LONG.get(module.path, MOST_LINES) else []


def test_no_float_is_made() -> None:
    assert found(inexact, [m for m in MODULES if m.path not in DISPLAY | FILTERS]) == {}


@pytest.mark.parametrize("look", [inexact_imports, assertions, nameless_exceptions, excess])
def test_nothing_is_found(look: Callable[[Module], Iterable[str]]) -> None:
    assert found(look) == {}


@pytest.mark.parametrize(
    ("look", "text"),
    [
        (inexact_imports, "import math"),
        (inexact_imports, "from numpy import array"),
        (assertions, "def f(x):\n    assert x"),
        (nameless_exceptions, "try:\n    f()\nexcept:\n    pass"),
        (nameless_exceptions, "raise Exception('no')"),
        (excess, "\n" * (MOST_LINES + 1)),
    ],
)
def test_each_look_finds(look: Callable[[Module], Iterable[str]], text: str) -> None:
    module = Module("m", "m.py", text, ast.parse(text))
    assert list(found(look, [module])) == ["m.py"]


def test_the_lists_of_exceptions_are_up_to_date() -> None:
    paths = {m.path for m in MODULES}
    assert set(DISPLAY) | set(FILTERS) | set(MODULES_ALLOWED) | set(LONG) <= paths


@pytest.mark.parametrize(
    "text", ["x = 0.5", "x = float(y)", "x = len(a) / k", "x = 1 / 3", "x = (1 + 2) / -4"]
)
def test_the_look_at_the_source_finds(text: str) -> None:
    assert list(inexact(Module("m", "m.py", text, ast.parse(text))))


@pytest.mark.parametrize("text", ["x = a / b", "x = mpq(1) / 3", "x = 7 // 2", "x = '0.5'"])
def test_the_look_at_the_source_lets_pass(text: str) -> None:
    assert not list(inexact(Module("m", "m.py", text, ast.parse(text))))
