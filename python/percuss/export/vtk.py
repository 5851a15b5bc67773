"""VTK's XML files: a .vtu for each frame, and a .pvd that lists them with their times. Data are appended, raw."""

from typing import Any

import numpy as np

from ..files import make_mark
from .selection import Selection

_TYPES = {"f4": "Float32", "f8": "Float64", "i4": "Int32", "i8": "Int64", "u1": "UInt8"}
_CORNERS = {12: 8, 13: 6, 14: 5, 10: 4, 9: 4, 5: 3, 3: 2}


def escape(text: str) -> str:
    for character, word in (("&", "&amp;"), ("<", "&lt;"), (">", "&gt;"), ('"', "&quot;")):
        text = text.replace(character, word)
    return text


class _Arrays:
    """Arrays at the end of a file: a header of eight bytes with the size, then the data."""

    def __init__(self) -> None:
        self.pieces, self.size = list[bytes](), 0

    def add(self, name: str, values: Any, components: int = 1) -> str:
        values = np.ascontiguousarray(values)
        values = values.astype("<" + values.dtype.str[1:])
        data = values.tobytes()
        element = (f'<DataArray type="{_TYPES[values.dtype.str[1:]]}" Name="{escape(name)}" '
                   f'NumberOfComponents="{components}" format="appended" offset="{self.size}"/>')
        self.pieces += [np.uint64(len(data)).tobytes(), data]
        self.size += 8 + len(data)
        return element


def write_vtu(selection: Selection, frame: int) -> bytes:
    """Bytes of a .vtu file. Tensors have VTK's six components, in the order xx, yy, zz, xy, yz, xz of fields.vtkhdf."""
    fields, arrays = selection.fields, _Arrays()
    points = arrays.add("Points", fields.positions(frame), 3)
    connectivity, kinds = fields.root["Connectivity"][:], fields.kinds
    ends = np.cumsum([_CORNERS[kind] for kind in kinds.tolist()]).astype(np.int64)
    cells = [arrays.add("connectivity", connectivity.astype(np.int64)), arrays.add("offsets", ends),
             arrays.add("types", kinds.astype(np.uint8))]
    of = {"node": [arrays.add("node_id", fields.node_ids.astype(np.int64))],
          "element": [arrays.add("element_id", fields.element_ids.astype(np.int64)),
                      arrays.add("part", fields.part.astype(np.int32))]}
    for name, place in selection.names.items():
        values = np.asarray(selection.data(name, frame))
        values = (values.astype(np.float32 if values.dtype == np.float32 else np.float64) if values.dtype.kind == "f"
                  else values.astype(np.int64))
        of[place].append(arrays.add(name, values, 1 if values.ndim == 1 else values.shape[1]))
    time = arrays.add("TimeValue", np.array([fields.times[frame]], dtype=float))
    head = (f'<?xml version="1.0"?>\n<!-- {make_mark("export")} -->\n'
            '<VTKFile type="UnstructuredGrid" version="1.0" byte_order="LittleEndian" header_type="UInt64">\n'
            f'<UnstructuredGrid>\n<FieldData>{time.replace("NumberOfComponents=", "NumberOfTuples=")}</FieldData>\n'
            f'<Piece NumberOfPoints="{fields.nodes}" NumberOfCells="{fields.elements}">\n<Points>{points}</Points>\n'
            f'<Cells>{"".join(cells)}</Cells>\n<PointData>{"".join(of["node"])}</PointData>\n'
            f'<CellData>{"".join(of["element"])}</CellData>\n</Piece>\n</UnstructuredGrid>\n'
            '<AppendedData encoding="raw">\n_')
    return b"".join([head.encode(), *arrays.pieces, b"\n</AppendedData>\n</VTKFile>\n"])


def write_pvd(times: list[float], files: list[str]) -> str:
    rows = "".join(f'<DataSet timestep="{float(time)!r}" file="{escape(file)}"/>\n' for time, file in zip(times, files))
    return (f'<?xml version="1.0"?>\n<!-- {make_mark("export")} -->\n<VTKFile type="Collection" version="0.1" '
            'byte_order="LittleEndian">\n'
            f"<Collection>\n{rows}</Collection>\n</VTKFile>\n")
