"""Writes fields of a percuss run in formats of other programs. percuss export --help says how."""

from __future__ import annotations

import argparse
import os
import re
import sys
from collections.abc import Iterator
from typing import TYPE_CHECKING, NoReturn

from percuss.help_format import HelpFormatter
from percuss.libraries import require
from percuss.terminal import fail as end
from percuss.terminal import join_signed

if TYPE_CHECKING:
    from percuss.export.selection import Selection
    from percuss.results.run import Run

FORMATS = ("vtu", "pvd", "exodus", "d3plot", "csv", "gltf")
NEEDS = ("numpy", "h5py")
WISHES = ("scipy",)  # of the format exodus
Files = Iterator[tuple[str, str | bytes]]  # their names and contents
EPILOG = """\
Formats, and what they write into DIR/export or the folder of --out:
  vtu      a file of VTK for each frame (ParaView, VisIt, PyVista)
  pvd      as vtu, with a list of the files and their times
  exodus   fields.e, Exodus II: all frames, parts as blocks with their names
           (ParaView, Cubit, SEACAS); needs SciPy
  d3plot   LS-DYNA's state database: d3plot, d3plot01 ... (LS-PrePost, META,
           Animator, lasso-python): parts by name, positions, velocities,
           stress, plastic strain, thickness, forces of beams, deletion
  csv      nodes and elements of each frame as tables
  gltf     fields.glb: the surface with its motion, for browsers, slides and
           Blender

Examples:
  percuss export ball --format d3plot
  percuss export ball --format pvd --frames 0..30:5 --field velocity
  percuss export ball --format gltf --field equivalent_plastic_strain

Exit codes:
  0    done
  2    a folder, a frame, a field or an option is wrong, or a library is missing
  4    a file cannot be written

Needs Python 3 with NumPy and h5py, exodus SciPy too:
scripts/install_dependencies --report installs them.
docs/export.md describes the formats.
"""


def parse_arguments(words: list[str]) -> argparse.Namespace:
    parser = argparse.ArgumentParser(
        prog="percuss export", epilog=EPILOG, formatter_class=HelpFormatter,
        description="Write the fields of a run in formats of other programs.")
    add = parser.add_argument
    add("dir", metavar="DIR", help="the output folder of a run, complete or under way")
    add("--format", choices=FORMATS, required=True, help="what is written")
    add("--frames", metavar="FRAMES", default="all", help="all, or numbers such as 0,5,-1 or 0..20:5 (default: all)")
    add("--field", dest="fields", metavar="NAMES",
        help="names of fields with commas between them (default: all; of gltf the one that colours show)")
    add("--from", dest="source", metavar="NAME", help="an entry of output.field_outputs (default: output.fields)")
    add("--out", metavar="FOLDER", help="where the files go (default: DIR/export)")
    add("-f", "--force", action="store_true",
        help="write over files that percuss export has not written; never over results of a run")
    return parser.parse_args(join_signed(words))


def fail(message: object, code: int = 2) -> NoReturn:
    end("export", message, code)


def note(text: str) -> None:
    from percuss.terminal import print_text

    print_text(f"export: {text}", sys.stderr)


def list_vtu(selection: Selection, stem: str, with_list: bool) -> Files:
    from percuss.export.vtk import write_pvd, write_vtu

    names = [f"{stem}_{frame:04}.vtu" for frame in selection.frames]
    for name, frame in zip(names, selection.frames):
        yield name, write_vtu(selection, frame)
    if with_list:
        yield f"{stem}.pvd", write_pvd([float(selection.fields.times[frame]) for frame in selection.frames], names)


def list_tables(selection: Selection, stem: str) -> Files:
    from percuss.export.tables import write_tables

    for frame in selection.frames:
        for what, text in write_tables(selection, frame).items():
            yield f"{stem}_{what}_{frame:04}.csv", text


def list_d3plot(selection: Selection, run: Run) -> Files:
    from percuss.export.d3plot import Database, describe

    database = Database(selection, run.history if run.has_history else None)
    for text in describe(database):
        note(text)
    yield "d3plot", database.write_geometry()
    yield from database.write_states()


def list_gltf(selection: Selection, stem: str, names: list[str] | None) -> Files:
    from percuss.export.gltf import write_glb

    if names and len(names) > 1:
        raise ValueError("the colours of gltf show one field: name one in --field")
    if len(selection.frames) > 60:
        note(f"{len(selection.frames)} frames are many for viewers of glTF: --frames "
             f"0..{selection.frames[-1]}:{len(selection.frames) // 30} takes fewer")
    yield f"{stem}.glb", write_glb(selection, names[0] if names else None)


def list_files(arguments: argparse.Namespace, selection: Selection, run: Run, names: list[str] | None) -> Files:
    """(name, content) of the files, one after the other."""
    stem = f"fields_{arguments.source}" if arguments.source else "fields"
    if arguments.format in ("vtu", "pvd"):
        return list_vtu(selection, stem, arguments.format == "pvd")
    if arguments.format == "csv":
        return list_tables(selection, stem)
    if arguments.format == "d3plot":
        return list_d3plot(selection, run)
    if arguments.format == "gltf":
        return list_gltf(selection, stem, names)
    from percuss.export.exodus import write_exodus

    return iter([(f"{stem}.e", write_exodus(selection))])


def remove_earlier_states(folder: str, force: bool) -> bool:
    """Removes the files of an earlier d3plot of this tool: readers would take what is left for later states.
    Whether files of the family may be replaced."""
    from percuss.files import check_target

    geometry = os.path.join(folder, "d3plot")
    check_target(geometry, "export", force)
    if not os.path.exists(geometry):
        return force
    for name in os.listdir(folder):
        if re.fullmatch(r"d3plot\d{2,}", name):
            check_target(os.path.join(folder, name), "export", True)
            os.unlink(os.path.join(folder, name))
    return True


def export(arguments: argparse.Namespace) -> None:
    import percuss
    from percuss.export.selection import Selection
    from percuss.files import write_file
    from percuss.terminal import print_text

    run = percuss.Run(arguments.dir, arguments.source)
    names = [name.strip() for name in arguments.fields.split(",")] if arguments.fields else None
    selection = Selection(run.fields, arguments.frames, names)
    folder = arguments.out or os.path.join(run.folder, "export")
    os.makedirs(folder, exist_ok=True)
    force = remove_earlier_states(folder, arguments.force) if arguments.format == "d3plot" else arguments.force
    count = size = 0
    for name, content in list_files(arguments, selection, run, names):
        path = os.path.join(folder, name)
        write_file(path, content, "export", force)
        count, size = count + 1, size + os.path.getsize(path)
    if run.fields.walls.size or len(run.fields.walls_at(0)) or len(run.fields.round_walls_at(0)):
        note("rigid walls are not written")
    print_text(f"export: {path if count == 1 else f'{count} files in {folder}'} "
               f"({len(selection.frames)} frame{'s' * (len(selection.frames) > 1)}, {size / 1e6:.2g} MB)")


def main(words: list[str]) -> None:
    arguments = parse_arguments(words)
    require("exports need", (*NEEDS, *(WISHES if arguments.format == "exodus" else ())))
    import percuss

    try:
        export(arguments)
    except (percuss.NotResults, ValueError) as error:
        fail(error)
    except OSError as error:
        fail(f"cannot write the files ({error})", 4)
