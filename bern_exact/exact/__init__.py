"""Exact ground: numbers, points, predicates, angles and similarities.

Imports nothing else of this project.  Every value is an integer
(`gmpy2.mpz`) or a rational (`gmpy2.mpq`); no float decides anything.
"""
