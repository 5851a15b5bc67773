"""The mesh as a keyword file with commas, which percuss reads: numbers are the same doubles, ids the user's."""

from collections.abc import Iterator
from itertools import chain, islice

from percuss.files import write_file

from .deck_text import format_number
from .model import Model
from .solids import OF_EIGHT

PER_LINE = 8


def write_mesh(model: Model, path: str) -> None:
    """Writes nodes of elements, elements by part, and sets."""
    lines = chain(list_nodes(model), list_blocks(model), list_sets(model), ["*END"])
    write_file(path, (line + "\n" for line in lines), "import", force=True)


def list_nodes(model: Model) -> Iterator[str]:
    yield "*KEYWORD"
    yield "*NODE"
    used = model.used_nodes()
    for id, x in model.nodes.items():
        if id in used:
            yield f"{id},{format_number(x[0])},{format_number(x[1])},{format_number(x[2])}"


def list_blocks(model: Model) -> Iterator[str]:
    for block in model.blocks:
        yield from ("*PART", block.name, f"{block.id},")
        shells = "*ELEMENT_SHELL_THICKNESS" if block.thicknesses else "*ELEMENT_SHELL"
        kinds = (("*ELEMENT_SOLID", block.solids, 8), (shells, block.shells, 4), ("*ELEMENT_BEAM", block.beams, 2))
        for keyword, elements, count in kinds:
            if elements:
                yield keyword
            for id, corners in elements:
                if count == 8 and len(corners) == 10:
                    yield from (f"{id},{block.id},", ",".join(map(str, corners)))
                    continue
                nodes = (tuple(corners[i] for i in OF_EIGHT[len(corners)]) if count == 8
                         else corners + corners[-1:] * (count - len(corners)))
                yield f"{id},{block.id},{','.join(map(str, nodes))}"
                if keyword == "*ELEMENT_SHELL_THICKNESS":
                    yield ",".join([format_number(block.thicknesses[id])] * 4)


def list_sets(model: Model) -> Iterator[str]:
    """Sets number themselves from 1; percuss knows them by their titles."""
    number = 0
    for keyword, sets in (("*SET_NODE_LIST_TITLE", model.node_sets), ("*SET_PART_LIST_TITLE", model.block_sets)):
        for name, ids in sets.items():
            number += 1
            yield from (keyword, name, f"{number},")
            yield from split_ids(ids)
    for name, (kind, ids) in model.element_sets.items():
        number += 1
        yield from (f"*SET_{kind}_LIST_TITLE", name, f"{number},")
        yield from split_ids(ids)
    for name, faces in model.side_sets.items():
        number += 1
        yield from ("*SET_SEGMENT_TITLE", name, f"{number},")
        for face in faces:
            yield ",".join(map(str, face + face[-1:] * (4 - len(face))))


def split_ids(ids: list[int]) -> Iterator[str]:
    rest = iter(ids)
    while line := list(islice(rest, PER_LINE)):
        yield ",".join(map(str, line)) + ("," if len(line) == 1 else "")
