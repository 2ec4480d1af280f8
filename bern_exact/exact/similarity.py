"""Exact similarities of the plane: rational rotation, scaling, translation, and their inverses."""

from __future__ import annotations

from dataclasses import dataclass

from gmpy2 import gcd, is_square, isqrt, mpq, mpz

from bern_exact.exact.points import HPoint, reduced


@dataclass(frozen=True, slots=True)
class Similarity:
    """The map p -> (alpha p + tau) / delta of complex numbers, with integers throughout.

    Parameters
    ----------
    a, b : mpz
        alpha = a + b i: rotation and scaling together, not both zero.
    u, v : mpz
        tau = u + v i: the translation.
    d : mpz
        delta > 0, the common denominator.
    """

    a: mpz
    b: mpz
    u: mpz
    v: mpz
    d: mpz

    @staticmethod
    def of(alpha: tuple[mpq, mpq], tau: tuple[mpq, mpq]) -> Similarity:
        """The map p -> alpha p + tau for rational complex alpha and tau.

        >>> turn = Similarity.of((mpq(0), mpq(1)), (mpq(1, 2), mpq(0)))
        >>> turn.apply((mpz(1), mpz(0), mpz(1)))
        (mpz(1), mpz(2), mpz(2))
        """
        parts = [*alpha, *tau]
        d = mpz(1)
        for part in parts:
            d = d * part.denominator // gcd(d, part.denominator)
        a, b, u, v = (part.numerator * (d // part.denominator) for part in parts)
        return Similarity(a, b, u, v, d)

    @staticmethod
    def rotation(t: mpq) -> Similarity:
        """The rotation by the angle 2 arctan(t): ((1 - t^2)/(1 + t^2), 2 t/(1 + t^2))."""
        norm = 1 + t * t
        return Similarity.of(((1 - t * t) / norm, 2 * t / norm), (mpq(0), mpq(0)))

    def apply(self, p: HPoint) -> HPoint:
        """The image of a point."""
        x, y, w = p
        return reduced(
            self.a * x - self.b * y + self.u * w, self.b * x + self.a * y + self.v * w, self.d * w
        )

    def inverse(self) -> Similarity:
        """The inverse map, exactly."""
        norm = self.a * self.a + self.b * self.b
        u = -(self.a * self.u + self.b * self.v)
        v = -(self.a * self.v - self.b * self.u)
        shared = gcd(gcd(gcd(self.a * self.d, self.b * self.d), gcd(u, v)), norm)
        return Similarity(
            self.a * self.d // shared,
            -self.b * self.d // shared,
            u // shared,
            v // shared,
            norm // shared,
        )

    def then(self, after: Similarity) -> Similarity:
        """This map followed by another."""
        a = after.a * self.a - after.b * self.b
        b = after.b * self.a + after.a * self.b
        u = after.a * self.u - after.b * self.v + after.u * self.d
        v = after.b * self.u + after.a * self.v + after.v * self.d
        d = after.d * self.d
        shared = gcd(gcd(gcd(a, b), gcd(u, v)), d)
        return Similarity(a // shared, b // shared, u // shared, v // shared, d // shared)

    @property
    def squared_scale(self) -> mpq:
        """The factor by which squared lengths grow."""
        return mpq(self.a * self.a + self.b * self.b, self.d * self.d)

    @property
    def rotation_part(self) -> tuple[mpq, mpq] | None:
        """Cosine and sine of the rotation, or None if they are irrational.

        >>> Similarity.of((mpq(3), mpq(4)), (mpq(0), mpq(0))).rotation_part
        (mpq(3,5), mpq(4,5))
        >>> Similarity.of((mpq(1), mpq(1)), (mpq(0), mpq(0))).rotation_part is None
        True
        """
        squared = self.a * self.a + self.b * self.b
        if not is_square(squared):
            return None
        length = isqrt(squared)
        return mpq(self.a, length), mpq(self.b, length)
