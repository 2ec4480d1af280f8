"""Reading and writing files.  The format follows the file's suffix, or is named."""

from bern_exact.formats.mesh_files import (
    MESH_FORMATS,
    MESH_READERS,
    MESH_WRITERS,
    Written,
    format_of_mesh,
    read_array_mesh_file,
    read_mesh_file,
)
from bern_exact.formats.polygon_files import (
    POLYGON_FORMATS,
    POLYGON_WRITERS,
    read_instance_file,
    read_polygon_file,
)

__all__ = [
    "MESH_FORMATS",
    "MESH_READERS",
    "MESH_WRITERS",
    "POLYGON_FORMATS",
    "POLYGON_WRITERS",
    "Written",
    "format_of_mesh",
    "read_array_mesh_file",
    "read_instance_file",
    "read_mesh_file",
    "read_polygon_file",
]
