"""Settings that every test shares."""

from hypothesis import settings

# No test may fail because a machine is slow.
settings.register_profile("exact", deadline=None, print_blob=True)
settings.load_profile("exact")
