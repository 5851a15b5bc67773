"""Draws the first frame of a run with marks beside the bodies:
python3 -m percuss.preview.draw_marks FIELDS LAYERS.npz FOLDER AZIMUTH:ELEVATION ...

It is a program of its own because VTK ends a program that it cannot draw in (preview/page.py starts it). LAYERS.npz has
an array of places a layer, called by its number, and `layers`, JSON of what each is."""

import argparse
import json
import os
import sys
from typing import Any

import numpy as np
import vtkmodules.vtkRenderingFreeType  # noqa: F401
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401
from PIL import Image
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper, vtkRenderer

from percuss.display import open_display
from percuss.render import pictures
from percuss.render.coloring import Coloring
from percuss.render.colors import rgb
from percuss.render.scene import Scene, Surface
from percuss.render.selection import choose_elements
from percuss.render.skin import Skin
from percuss.results.arrays import Array
from percuss.results.fields import Fields

SIZE = (960, 540)
POINT, OVERLAP_POINT, LINE = 5, 9, 1.6  # pixels


def main() -> None:
    fields, layers = Fields(sys.argv[1]), read_layers(sys.argv[2])
    with open_display():
        for number, view in enumerate(sys.argv[4:]):
            picture = draw(fields, layers, tuple(map(float, view.split(":"))))
            picture.save(os.path.join(sys.argv[3], f"view_{number}.png"))


def read_layers(path: str) -> list[dict[str, Any]]:
    with np.load(path) as file:
        layers = json.loads(str(file["layers"]))
        return [dict(layer, places=file[str(number)]) for number, layer in enumerate(layers)]


def draw(fields: Fields, layers: list[dict[str, Any]], view: tuple[float, ...]) -> Any:
    arguments = argparse.Namespace(field="part", part_colors=True, range=None, map="heat", view=view, look_at=None,
                                   zoom=1.0, focus="start", part=None, clip=None, no_walls=False, size=SIZE,
                                   edges="auto", fast=True)
    kept, cut = choose_elements(fields, arguments)
    surface = Surface(Skin(fields.hexahedra, kept, cut))
    coloring = Coloring(fields, arguments, kept, [0])
    ends = [np.empty((0, 3)), *(np.reshape(layer["places"], (-1, 3)) for layer in layers if layer["kind"] == "arrows")]
    scene, _ = pictures.make_scene(fields, arguments, surface, coloring, [0], np.concatenate(ends))
    surface.move(fields.positions(0))
    surface.color(*coloring.choose_values(0, surface.skin))
    top = add_top(scene)
    for layer in layers:
        if layer["shown"] and len(layer["places"]) and layer["kind"] != "plates":
            (top if layer["on_top"] else scene.renderer).AddActor(make_actor(layer))
    return Image.fromarray(scene.draw()).resize(SIZE, Image.Resampling.LANCZOS)


def add_top(scene: Scene) -> Any:
    """A renderer in front of the scene's: what it draws is never hidden."""
    top = vtkRenderer()
    top.SetLayer(1)
    top.SetActiveCamera(scene.renderer.GetActiveCamera())
    scene.window.SetNumberOfLayers(2)
    scene.window.AddRenderer(top)
    return top


def make_actor(layer: dict[str, Any]) -> Any:
    places = np.asarray(layer["places"], dtype=float)
    if layer["kind"] == "arrows":
        places = with_heads(places)
    flat = np.ascontiguousarray(places.reshape(-1, 3))
    points, cells, mesh = vtkPoints(), vtkCellArray(), vtkPolyData()
    points.SetData(numpy_to_vtk(flat, deep=1))
    mesh.SetPoints(points)
    size = 1 if layer["kind"] == "points" else 2
    for start in range(0, len(flat), size):
        cells.InsertNextCell(size)
        for corner in range(size):
            cells.InsertCellPoint(start + corner)
    (mesh.SetVerts if size == 1 else mesh.SetLines)(cells)
    mapper = vtkPolyDataMapper()
    mapper.SetInputData(mesh)
    mapper.SetResolveCoincidentTopologyToPolygonOffset()
    mapper.SetRelativeCoincidentTopologyPointOffsetParameter(-66)
    actor = vtkActor()
    actor.SetMapper(mapper)
    look = actor.GetProperty()
    look.SetColor(*rgb(layer["color"]))
    look.LightingOff()
    look.SetPointSize(2 * (OVERLAP_POINT if layer["on_top"] else POINT))  # of a picture that is reduced to half
    look.SetLineWidth(2 * LINE)
    if size == 1:
        look.RenderPointsAsSpheresOn()
    return actor


def with_heads(arrows: Array, share: float = 0.3, width: float = 0.11) -> Array:
    """[4 n or 5 n][2][3]: shafts and two strokes a head in each of two planes."""
    tails, tips = arrows[:, 0], arrows[:, 1]
    along = tips - tails
    length = np.linalg.norm(along, axis=1, keepdims=True)
    away = np.eye(3)[np.argmin(np.abs(along), axis=1)]
    first = np.cross(along, away)
    first *= length / np.maximum(np.linalg.norm(first, axis=1, keepdims=True), 1e-300)
    second = np.cross(along, first) / np.maximum(length, 1e-300)
    strokes = [np.stack([tips, tips - share * along + width * sign * side], axis=1) for side in (first, second)
               for sign in (1, -1)]
    return np.concatenate([arrows, *strokes])


if __name__ == "__main__":
    main()
