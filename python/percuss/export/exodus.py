"""Exodus II, as netCDF of 64-bit offsets, by SciPy: all frames in one file. Names of variables are those of the Exodus
II manual (Sandia report SAND92-2137)."""

import io
from collections.abc import Iterable
from typing import Any

import numpy as np

from percuss.results.arrays import Array
from percuss.results.fields import Fields

from ..files import make_mark
from .selection import Selection, name_components

BLOCKS = {12: ("HEX8", (0, 1, 2, 3, 4, 5, 6, 7)), 13: ("WEDGE6", (0, 2, 1, 3, 5, 4)), 14: ("PYRAMID5", (0, 1, 2, 3, 4)),
          10: ("TETRA4", (0, 1, 2, 3)), 9: ("SHELL4", (0, 1, 2, 3)), 5: ("SHELL3", (0, 1, 2)), 3: ("BEAM2", (0, 1))}
NAME = 128  # characters of a name, its end included


class _Block:
    """Elements of one part and one kind."""

    def __init__(self, number: int, name: str, kind: int, elements: Array) -> None:
        self.number, self.name, self.kind, self.elements = number, name, kind, elements


def _list_blocks(fields: Fields) -> list[_Block]:
    found: list[_Block] = []
    for part, name in enumerate(fields.part_names):
        kinds = np.unique(fields.kinds[fields.part == part])
        for kind in kinds:
            label = name if len(kinds) == 1 else f"{name}_{BLOCKS[kind][0].lower()}"
            found.append(_Block(len(found) + 1, label, int(kind),
                                np.flatnonzero((fields.part == part) & (fields.kinds == kind))))
    return found


def write_exodus(selection: Selection) -> bytes:
    """Bytes of the file."""
    from scipy.io import netcdf_file

    fields, blocks, stream = selection.fields, _list_blocks(selection.fields), io.BytesIO()
    file = netcdf_file(stream, "w", version=2)
    file.api_version = file.version = np.float32(5.03)
    file.writer = make_mark("export")
    file.floating_point_word_size, file.file_size, file.title = np.int32(8), np.int32(1), selection.title[:80]
    for name, size in (("time_step", None), ("len_string", 33), ("len_line", 81), ("len_name", NAME), ("four", 4),
                       ("num_dim", 3),
                       ("num_nodes", fields.nodes), ("num_elem", fields.elements), ("num_el_blk", len(blocks))):
        file.createDimension(name, size)
    _add_mesh(file, fields, blocks)
    _add_variables(file, selection, blocks)
    file.flush()
    return stream.getvalue()


def _add(file: Any, name: str, kind: str, dimensions: tuple[str, ...], values: Any) -> Any:
    variable = file.createVariable(name, kind, dimensions)
    variable[:] = values
    return variable


def _names(words: Iterable[str]) -> Array:
    """Texts as rows of characters."""
    return np.array([list(word.encode("ascii", "replace")[: NAME - 1].ljust(NAME, b"\0")) for word in words],
                    dtype="u1").view("S1")


def _add_mesh(file: Any, fields: Fields, blocks: list[_Block]) -> None:
    for axis, values in zip("xyz", fields.positions(0).T):
        _add(file, f"coord{axis}", "d", ("num_nodes",), values)
    _add(file, "coor_names", "c", ("num_dim", "len_name"), _names("xyz"))
    _add(file, "node_num_map", "i", ("num_nodes",), fields.node_ids)
    _add(file, "elem_num_map", "i", ("num_elem",),
         np.concatenate([fields.element_ids[block.elements] for block in blocks]))
    _add(file, "eb_status", "i", ("num_el_blk",), np.ones(len(blocks)))
    _add(file, "eb_prop1", "i", ("num_el_blk",), np.arange(1, len(blocks) + 1)).name = "ID"
    _add(file, "eb_names", "c", ("num_el_blk", "len_name"), _names(block.name for block in blocks))
    corners, offsets = fields.root["Connectivity"][:], fields.root["Offsets"][: fields.elements]
    for block in blocks:
        kind, places = BLOCKS[block.kind]
        file.createDimension(f"num_el_in_blk{block.number}", len(block.elements))
        file.createDimension(f"num_nod_per_el{block.number}", len(places))
        nodes = corners[offsets[block.elements][:, None] + np.array(places)] + 1
        size = (f"num_el_in_blk{block.number}", f"num_nod_per_el{block.number}")
        _add(file, f"connect{block.number}", "i", size, nodes).elem_type = kind


def _list_components(selection: Selection, place: str) -> list[tuple[str, str, int]]:
    """[(name of a variable, field, component)]"""
    found = []
    for name, where in selection.names.items():
        if where == place:
            values = np.asarray(selection.data(name, selection.frames[0]))
            width = 1 if values.ndim == 1 else values.shape[1]
            found += [(word, name, number) for number, word in enumerate(name_components(name, width))]
    return found


def _add_variables(file: Any, selection: Selection, blocks: list[_Block]) -> None:
    of_nodes, of_elements = (_list_components(selection, place) for place in ("node", "element"))
    times = file.createVariable("time_whole", "d", ("time_step",))
    for place, variables in (("nod", of_nodes), ("elem", of_elements)):
        if variables:
            file.createDimension(f"num_{place}_var", len(variables))
            _add(file, f"name_{place}_var", "c", (f"num_{place}_var", "len_name"),
                 _names(word for word, _, _ in variables))
    if of_elements:
        _add(file, "elem_var_tab", "i", ("num_el_blk", "num_elem_var"), np.ones((len(blocks), len(of_elements))))
    nodal = [file.createVariable(f"vals_nod_var{k}", "d", ("time_step", "num_nodes"))
             for k in range(1, len(of_nodes) + 1)]
    elemental = [
        [file.createVariable(f"vals_elem_var{k}eb{block.number}", "d", ("time_step", f"num_el_in_blk{block.number}"))
         for block in blocks] for k in range(1, len(of_elements) + 1)]
    for row, frame in enumerate(selection.frames):
        times[row] = selection.fields.times[frame]
        data = {name: np.asarray(selection.data(name, frame), dtype=float) for name in selection.names}
        data = {name: values.reshape(len(values), -1) for name, values in data.items()}
        for variable, (_, name, component) in zip(nodal, of_nodes):
            variable[row] = data[name][:, component]
        for by_block, (_, name, component) in zip(elemental, of_elements):
            for variable, block in zip(by_block, blocks):
                variable[row] = data[name][block.elements, component]
