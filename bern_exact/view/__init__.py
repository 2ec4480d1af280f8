"""Pictures, for people only.  Coordinates are rounded here, by integer arithmetic."""
